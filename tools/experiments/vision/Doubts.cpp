// SPDX-License-Identifier: Apache-2.0
// How well vision tells candidates for balls, beacons, goals and robots that passed every check:
// real ones lost against false ones left, with its own curves and with curves learned from the same
// views, each view with what the others taught. Bodies lean as much as their robots know
// (TiltClaim). tools/curves makes BallCurves.cpp, BeaconCurves.cpp and RobotCurves.cpp of the
// learned ones; those of GoalFacts are of 60 000 views of bodies that do not lean. Learned here
// with half of the views in randomised worlds, they lost 6 % of the nominal world's goals for 2 %.
#include <algorithm>
#include <cmath>

#include "robot/core/fields/Fields.h"
#include "tools/calibrate/distance/CurveFit.h"
#include "tools/experiments/views/Looks.h"
#include "tools/experiments/views/Objects.h"
#include "vision/VisionParams.h"

namespace kelpie::experiments {
namespace {

constexpr int kFolds = 5;
constexpr int kViewsPerFold = 25;  // views share a crowd

enum class Label { nothing, real, toSee };

// A false percept weighs as much as twenty lost objects that are to be seen: few are false.
double weightOf(Label label) {
  return label == Label::nothing ? 40.0 : label == Label::toSee ? 2.0 : 0.3;
}

struct Candidates {
  std::vector<std::string> facts;
  double from;  // cm, of the objects to see
  double to;
  double maxDoubt;  // vision's own limit
  std::vector<Label> labels;
  std::vector<double> doubts;  // vision's own
  std::vector<calibrate::CurveExample> examples;
};

template <typename Facts>
std::vector<std::string> namesOf() {
  std::vector<std::string> names;
  forEachFieldOf<Facts>([&names](const auto& f) { names.emplace_back(f.name); });
  return names;
}

Label labelOf(const SeenObject& seen, const std::vector<TrueObject>& objects, double from,
              double to) {
  Label label = Label::nothing;
  for (const TrueObject& o : objects) {
    if (!matches(seen, o)) continue;
    if (o.toSee && o.distance >= from && o.distance < to) return Label::toSee;
    label = Label::real;
  }
  return label;
}

template <typename List>
void add(const List& candidates, const std::vector<TrueObject>& objects, int view,
         Candidates& all) {
  for (const auto& candidate : candidates) {
    const Label label = labelOf(seenObject(candidate.percept), objects, all.from, all.to);
    calibrate::CurveExample example;
    forEachField(candidate.facts,
                 [&example](const auto&, double value) { example.facts.push_back(value); });
    example.positive = label == Label::nothing;
    example.weight = weightOf(label);
    example.fold = view / kViewsPerFold % kFolds;
    all.labels.push_back(label);
    all.doubts.push_back(candidate.logOddsAgainst);
    all.examples.push_back(example);
  }
}

// With a limit on the doubt: false ones left a thousand views, and shares that it loses.
Json atLimit(const Candidates& all, const std::vector<double>& doubts, double limit, int views) {
  std::array<int, 3> count{};
  std::array<int, 3> kept{};
  for (std::size_t i = 0; i < doubts.size(); ++i) {
    const auto label = static_cast<std::size_t>(all.labels[i]);
    ++count[label];
    kept[label] += doubts[i] <= limit ? 1 : 0;
  }
  const auto lost = [&](std::size_t k) { return 1.0 - kept[k] / std::max(1.0, 1.0 * count[k]); };
  return {{"max_doubt", limit},
          {"false_per_1000", 1000.0 * kept[0] / views},
          {"to_see_lost", lost(2)},
          {"all_lost", 1.0 - (kept[1] + kept[2]) / std::max(1.0, 1.0 * (count[1] + count[2]))}};
}

Json curvesOf(const Candidates& all, const calibrate::CurveFit& fit) {
  Json curves = Json::array();
  for (std::size_t i = 0; i < fit.curves.size(); ++i) {
    const auto& curve = fit.curves[i];
    Json odds = Json::array();
    for (const double value : curve.logOdds) odds.push_back(0.01 * std::round(100.0 * value));
    curves.push_back({{"fact", all.facts[i]}, {"at", curve.at}, {"log_odds", odds}});
  }
  return curves;
}

Json figuresOf(const Candidates& all, int views) {
  const auto count = [&all](Label label) {
    return std::count(all.labels.begin(), all.labels.end(), label);
  };
  Json json{{"of_nothing", count(Label::nothing)},
            {"real", count(Label::real)},
            {"to_see", count(Label::toSee)}};
  json["own"] = atLimit(all, all.doubts, all.maxDoubt, views);
  if (count(Label::nothing) < kFolds || count(Label::toSee) < kFolds) return json;
  const std::vector<double> doubts = calibrate::heldOut(all.examples, kFolds, {});
  Json learned = Json::array();
  for (const double limit : {-2.0, -1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5})
    learned.push_back(atLimit(all, doubts, limit, views));
  json["learned"] = learned;
  const calibrate::CurveFit fit = calibrate::fitCurves(all.examples, {});
  json["prior"] = 0.01 * std::round(100.0 * fit.prior);
  json["curves"] = curvesOf(all, fit);
  return json;
}

// In randomised worlds every second view is of the nominal one: the curves must hold in both.
std::vector<Request> halvesOf(const Request& request) {
  if (request.randomised.seed == 0) return {request};
  Request like = request;
  like.randomised = {};
  like.trials = request.trials / 2;
  Request randomised = request;
  randomised.trials = request.trials - like.trials;
  return {like, randomised};
}

Expected<Json> doubts(const Request& request) {
  ViewParams params;
  params.tilt = {0.0, 0.2, 1.5};  // from settled play's to a robot's start
  Visibility visibility;
  const vision::VisionParams vision;
  Candidates balls{
      namesOf<vision::BallFacts>(), 25, 350, vision.ball.maxLogOddsAgainst, {}, {}, {}};
  Candidates beacons{
      namesOf<vision::BeaconFacts>(), 50, 420, vision.beacon.maxLogOddsAgainst, {}, {}, {}};
  Candidates goals{
      namesOf<vision::GoalFacts>(), 80, 500, vision.goal.maxLogOddsAgainst, {}, {}, {}};
  Candidates robots{
      namesOf<vision::RobotFacts>(), 30, 200, vision.robot.maxLogOddsAgainst, {}, {}, {}};
  for (const Request& part : halvesOf(request))
    lookAtViews(params, part, [&](const Look& look) {
      const auto objects = trueObjects(look.view, params.field, visibility);
      add(look.judgedBalls, objects, look.number, balls);
      add(look.judgedBeacons, objects, look.number, beacons);
      add(look.judgedGoals, objects, look.number, goals);
      add(look.judgedRobots, objects, look.number, robots);
    });
  return Json{{"balls", figuresOf(balls, request.trials)},
              {"beacons", figuresOf(beacons, request.trials)},
              {"goals", figuresOf(goals, request.trials)},
              {"robots", figuresOf(robots, request.trials)}};
}

const Registration kDoubts("doubts",
                           "candidates of each object: vision's log odds beside learned ones",
                           {Option::trials, Option::seed, Option::randomised}, 6000, doubts);

}  // namespace
}  // namespace kelpie::experiments
