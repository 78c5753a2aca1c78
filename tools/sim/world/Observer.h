// SPDX-License-Identifier: Apache-2.0
// What a robot at a known pose would see and feel: percepts and odometry made from the truth with
// the errors that vision and the walk were measured to have (docs/results.md). Without images,
// so that thousands of seconds cost little. The truth uses the C library's trigonometry and a
// geometry of its own, not the code under test. Fails where errors hang together in other ways than
// these: nothing hides anything, and no percept is of another object than it says, unless falsify()
// makes it so.
#pragma once

#include <vector>

#include "robot/body/FieldDescription.h"
#include "robot/core/Random.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Percepts.h"

namespace kelpie::sim {

// Where a robot stands that nobody tells; cm and rad.
struct TruePose {
  double x = 180.0;
  double y = 200.0;
  double heading = maths::kPi / 2;

  Pose2 pose() const { return {{x, y}, Angle::rad(heading)}; }
};

// Of points on lines and carpet.
struct PointNoise {
  double share = 0.0;  // of the distance
  double turn = 0.0;   // rad
};

struct WalkNoise {
  double slip = 0.0;          // share of the way lost, mean over the steps
  double slipSd = 0.0;        // from step to step
  double headingPerCm = 0.0;  // rad for the root of a centimetre
};

struct BallNoise {
  double distanceShare = 0.023;
  double distanceBias = 0.006;
  double heading = 0.15;         // deg
  double walkingHeading = 0.70;  // deg more while walking
  bool oscillation = false;      // that part swings with the step instead of being drawn each frame
};

struct OpponentNoise {
  double reach = 200.0;  // cm, to which vision finds robots
  double recall = 0.82;  // and how often
  double share = 0.106;  // of the distance, twice: of a frame and for a second; 15 % together
  double heading = 2.0;  // deg
};

// Standard deviations where nothing else is said.
struct ObserverNoise {
  double halfView = 28.0;                             // deg to either side of the head's direction
  double landmarkShare = 0.06;                        // of the distance
  double landmarkHeading = 2.0 * maths::kPi / 180.0;  // rad
  double elevation = 0.2 * maths::kPi / 180.0;        // rad, of a landmark against its size
  PointNoise point{0.03, 0.017};                      // of one point
  PointNoise frame{0.015, 0.005};                     // shared by all points of a frame
  PointNoise standing;                                // shared by all frames while it stands
  WalkNoise walk;
  BallNoise ball;
  OpponentNoise opponents;
};

// rad, of a head that looks from side to side in two seconds.
double panAt(int frame);

class Observer {
 public:
  explicit Observer(TruePose start, std::uint64_t seed = 1, const ObserverNoise& errors = {});

  // Walks one frame in small steps: cm and rad a frame, as the odometry reports them.
  void walk(double forward, double left, double turn);

  // What the landmark looks like from the true pose.
  LandmarkPercept look(const body::Landmark& landmark, bool noisy = true);
  // All landmarks that a head panned that far (rad) would see.
  void lookAround(double pan);
  // Turns a share of the landmarks in sight to where they are not.
  void falsify(double share, Random& random);
  // The straight painted lines from 25 to 250 cm, as vision's grid would find them.
  void lookAtLines(double pan);
  // Beside them the circle, and carpet anywhere in view.
  void lookAtCircleAndCarpet(double pan);
  void lookAtBall(Point2<Field> ball);
  // In every frame the same ones in the same order: a part of their errors lasts for a second.
  void lookAtOpponents(const std::vector<Point2<Field>>& opponents, double pan);

  bool inView(Angle heading, double pan) const;
  Angle bearingOf(Point2<Field> place) const;

  TruePose truth;
  body::FieldDescription field = *body::fieldDescription("2006");
  ObserverNoise noise;
  FrameInput input;
  Percepts percepts;

 protected:
  // The errors of points that last while it stands are drawn again.
  void drawStandingErrors();

  Random random_;
  Random elevations_;  // of their own, so that all else stays as it was without them

 private:
  struct Polar {
    double range = 0.0;
    double bearing = 0.0;  // rad, from the robot's heading
  };
  struct SharedError {
    double scale = 1.0;
    double turn = 0.0;  // rad
  };
  struct Lasting {  // the part of an opponent's distance error that stays for a second
    double share = 0.0;
    double secondsLeft = 0.0;
  };
  Polar polarOf(Point2<Field> place) const;
  double slip();
  SharedError drawn(const PointNoise& sd);
  void addPoint(Point2<Field> place, LinePointKind kind, double pan);

  SharedError standing_;
  SharedError frame_;
  double slip_ = 0.0;
  double slipLeft_ = 0.0;  // s until the next step's is drawn
  double phase_ = 0.0;     // of the step
  bool walking_ = false;
  std::vector<Lasting> lasting_;
};

}  // namespace kelpie::sim
