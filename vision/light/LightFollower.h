// SPDX-License-Identifier: Apache-2.0
// The colour table follows the light by small steps, so that no image sees two lights that differ
// by more: what the image showed decides which light the next ones are looked at in. A step takes
// kTableParts images, a part of the ring table each (vision/pixels/PixelTables.h).
#pragma once

#include "vision/light/LightEstimate.h"

namespace kelpie::vision {

// An image that is looked at while it is not is in two lights and tells neither.
inline bool isWhole(const CameraLight& light) { return light.partsToMake == 0; }

// Whether landmarks are overexposed: looked for in the other way once they are long not seen in
// this one.
void learnGlare(LandmarkLook seen, const LightParams& params, CameraLight& light);

// What an image showed, after it; the ring table must have been whole.
void learnLight(const SeenLight& seen, const LightParams& params, CameraLight& light);

}  // namespace kelpie::vision
