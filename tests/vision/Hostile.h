// SPDX-License-Identifier: Apache-2.0
// Images and postures that no field shows, seeded: what vision must survive at a bounded cost.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "robot/core/Random.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Percepts.h"

namespace kelpie::vision {

enum class HostileKind : std::uint8_t {
  noise,      // every pixel any value
  patches,    // discs and boxes in the colours of the game
  stripes,    // in any direction, 1 to 20 px wide
  scene,      // a painted field with foreign blocks in it
  oneColour,  // nothing else
  chess,      // cells of 1 to 8 px: the most runs and blobs
  beacons,    // pink, blue and yellow bands over white, side by side
  balls,      // as many orange discs on green as there is room for
};
constexpr std::size_t kHostileKindCount = 8;
constexpr std::array<const char*, kHostileKindCount> kHostileNames = {
    "noise", "patches", "stripes", "scene", "oneColour", "chess", "beacons", "balls"};

struct HostileFrame {
  FrameInput input;
  BodyState body;
};

class HostileFrames {
 public:
  explicit HostileFrames(std::uint64_t seed);

  // Half of the postures are a robot's with any joints, stance and head rates within their ranges;
  // half are a camera in any place and direction, the horizon anywhere.
  void make(HostileKind kind, HostileFrame& frame);

 private:
  void drawImage(HostileKind kind, Image& image);
  void takePosture(HostileFrame& frame);

  Random random_;
  std::vector<std::unique_ptr<Image>> scenes_;  // painted on first use: that is slow
};

// A frame from any bytes, for a fuzzer: eight bytes of posture, one of noise, then runs of class
// colours (class, length), repeated to the image's end.
void frameFromBytes(const std::uint8_t* data, std::size_t size, HostileFrame& frame);

}  // namespace kelpie::vision
