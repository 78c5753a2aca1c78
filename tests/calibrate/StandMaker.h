// SPDX-License-Identifier: Apache-2.0
// What a robot logs that stands at a known place and looks round in stops: images of the simulated
// camera, taken with a body that is not as the robot's parameters say.
#pragma once

#include <cmath>
#include <memory>

#include "tools/calibrate/body/StandingLog.h"
#include "tools/sim/bodies/BodyShape.h"
#include "tools/sim/camera/Camera.h"
#include "tools/sim/camera/FieldCamera.h"
#include "vision/colour/VisionCalibration.h"

namespace kelpie::calibrate {

// The truth.
struct Stand {
  Pose2 place{{120.0, 200.0}, Angle::deg(70.0)};
  body::BodyParams body;
  double panPlay = 0.0;  // rad
  int ways = 3;          // from side to side
  bool landmarks = true;
};

inline sim::BodyPlace postureOf(const Stand& stand, int way, int stop) {
  const double neck = std::array<double, 3>{0.0, -18.0, -8.0}[static_cast<std::size_t>(way % 3)];
  const double down = std::array<double, 3>{2.0, 10.0, 16.0}[static_cast<std::size_t>(way % 3)];
  sim::BodyPlace place;
  place.pose = stand.place;
  place.stance = {10.0, Angle::deg(10.5), {}};
  const double pan = (way % 2 == 0 ? 1.0 : -1.0) * (18.0 * stop - 81.0);
  place.joints[Joint::neckTilt] = Angle::deg(neck);
  place.joints[Joint::headPan] = Angle::deg(pan);
  place.joints[Joint::headNod] = Angle::deg((10.5 - neck) * Angle::deg(pan).cos() - down);
  return place;
}

// The head stays behind a pan that has play.
inline CameraPose trueCameraOf(const Stand& stand, const sim::BodyPlace& place, int way) {
  const auto blind = std::make_unique<FrameInput>();
  blind->sensors.joints = place.joints;
  Angle& pan = blind->sensors.joints[Joint::headPan];
  pan = pan + Angle::rad((way % 2 == 0 ? -0.5 : 0.5) * stand.panPlay);
  blind->stance = place.stance;
  return body::step(*blind, stand.body).camera;
}

inline sim::Scene sceneOf(const Stand& stand, const body::FieldDescription& field) {
  sim::Scene scene = sim::fieldScene(field, 0);
  sim::setBall(scene, {-300.0, -300.0});
  if (!stand.landmarks) {
    scene.beacons.clear();
    scene.fixtures.clear();
    scene.goals = 0;
  }
  return scene;
}

inline StandingLog logOf(const Stand& stand) {
  constexpr int kStops = 10;
  StandingLog log;
  log.config = std::make_unique<agent::AgentConfig>();
  log.config->calibration = vision::nominalCalibration();
  Random random(7);
  sim::Camera camera({}, sim::randomCamera(random, {}));
  const sim::Scene scene = sceneOf(stand, log.config->field);
  const Lens& lens = stand.body.lens;
  for (int i = 0; i < stand.ways * kStops; ++i) {
    const sim::BodyPlace place = postureOf(stand, i / kStops, i % kStops);
    sim::ColumnCameras columns;
    columns.fill(sim::fieldCamera(stand.place, trueCameraOf(stand, place, i / kStops),
                                  {lens.focalLength, lens.principalX, lens.principalY}));
    StandingFrame frame;
    frame.stop = log.stops++;
    frame.pan = log.pans.size();
    frame.input.sensors.joints = place.joints;
    frame.head = {place.joints[Joint::neckTilt].rad(), place.joints[Joint::headPan].rad(),
                  place.joints[Joint::headNod].rad()};
    frame.input.stance = place.stance;
    camera.render(scene, columns, random, frame.input.image);
    log.pans.push_back(place.joints[Joint::headPan].rad());
    log.frames.push_back(std::move(frame));
  }
  return log;
}

}  // namespace kelpie::calibrate
