// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/infrared/CarpetLog.h"

#include <algorithm>
#include <cmath>

#include "tools/calibrate/LoggedFrames.h"

namespace kelpie::calibrate {
namespace {

constexpr double kSettleSeconds = 0.5;    // until head and legs are where they were asked to be
constexpr std::size_t kMinReadings = 15;  // half a second of them
constexpr double kSamePose = 0.1;         // deg
// Ends of the sensor's range (robot/openr/Ers7Primitives.h), cm.
constexpr double kNearest = 5.0;
constexpr double kFarthest = 50.0;

struct Sum {
  HeadPose pose;
  std::size_t count = 0;
  double sum = 0.0;
  bool good = true;
};

Sum& sumOf(const HeadPose& pose, std::vector<Sum>& sums) {
  const auto known =
      std::find_if(sums.begin(), sums.end(), [&](const Sum& sum) { return sum.pose == pose; });
  if (known != sums.end()) return *known;
  sums.push_back({pose});
  return sums.back();
}

}  // namespace

bool HeadPose::operator==(const HeadPose& other) const {
  for (std::size_t i = 0; i < angles.size(); ++i)
    if (!(std::fabs(angles[i] - other.angles[i]) < kSamePose)) return false;
  return mouthOpen == other.mouthOpen;
}

bool isBallStance(const HeadPose& pose) {
  constexpr double kNeck = -52.0;  // deg
  constexpr double kNod = 45.0;
  constexpr double kWithin = 6.0;
  return pose.mouthOpen && std::fabs(pose.angles[0] - kNeck) < kWithin &&
         std::fabs(pose.angles[1]) < kWithin && std::fabs(pose.angles[2] - kNod) < kWithin;
}

CarpetMoment carpetMoment(const FrameInput& input) {
  const Command& command = input.lastCommand;
  const HeadRequest& head = command.head;
  const WalkRequest& walk = command.walk;
  const MotionStatus& motion = input.motion;
  const bool still = walk.forward == 0.0 && walk.left == 0.0 && walk.turn == 0.0;
  const bool upright = motion.feeling.fallen == FallSide::none && !motion.feeling.lifted;
  CarpetMoment moment;
  moment.seconds = input.time.seconds();
  moment.stands = still && upright && motion.ready && motion.running == MotionKind::none &&
                  command.motion == MotionKind::none && head.aim == HeadAim::joints;
  moment.pose = {{head.neckTilt.deg(), head.headPan.deg(), head.headNod.deg()}, command.mouthOpen};
  moment.reading = input.sensors.headNearDistance;
  return moment;
}

std::vector<CarpetReadings> carpetReadings(const std::vector<CarpetMoment>& moments) {
  std::vector<Sum> sums;
  std::size_t began = 0;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const CarpetMoment& now = moments[i];
    if (!now.stands || !moments[began].stands || now.pose != moments[began].pose) began = i;
    if (!now.stands || now.seconds - moments[began].seconds < kSettleSeconds) continue;
    Sum& sum = sumOf(now.pose, sums);
    ++sum.count;
    sum.sum += now.reading;
    sum.good = sum.good && now.reading > kNearest && now.reading < kFarthest;
  }
  std::vector<CarpetReadings> poses;
  for (const Sum& sum : sums)
    if (sum.good && sum.count >= kMinReadings)
      poses.push_back({sum.pose, sum.count, sum.sum / static_cast<double>(sum.count)});
  return poses;
}

Expected<CarpetLog> readCarpet(const std::string& path) {
  const auto config = std::make_unique<agent::AgentConfig>();
  CarpetLog log;
  std::vector<CarpetMoment> moments;
  const Status read = forEachFrame(path, *config, log.lacks, [&](const FrameInput& input, bool) {
    moments.push_back(carpetMoment(input));
  });
  if (!read) return Error{read.error()};
  log.infrared = config->body.infrared;
  log.poses = carpetReadings(moments);
  if (!log.poses.empty()) return log;
  return Error{path + ": in no pose of the head does the robot stand and read the carpet for 1 s"};
}

}  // namespace kelpie::calibrate
