// SPDX-License-Identifier: Apache-2.0
// The stage (StageXml.h) with everything put where it is, and pictures of it, drawn off screen by
// MuJoCo's renderer with OSMesa, which needs neither a screen nor a graphics card.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <set>
#include <vector>

#include "robot/body/FieldDescription.h"
#include "robot/core/Expected.h"
#include "robot/core/types/FrameInput.h"
#include "tools/broadcast/StageXml.h"
#include "tools/broadcast/View.h"

namespace kelpie::broadcast {

// One robot on the stage: where it really is and how its joints stand.
struct Actor {
  TeamColour team = TeamColour::red;
  int player = 1;
  Pose2 pose;  // on the red team's field
  Stance stance;
  JointAngles joints;
};

struct Tableau {
  std::vector<Actor> actors;
  Point2<Field> ball;
  double ballHeight = body::kBallRadius;  // of its middle, cm
  bool ballThere = false;
};

// For a third of what the renderer's own smoothing takes.
constexpr double kFilmSharpness = 1.2;
constexpr double kStillSharpness = 2.5;

class Stage {
 public:
  // Of these robots alone. An error where there is no OSMesa or no memory. `sharpness`: the picture
  // is drawn so many times larger and made smaller again, which softens its edges.
  static Expected<Stage> build(const body::FieldDescription& field, const std::set<Player>& players,
                               cv::Size size, double sharpness = kFilmSharpness);
  Stage(Stage&&) noexcept;
  Stage& operator=(Stage&&) noexcept;
  ~Stage();

  cv::Size size() const;
  // Whoever is not in it is not seen.
  void put(const Tableau& tableau);
  // Blue, green, red.
  Expected<cv::Mat> shoot(const View& view);

 private:
  struct Studio;
  explicit Stage(std::unique_ptr<Studio> studio);
  std::unique_ptr<Studio> studio_;
};

}  // namespace kelpie::broadcast
