// SPDX-License-Identifier: Apache-2.0
// A robot on the field with a true pose, and the noisy percepts and odometry it would have. The
// truth uses its own trigonometry (std::) and geometry, not the code under test.
#pragma once

#include <cmath>

#include "gps/Localiser.h"
#include "robot/core/Random.h"

namespace kelpie::gps {

struct Truth {
  double x = 180.0;
  double y = 200.0;
  double heading = maths::kPi / 2;
};

// rad, of a head that looks from side to side in two seconds.
inline double panAt(int frame) { return 1.2 * std::sin(2.0 * maths::kPi * frame / 60.0); }

class SimulatedRobot {
 public:
  explicit SimulatedRobot(Truth start, std::uint64_t seed = 1) : truth(start), random_(seed) {
    params.field = *body::fieldDescription("2006");
    input.elapsed = kFrameSeconds;
  }

  // Walks one frame in small steps: speeds in cm and rad per frame.
  void walk(double forward, double left, double turn) {
    constexpr int kSteps = 20;
    for (int i = 0; i < kSteps; ++i) {
      truth.heading += turn / kSteps;
      truth.x += (forward * std::cos(truth.heading) - left * std::sin(truth.heading)) / kSteps;
      truth.y += (forward * std::sin(truth.heading) + left * std::cos(truth.heading)) / kSteps;
    }
    input.odometry = {forward, left, Angle::rad(turn)};
  }

  // What the landmark looks like from the true pose, with 6 % and 2 deg of noise when noisy.
  LandmarkPercept look(const body::Landmark& landmark, bool noisy = true) {
    const double dx = landmark.position.x - truth.x;
    const double dy = landmark.position.y - truth.y;
    const double r = std::sqrt(dx * dx + dy * dy);
    LandmarkPercept p;
    p.kind = landmark.kind;
    p.distance = r * (noisy ? random_.gaussian(1.0, 0.06) : 1.0);
    p.heading = Angle::rad(std::atan2(dy, dx) - truth.heading +
                           (noisy ? random_.gaussian(0.0, 2.0 * maths::kPi / 180.0) : 0.0));
    p.distanceVariance = maths::square(0.06 * r) + 1.0;
    p.headingVariance = maths::square(2.0 * maths::kPi / 180.0);
    return p;
  }

  // All landmarks within 28 deg of the pan direction, as the camera would see them.
  void lookAround(double pan) {
    percepts.landmarks.clear();
    for (const body::Landmark& landmark : body::landmarksFor(params.field, input.game.team)) {
      const LandmarkPercept p = look(landmark);
      if ((p.heading - Angle::rad(pan)).abs().deg() < 28.0) percepts.landmarks.push_back(p);
    }
  }

  // Turns a share of the landmarks in sight to where they are not.
  void falsify(double share, Random& random) {
    for (LandmarkPercept& p : percepts.landmarks)
      if (random.chance(share)) p.heading = p.heading + Angle::deg(random.uniform(20.0, 340.0));
  }

  // Painted lines within 28 deg of the pan direction up to 250 cm, as vision's grid would find
  // them: 3 % and 1 deg of noise a point, and errors of the camera that all points of a frame
  // share.
  void lookAtLines(double pan) {
    percepts.linePoints.clear();
    const double scale = random_.gaussian(1.0, 0.015);
    const double turn = random_.gaussian(0.0, 0.005);
    for (const body::FieldLine& line : params.field.lines) {
      const Point2<Field> way = line.end - line.start;
      const double length = std::hypot(way.x, way.y);
      for (double at = random_.uniform(0.0, 10.0); at < length; at += 10.0)
        seePoint(line.start + way * (at / length), pan, scale, turn);
    }
  }

  WorldModel step() {
    input.frame += 1;
    input.time = TimeUs::fromSeconds(input.frame * kFrameSeconds);
    return gps::step(GpsIn{input, percepts}, params, state);
  }

  double error(const WorldModel& world) const {
    return std::hypot(world.pose.position.x - truth.x, world.pose.position.y - truth.y);
  }
  double headingError(const WorldModel& world) const {
    return (world.pose.heading - Angle::rad(truth.heading)).abs().deg();
  }

  Truth truth;
  FrameInput input;
  Percepts percepts;
  GpsParams params;
  GpsState state;

 private:
  void seePoint(Point2<Field> place, double pan, double scale, double turn) {
    const double dx = place.x - truth.x;
    const double dy = place.y - truth.y;
    const double r = std::sqrt(dx * dx + dy * dy);
    const double bearing = std::atan2(dy, dx) - truth.heading;
    const double off = Angle::rad(bearing - pan).abs().deg();
    if (r < 25.0 || r > 250.0 || off > 28.0) return;
    // Fewer far away, where the grid's pixels lie farther apart than the lines are wide.
    if (!random_.chance(std::fmin(1.0, 60.0 / r))) return;
    LinePoint p;
    p.position = robotPolar(r * scale * random_.gaussian(1.0, 0.03),
                            Angle::rad(bearing + turn + random_.gaussian(0.0, 0.017)));
    p.weight = std::fmin(1.0, (350.0 - r) / 280.0);
    percepts.linePoints.push_back(p);
  }

  Random random_;
};

}  // namespace kelpie::gps
