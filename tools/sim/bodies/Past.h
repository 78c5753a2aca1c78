// SPDX-License-Identifier: Apache-2.0
// Where robots and ball were in the last ticks: all that an image shows of them, since its exposure
// takes 4.2 ticks and a late image is up to 8.4 older. A copy lets images be rendered while time
// goes on.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tools/sim/bodies/Bodies.h"

namespace kelpie::sim {

class Past {
 public:
  // The bodies as they are at that tick, the one after the last.
  void remember(std::uint32_t tick, const Bodies& bodies);
  // No image shows the way of a robot that is carried.
  void carry(std::size_t robot, const Pose2& pose);

  const std::vector<BodyPlace>& robotsNow() const { return at(last_).robots; }
  const Ball& ballNow() const { return at(last_).ball; }
  // Between two ticks; before the oldest and after the last, at that one.
  BodyPlace place(std::size_t robot, double ticks) const;
  Point2<Field> ball(double ticks) const;

 private:
  static constexpr std::size_t kTicks = 16;
  struct Moment {
    std::vector<BodyPlace> robots;
    Ball ball;
  };
  const Moment& at(std::int64_t tick) const;

  std::array<Moment, kTicks> moments_;
  std::int64_t last_ = 0;
};

}  // namespace kelpie::sim
