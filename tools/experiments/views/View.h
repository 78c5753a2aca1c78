// SPDX-License-Identifier: Apache-2.0
// A seeded random view of a field: what the robot's camera and joints deliver, and beside it what
// really was there. Every artefact is on: ring effect, colour shift of the robot, noise, blur,
// columns exposed one after the other while head and body turn, errors of the joints' sensors;
// people and things in the ball's and the goals' colours stand beyond the carpet.
#pragma once

#include <memory>
#include <vector>

#include "robot/body/FieldDescription.h"
#include "robot/core/types/FrameInput.h"
#include "tools/experiments/harness/Trials.h"
#include "tools/sim/bodies/Randomisation.h"
#include "tools/sim/camera/Camera.h"

namespace kelpie::experiments {

// What the robot knows of its body's tilt and roll (FrameInput::cameraTilt), deg.
struct TiltClaim {
  double sd = 0.0;  // of both; 0: of a level body that of settled play, else that of its start
  // Instead of it: an sd drawn between the two for each view, its log evenly, and from it how the
  // body leans beside what it would without.
  double drawnFrom = 0.0;
  double drawnTo = 0.0;
};

enum class ViewTarget { ball, landmark, robot, anywhere };

struct ViewParams {
  body::FieldDescription field = *body::fieldDescription("2006");
  sim::CameraParams camera;
  sim::RandomisationParams randomised;
  TiltClaim tilt;
  bool crowd = true;
  bool ball = true;
  double nearestBall = 20.0;  // cm, of those drawn before the robot
  double farthestBall = 360.0;
  int maxRobots = 4;
  double headTurning = 0.5;  // share of views in which the head turns
  double bodyTurning = 0.3;
};

// Truth: to compare with what vision says, never for vision.
struct View {
  ViewTarget target = ViewTarget::anywhere;
  Pose2 pose;                 // at the image's stamp
  CameraPose camera;          // in the middle of the exposure, with the robot's real lean and neck
  sim::FieldCamera eye;       // the same on the field, with its real lens
  sim::RandomisedRobot real;  // how the robot differs
  sim::ColumnCameras columns;
  Point2<Field> ball;
  std::vector<sim::RobotLook> robots;
  sim::Scene scene;
  sim::RobotCamera robotCamera;
  FrameInput input;  // what the agent gets
};

// Draws one view after the other; the same seed gives the same views. Keeps a crowd for 25 of them.
class ViewMaker {
 public:
  ViewMaker(const ViewParams& params, std::uint64_t seed);

  const View& next();

 private:
  void claimTilt();
  void placeThings();
  void placeRobots();
  void lookAt(Point3<Field> target);
  void standOnLegs();
  void turnAndRender();
  JointAngles inPlay(const HeadRate& rate);
  sim::FieldCamera exposed(const HeadRate& rate, double turn, double late);

  ViewParams params_;
  Random random_;
  Random looks_;  // of ring centres, uniforms and own legs: without them places stay what they are
  int made_ = 0;
  double brightness_ = 1.0;  // of the venue
  Random play_;              // of the neck's gears
  Random lean_;              // of the body's lean and what is claimed of it
  CameraTilt claimed_;
  std::uint64_t seed_;
  JointAngles joints_;  // of the motors
  JointAngles head_;    // of the head itself
  Stance stance_;
  View view_;
};

// Calls use(view) for one view a trial, in the randomised world that the request asks for.
template <class Use>
void eachView(ViewParams params, const Request& request, Use&& use) {
  params.randomised = cli::paramsOf(request.randomised);
  const auto maker = std::make_unique<ViewMaker>(params, request.seed);
  eachTrial(request, [&](const Trial&) { use(maker->next()); });
}

}  // namespace kelpie::experiments
