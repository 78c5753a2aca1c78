// SPDX-License-Identifier: Apache-2.0
#include "gps/Pinks.h"

#include "gps/Modes.h"
#include "gps/PinkMap.h"
#include "gps/PinkPoseSearch.h"
#include "gps/PinkUpdate.h"
#include "gps/Predict.h"
#include "gps/Survey.h"

namespace kelpie::gps {
namespace {

void lose(const GpsParams& params, GpsState& state) {
  start(params, state);
  state.lost = true;
  state.pinks.unexplained = 0;
  state.pinks.survey = Survey{};
  state.pinks.survey.nextSearch = params.pinks.search.surveySeconds;
  state.pinks.search = PinkPoseSearch{};
}

PoseMode modeAt(const Pose2& pose, const PinkPoseSearchParams& p) {
  const double place = maths::square(p.placeSd);
  PoseMode mode;
  mode.weight = 1.0;
  mode.pose = pose;
  mode.covariance = {place, 0, 0, 0, place, 0, 0, 0, maths::square(p.headingSd.rad())};
  return mode;
}

void endSearch(const GpsParams& params, GpsState& state) {
  const PinkPoseSearchParams& p = params.pinks.search;
  PinkState& pinks = state.pinks;
  ++pinks.search.count;
  // One that two poses explain for long: to guess is better than to stand and wait, and what a
  // wrong pose does not predict soon tells.
  const bool patient = pinks.search.count < p.patience;
  if (sureness(pinks.search) >= (patient ? p.sureShare : p.likelyShare)) {
    state.modes.clear();
    state.modes.push_back(modeAt(poseNow(pinks.survey, pinks.search.candidates[0].pose), p));
    state.lost = false;
    return;
  }
  const std::uint32_t count = pinks.search.count;
  pinks.search = PinkPoseSearch{};
  pinks.search.count = count;
  // By then the odometry's turns have set the first sightings beside the last.
  if (pinks.survey.seconds > p.keepSeconds) {
    pinks.survey = Survey{};
    pinks.survey.nextSearch = p.surveySeconds;
  } else {
    pinks.survey.nextSearch = pinks.survey.seconds + p.againSeconds;
  }
}

void searchAll(const GpsIn& in, const Odometry& odometry, const GpsParams& params,
               GpsState& state) {
  const PinkPoseSearchParams& p = params.pinks.search;
  PinkState& pinks = state.pinks;
  moveSurvey(odometry, elapsedOf(in.input), pinks.survey);
  addToSurvey(in.percepts.linePoints, bearingsOf(in.input, in.percepts, state), p, pinks.survey);
  const PinkLandmarks known = knownPinks(pinks, params.pinks);
  if (!pinks.search.running && (pinks.survey.seconds < pinks.survey.nextSearch ||
                                pinks.survey.bearings.size() < p.minBearings))
    return;
  pinks.search.running = true;
  if (stepPinkPoseSearch(pinks.survey, known, state.features, params, pinks.search))
    endSearch(params, state);
}

}  // namespace

bool landmarksCount(const FrameInput& input) {
  return input.lastCommand.pinks != PinkUse::localise;
}

void usePinks(const GpsIn& in, const Odometry& odometry, const GpsParams& params, GpsState& state) {
  const PinkUse use = in.input.lastCommand.pinks;
  const bool begins = use == PinkUse::localise && state.pinks.use != use;
  state.pinks.use = use;
  if (use == PinkUse::map) {
    mapPatches(bearingsOf(in.input, in.percepts, state), in.input.game.team, params, state);
    forget(elapsedOf(in.input), params.pinks, state.pinks);
  }
  if (use != PinkUse::localise) return;
  const bool carried = in.input.game.state != PlayState::playing || in.input.game.penalised;
  const bool astray = state.pinks.unexplained > params.pinks.maxUnexplained;
  if (begins || carried || astray) return lose(params, state);
  if (state.lost) return searchAll(in, odometry, params, state);
  updateByPatches(bearingsOf(in.input, in.percepts, state), params, state);
}

}  // namespace kelpie::gps
