// SPDX-License-Identifier: Apache-2.0
// A frame's input with the image's colour classes in place of the image: 2 to 10 KB instead of
// 100 KB. Made by `kelpie compress`; robot/agent/log/FrameMessages.h makes an image of it again.
//
// The code: row by row from the top left, runs of equal class that may go on in the next row. A run
// of n pixels of class c is one byte 16 c + n - 1 for n = 1..15, or the byte 16 c + 15 and a second
// byte n - 16 for n = 16..271; longer runs follow each other.
#pragma once

#include "robot/core/Expected.h"
#include "robot/core/FixedVector.h"
#include "robot/core/types/FrameInput.h"

namespace kelpie {

// One class number a pixel, 0..15.
using ClassNumbers = Image::Plane;
// No run takes more bytes than it has pixels.
using PlaneCode = FixedVector<std::uint8_t, kImagePixels>;

void encodePlane(const ClassNumbers& plane, PlaneCode& code);

// Refuses a class number of `classes` or more and runs that make less or more than an image;
// `plane` then holds nothing of use.
Status decodePlane(const PlaneCode& code, std::uint8_t classes, ClassNumbers& plane);

// Its image is not part of the message.
struct PlaneFrame : FrameInput {
  PlaneCode plane;

  template <int = 0>
  static constexpr auto fields() {
    return withoutImage(FrameInput::fields(), field("plane", &PlaneFrame::plane));
  }
};

}  // namespace kelpie
