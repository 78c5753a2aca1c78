// SPDX-License-Identifier: Apache-2.0
// An image made again from its colour classes, one colour a class, so that vision runs unchanged on
// recorded class planes. loadCalibration("nominal", "none") gives back every class
// (tests/vision/pixels/PlaneImageTest.cpp). Lost: noise, shading and the share of a colour in the
// mixed pixels of an edge, hence places between pixels.
#pragma once

#include "robot/core/types/Image.h"
#include "vision/pixels/ClassPicture.h"

namespace kelpie::vision {

// Recorded logs are read with these: never change them. Nominal colours (facts-2005 section 3);
// none lies half-way between black and grey.
constexpr std::array<Yuv, kColourClassCount> kPlaneColours = {{{50, 128, 128},
                                                               {140, 181, 79},
                                                               {82, 121, 167},
                                                               {120, 160, 61},
                                                               {113, 193, 124},
                                                               {28, 126, 147},
                                                               {85, 165, 131},
                                                               {77, 103, 97},
                                                               {95, 127, 128},
                                                               {189, 124, 129},
                                                               {20, 126, 128}}};

// Every number in the plane must be one of a class.
void imageOf(const ClassPlane& plane, Image& image);

}  // namespace kelpie::vision
