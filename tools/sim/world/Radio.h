// SPDX-License-Identifier: Apache-2.0
// The radio of the simulated world: a packet that one robot sends reaches every other one that is
// near enough, a moment later, unless it is lost. Both teams share the air, as at a match: who is
// meant is for the receiver to find out. Everything random comes from the seed, so that a match
// with losses replays.
#pragma once

#include <cstdint>
#include <vector>

#include "robot/core/Random.h"
#include "robot/core/Time.h"
#include "robot/core/types/Geometry.h"
#include "robot/core/types/Radio.h"

namespace kelpie::sim {

struct RadioParams {
  double loss = 0.02;     // share of packets that a receiver misses, each for itself [chosen]
  double delay = 0.01;    // s under way at least [chosen]
  double jitter = 0.03;   // s more at most, uniform [chosen]
  double range = 2000.0;  // cm; the field's diagonal is 650

  template <int = 0>
  static constexpr auto fields() {
    using P = RadioParams;
    return fieldList(field("loss", &P::loss, "", 0, 1), field("delay", &P::delay, "s", 0, 10),
                     field("jitter", &P::jitter, "s", 0, 10),
                     field("range", &P::range, "cm", 0, 1e5));
  }
};

class Radio {
 public:
  Radio(const RadioParams& params, std::size_t robots, std::uint64_t seed);
  // From now on that robot receives nothing; the others still hear it.
  void deafen(std::size_t robot) { deaf_[robot] = true; }

  // places: of all robots now.
  void send(std::size_t from, const RadioPacket& packet, TimeUs now,
            const std::vector<Point2<Field>>& places);
  // What has reached that robot by now, in the order of its arrival. What does not fit into one
  // answer is lost, as in a full receive buffer.
  RadioPackets take(std::size_t to, TimeUs now);
  // Whether any is on its way to that robot, or there.
  bool expects(std::size_t to) const { return !inboxes_[to].empty(); }

 private:
  struct Flying {
    TimeUs arrives;
    RadioPacket packet;
  };

  RadioParams params_;
  Random random_;
  std::vector<std::vector<Flying>> inboxes_;
  std::vector<bool> deaf_;
};

}  // namespace kelpie::sim
