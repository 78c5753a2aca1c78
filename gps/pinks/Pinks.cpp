// SPDX-License-Identifier: Apache-2.0
#include "gps/pinks/Pinks.h"

#include "gps/pinks/PinkMap.h"
#include "gps/pinks/PinkPoseSearch.h"
#include "gps/pinks/PinkUpdate.h"
#include "gps/pinks/Survey.h"
#include "gps/pose/Modes.h"
#include "gps/pose/Predict.h"

namespace kelpie::gps {
namespace {

void startSurvey(const PinkContext& context, PinkState& pinks, PoseState& pose) {
  lose(context.field.description, context.modes, pose);
  pinks.unexplained = 0;
  pinks.survey = Survey{};
  pinks.survey.nextSearch = context.pinks.search.surveySeconds;
  pinks.search = PoseSearch{};
  pinks.searches = 0;
}

PoseMode modeAt(const Pose2& pose, const PinkPoseSearchParams& p) {
  const double place = maths::square(p.placeSd);
  PoseMode mode;
  mode.weight = 1.0;
  mode.pose = pose;
  mode.covariance = {place, 0, 0, 0, place, 0, 0, 0, maths::square(p.headingSd.rad())};
  return mode;
}

// The found pose becomes the only mode, or the robot looks round for longer.
void endSearch(const PinkPoseSearchParams& p, PinkState& pinks, PoseState& pose) {
  ++pinks.searches;
  // One that two poses explain for long: to guess is better than to stand and wait, and what a
  // wrong pose does not predict soon tells.
  const FoundPoses found = pinks.search.found;
  const bool patient = pinks.searches < p.patience;
  pinks.search = PoseSearch{};
  if (sureness(found) >= (patient ? p.sureShare : p.likelyShare)) {
    pose.modes.clear();
    pose.modes.push_back(modeAt(poseNow(pinks.survey, found[0].pose), p));
    pose.lost = false;
    return;
  }
  // By then the odometry's turns have set the first sightings beside the last.
  if (pinks.survey.seconds > p.keepSeconds) {
    pinks.survey = Survey{};
    pinks.survey.nextSearch = p.surveySeconds;
  } else {
    pinks.survey.nextSearch = pinks.survey.seconds + p.againSeconds;
  }
}

void surveyAndSearch(const PinksIn& in, const PinkContext& context, PinkState& pinks,
                     PoseState& pose, GpsCounts& counts) {
  const PinkPoseSearchParams& p = context.pinks.search;
  moveSurvey(in.moved, elapsedOf(in.frame.input), pinks.survey);
  const PinkBearings bearings = bearingsOf(in.frame, counts);
  if (context.lines.use == LineUse::position) {
    addToSurvey(in.frame.percepts.linePoints, bearings, p, pinks.survey);
  } else {
    addToSurvey({}, bearings, p, pinks.survey);
  }
  const PinkLandmarks known = knownPinks(pinks, context.pinks);
  if (!pinks.search.running && (pinks.survey.seconds < pinks.survey.nextSearch ||
                                pinks.survey.bearings.size() < p.minBearings))
    return;
  if (stepPinkPoseSearch(pinks.survey, known, context, pinks.search)) endSearch(p, pinks, pose);
}

void mapPinks(const GpsIn& in, const PinkContext& context, const PoseState& pose, PinkState& pinks,
              GpsCounts& counts) {
  const auto landmarks = body::landmarksFor(context.field.description, in.input.game.team);
  mapPatches({bearingsOf(in, counts), pose, landmarks}, context.pinks, pinks.map, counts);
  forget(elapsedOf(in.input), context.pinks, pinks);
}

}  // namespace

void usePinks(const PinksIn& in, const PinkContext& context, PinkState& pinks, PoseState& pose,
              GpsCounts& counts) {
  const FrameInput& input = in.frame.input;
  const PinkUse use = input.lastCommand.pinks;
  const bool begins = use == PinkUse::localise && pinks.use != use;
  pinks.use = use;
  if (use == PinkUse::map) mapPinks(in.frame, context, pose, pinks, counts);
  if (use != PinkUse::localise) return;
  const bool carried = input.game.state != PlayState::playing || input.game.penalised;
  const bool astray = pinks.unexplained > context.pinks.maxUnexplained;
  if (begins || carried || astray) return startSurvey(context, pinks, pose);
  if (pose.lost) return surveyAndSearch(in, context, pinks, pose, counts);
  updateByPatches(bearingsOf(in.frame, counts), context, pinks, pose, counts);
}

}  // namespace kelpie::gps
