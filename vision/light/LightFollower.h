// SPDX-License-Identifier: Apache-2.0
// The colour table follows the light: pixels are divided by what the light is over that which the
// table was made for. The division is in the ring table, so a pixel costs what it did; that table
// is made anew by quarters, an image each, and by small steps, so that no image sees two lights
// that differ by more.
#pragma once

#include "vision/light/LightEstimate.h"
#include "vision/pixels/PixelTables.h"

namespace kelpie::vision {

struct LightState {
  LightMemories memories;
  LightGains applied;   // what the ring table divides by, once it is whole
  ChannelBytes bytes;   // of `applied`
  int partsToMake = 0;  // of the ring table
};

// An image that is looked at while it is not is in two lights and tells neither.
inline bool isWhole(const LightState& state) { return state.partsToMake == 0; }

// Makes the ring table's next part, before an image is looked at.
void followLight(LightState& state, PixelTables& tables);
// What an image showed, after it; the ring table must have been whole.
void learnLight(const LightSightings& seen, const LightParams& params, LightState& state);

}  // namespace kelpie::vision
