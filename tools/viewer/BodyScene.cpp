// SPDX-License-Identifier: Apache-2.0
#include "tools/viewer/BodyScene.h"

#include "robot/body/Camera.h"
#include "robot/body/Ers7.h"
#include "robot/body/Legs.h"
#include "tools/sim/bodies/BodyShape.h"
#include "tools/viewer/Frames.h"
#include "tools/viewer/Shapes.h"

namespace kelpie::viewer {
namespace {

constexpr double kTrunkWidth = 8.0;  // cm, all of these
constexpr double kTrunkHeight = 7.0;
constexpr double kTrunkBeyond = 2.0;  // the shoulder axes, before and behind
constexpr double kLegThick = 3.0;
constexpr double kNeckThick = 3.0;
constexpr double kHeadWidth = 7.0;
constexpr double kHeadHeight = 6.0;

foxglove::Color shell() { return colour(0.92, 0.92, 0.95); }
foxglove::Color joints() { return colour(0.35, 0.35, 0.38); }

Point3<Robot> along(const Point3<Robot>& p, const CameraPose& camera, std::size_t axis,
                    double way) {
  const auto& a = camera.axes;
  return {p.x + way * a[axis], p.y + way * a[3 + axis], p.z + way * a[6 + axis]};
}

foxglove::Vector3 size(double ahead, double across, double up) {
  return inBody(Point3<Robot>{-across, ahead, up});
}

void addTrunk(foxglove::SceneEntity& to, const Stance& stance, const foxglove::Color& uniform) {
  const body::Lean lean(stance);
  const auto at = [&](double y, double z) { return body::robotFromTorso(lean, {0.0, y, z}); };
  const double middle = 0.5 * (kTrunkHeight - body::kChestDepth) - 1.0;
  const auto from = at(kTrunkBeyond, middle);
  const auto end = at(-body::kBodyLength - kTrunkBeyond, middle);
  const double length = body::kBodyLength + 2.0 * kTrunkBeyond;
  addBar(to, inBody(end), inBody(from), 1.0, uniform);
  *to.mutable_cubes(to.cubes_size() - 1)->mutable_size() = size(length, kTrunkWidth, kTrunkHeight);
}

void addLegs(foxglove::SceneEntity& to, const JointAngles& joints, const Stance& stance,
             const foxglove::Color& uniform) {
  const body::Lean lean(stance);
  for (std::size_t i = 0; i < kLegCount; ++i) {
    const auto leg = static_cast<LegId>(i);
    const bool right = leg == LegId::rightFront || leg == LegId::rightHind;
    const body::LegAngles angles = body::legAngles(joints, leg);
    const Point3<Torso> shoulder{(right ? 0.5 : -0.5) * body::kBodyWidth,
                                 body::isFront(leg) ? 0.0 : -body::kBodyLength, 0.0};
    const auto at = [&](const Point3<Torso>& p) { return inBody(body::robotFromTorso(lean, p)); };
    const auto knee = at(sim::kneePosition(leg, angles));
    addBar(to, at(shoulder), knee, metres(kLegThick), uniform);
    addBar(to, knee, at(body::footPosition(leg, angles)), metres(0.7 * kLegThick), shell());
  }
}

// From the neck's base over the axis of the nod to the plane of the camera.
void addHead(foxglove::SceneEntity& to, const JointAngles& angles, const Stance& stance) {
  constexpr std::size_t kDown = 1;
  constexpr std::size_t kAhead = 2;
  const CameraPose camera = body::cameraPose(angles, stance);
  const Point3<Robot> nod = along(along(camera.position, camera, kAhead, -body::kFaceLength),
                                  camera, kDown, -body::kCameraDrop);
  const Point3<Robot> neck =
      body::robotFromTorso(stance, {0.0, -body::kNeckBehindShoulder, body::kNeckAboveShoulder});
  addBar(to, inBody(neck), inBody(nod), metres(kNeckThick), joints());
  foxglove::Pose pose = poseAt(inBody(along(nod, camera, kAhead, 0.5 * body::kFaceLength)));
  *pose.mutable_orientation() = rotationOf(cameraAxesInBody(camera));
  foxglove::Vector3 box;  // x right, y down, z ahead, as the camera's axes
  box.set_x(metres(kHeadWidth));
  box.set_y(metres(kHeadHeight));
  box.set_z(metres(body::kFaceLength));
  addBox(to, pose, box, shell());
}

}  // namespace

foxglove::SceneEntity bodyScene(TimeUs time, const BodyLook& look, const JointAngles& joints,
                                const Stance& stance) {
  foxglove::SceneEntity scene = entity(time, look.frame, look.id);
  const foxglove::Color uniform = colourOf(look.team);
  addTrunk(scene, stance, uniform);
  addLegs(scene, joints, stance, uniform);
  addHead(scene, joints, stance);
  return scene;
}

JointAngles standingJoints(const Stance& stance) {
  JointAngles joints;
  for (std::size_t i = 0; i < kLegCount; ++i) {
    const auto leg = static_cast<LegId>(i);
    const bool right = leg == LegId::rightFront || leg == LegId::rightHind;
    const Point3<Robot> shoulder =
        body::robotFromTorso(stance, {(right ? 0.5 : -0.5) * body::kBodyWidth,
                                      body::isFront(leg) ? 0.0 : -body::kBodyLength, 0.0});
    const Point3<Robot> below{shoulder.x, shoulder.y, 0.0};
    body::setLegAngles(joints, leg,
                       body::reachFoot(leg, body::torsoFromRobot(stance, below)).angles);
  }
  return joints;
}

}  // namespace kelpie::viewer
