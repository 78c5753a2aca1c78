// SPDX-License-Identifier: Apache-2.0
// What robots recognise in matches, and how wrong it is, by how much of a thing their images show:
// in a match from images and, by the same yardstick, in one of percepts (tools/percepts). The
// errors that an Eye makes are chosen so that both agree. Truth is only read back. How much shows
// is what the Eye's own geometry says, so that its mistakes are in both columns.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>

#include "robot/agent/log/FrameMessages.h"
#include "robot/core/types/FrameOutput.h"
#include "tools/cli/Process.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/match/AgentFrames.h"
#include "tools/experiments/team/TeamMatch.h"
#include "tools/league/value/PlayedTruth.h"
#include "tools/percepts/Shown.h"

namespace kelpie::experiments {
namespace {

using percepts::Moment;
using percepts::View;

constexpr double kSeconds = 120.0;  // of play
constexpr double kSame = 20.0;      // deg, of a percept that is of the thing
constexpr std::int64_t kHalfExposureUs = 1000000 / 60;

// Things of one kind in one range of what decides: how many were recognised, and their errors.
struct Bin {
  Share recall;
  Values distanceShare;  // error over the distance
  Values heading;        // deg
};

Json figuresOf(const Bin& bin) {
  return Json{{"all", bin.recall.all},
              {"recall", bin.recall.value()},
              {"distance_mean", mean(bin.distanceShare)},
              {"distance_sd", standardDeviation(bin.distanceShare)},
              {"heading_mean_deg", mean(bin.heading)},
              {"heading_sd_deg", standardDeviation(bin.heading)}};
}

// By name; a name tells the range.
class Bins {
 public:
  void add(const std::string& name, bool seen) { bins_[name].recall.count(seen); }
  void addError(const std::string& name, double share, double deg) {
    bins_[name].distanceShare.push_back(share);
    bins_[name].heading.push_back(deg);
  }
  Json figures() const {
    Json json = Json::object();
    for (const auto& [name, bin] : bins_) json[name] = figuresOf(bin);
    return json;
  }

 private:
  std::map<std::string, Bin> bins_;
};

// "ball 0.4 100": the range that a value falls into, named by its lower end.
std::string rangeOf(double value, std::initializer_list<double> ends) {
  double low = 0.0;
  for (const double end : ends)
    if (value >= end) low = end;
  char text[16];
  std::snprintf(text, sizeof text, " %g", low);
  return text;
}

struct Found {
  Bins bins;
  int frames = 0;
  std::map<std::string, Values> counts;  // of a frame
  std::map<std::string, int> falseOnes;

  Json figures() const {
    Json means = Json::object();
    for (const auto& [name, values] : counts) means[name] = mean(values);
    Json wrong = Json::object();
    for (const auto& [name, number] : falseOnes) wrong[name] = 1000.0 * ratio(number, frames);
    return Json{{"frames", frames},
                {"mean_count", means},
                {"false_in_1000", wrong},
                {"things", bins.figures()}};
  }
};

// One frame of one robot beside the truth.
class Frame {
 public:
  Frame(const FrameOutput& output, const Moment& moment, std::size_t self,
        const body::FieldDescription& field, Found& found)
      : output_(output), moment_(moment), self_(self), field_(field), found_(found) {
    view_.turnTo(moment, self, output.body.camera);
  }
  void judge() {
    ++found_.frames;
    count("line_points", of(LinePointKind::line));
    count("field_points", of(LinePointKind::field));
    count("obstacles", output_.percepts.obstacles.size());
    count("obstacles_ahead", output_.percepts.obstaclesAhead);
    count("field_edges", output_.percepts.fieldEdges.size());
    count("gaps", output_.percepts.gaps.size());
    judgeBall();
    for (const body::Landmark& mark : field_.landmarks) judgeLandmark(mark);
    for (std::size_t i = 0; i < moment_.robots.size(); ++i)
      if (i != self_) judgeRobot(i);
    judgeFalseRobots();
  }

 private:
  std::size_t of(LinePointKind kind) const {
    std::size_t number = 0;
    for (const LinePoint& p : output_.percepts.linePoints) number += p.kind == kind ? 1 : 0;
    return number;
  }
  void count(const char* what, std::size_t number) {
    found_.counts[what].push_back(static_cast<double>(number));
  }
  Point2<Robot> truly(Point2<Field> place) const { return robotFromField(view_.pose(), place); }
  template <class Percept>
  void addError(const std::string& name, const Percept& seen, Point2<Field> place) {
    const Point2<Robot> truth = truly(place);
    found_.bins.addError(name, seen.distance / truth.norm() - 1.0,
                         (seen.heading - bearing(truth)).deg());
  }
  std::string turning() const { return output_.body.headSpeed > 0.05 ? " turning" : ""; }

  void judgeBall() {
    const BallPercept& seen = output_.percepts.ball;
    const auto shown = percepts::shownBall(view_, moment_.ball);
    const double range = shown ? shown->along : 1e3;
    const bool right =
        seen.present && (seen.heading - bearing(truly(moment_.ball))).abs().deg() < kSame;
    if (seen.present && !right) ++found_.falseOnes["ball"];
    if (!shown || shown->share <= 0.0) return;
    const std::string at = rangeOf(range, {20, 40, 80, 150, 250, 350, 420});
    const std::string name = "ball" + rangeOf(shown->share, {0.2, 0.4, 0.6, 0.8, 1.0}) + at;
    found_.bins.add(name, right);
    if (right && shown->share >= 1.0) addError("ball all" + at + turning(), seen, moment_.ball);
    if (right && shown->share < 1.0) addError("ball part" + at, seen, moment_.ball);
  }
  void judgeLandmark(const body::Landmark& mark) {
    const auto& all = output_.percepts.landmarks;
    const auto* seen =
        std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.kind == mark.kind; });
    const bool right =
        seen != all.end() && (seen->heading - bearing(truly(mark.position))).abs().deg() < kSame;
    const bool goal = mark.kind <= LandmarkKind::goalYellow;
    if (seen != all.end() && !right) ++found_.falseOnes[goal ? "goal" : "beacon"];
    const double away = view_.distance(mark.position);
    const std::string at = rangeOf(away, {50, 100, 200, 300, 400, 500});
    std::string name;
    if (goal) {
      const auto mouth = percepts::shownMouth(view_, field_, mark.position);
      if (mouth.share <= 0.0) return;
      name = "goal" + rangeOf(mouth.share, {0.15, 0.25, 0.4, 0.6, 0.8, 0.97});
    } else {
      const auto bands = percepts::shownBands(view_, field_, mark.position);
      if (bands.share <= 0.0) return;
      name = "beacon" + rangeOf(bands.share, {0.2, 0.4, 0.6, 0.8, 1.0});
    }
    found_.bins.add(name + at, right);
    if (right) addError(name + at, *seen, mark.position);
  }
  const RobotPercept* perceptOf(std::size_t robot) const {
    const Point2<Robot> truth = truly(fieldFromRobot(moment_.robots[robot].pose, {0.0, -4.0}));
    for (const RobotPercept& p : output_.percepts.robots) {
      const double off = (p.heading - bearing(truth)).abs().deg();
      const bool near = off < kSame && p.distance < 1.7 * truth.norm() + 10.0 &&
                        p.distance > 0.5 * truth.norm() - 10.0;
      if (near && p.team == moment_.teams[robot]) return &p;
    }
    return nullptr;
  }
  void judgeRobot(std::size_t robot) {
    const double pixels = percepts::shownUniform(view_, moment_.robots[robot]);
    if (pixels <= 0.0) return;
    const Point2<Field> middle = fieldFromRobot(moment_.robots[robot].pose, {0.0, -4.0});
    const RobotPercept* seen = perceptOf(robot);
    const std::string at = rangeOf(view_.distance(middle), {40, 80, 120, 160, 200, 240, 280});
    const std::string team = moment_.teams[robot] == TeamColour::red ? " red" : " blue";
    found_.bins.add("robot" + team + rangeOf(pixels, {4, 8, 16, 32, 64, 128, 256}),
                    seen != nullptr);
    found_.bins.add("robot at" + at, seen != nullptr);
    if (seen != nullptr) addError("robot at" + at, *seen, middle);
  }
  void judgeFalseRobots() {
    std::size_t known = 0;
    for (std::size_t i = 0; i < moment_.robots.size(); ++i)
      known += i != self_ && perceptOf(i) != nullptr ? 1 : 0;
    const std::size_t all = output_.percepts.robots.size();
    if (all > known) found_.falseOnes["robot"] += static_cast<int>(all - known);
  }

  const FrameOutput& output_;
  const Moment& moment_;
  std::size_t self_;
  const body::FieldDescription& field_;
  Found& found_;
  View view_;
};

// In the middle of the exposure, which ended with the image's truth; of the one who looks, the
// joints that it sensed.
Moment momentOf(const sim::TruthFrame& before, const sim::TruthFrame& truth,
                const FrameInput& input, std::size_t& self) {
  Moment moment;
  const auto between = [](Point2<Field> a, Point2<Field> b) { return a + (b - a) * 0.5; };
  for (std::size_t i = 0; i < truth.robots.size(); ++i) {
    const sim::RobotTruth& now = truth.robots[i];
    const Pose2& then = before.robots[i].pose;
    const bool own = now.team == input.game.team && now.player == input.game.player;
    if (own) self = i;
    sim::BodyPlace place;
    place.pose = {between(then.position, now.pose.position),
                  then.heading + Angle::rad(0.5 * (now.pose.heading - then.heading).rad())};
    place.stance = now.stance;
    if (own) place.joints = input.sensors.joints;
    moment.robots.push_back(place);
    moment.teams.push_back(now.team);
  }
  moment.ball = between(before.ball, truth.ball);
  return moment;
}

bool isCarried(const sim::TruthFrame& before, const sim::TruthFrame& truth) {
  for (std::size_t i = 0; i < truth.robots.size(); ++i)
    if (distance(before.robots[i].pose.position, truth.robots[i].pose.position) > 5.0) return true;
  return distance(before.ball, truth.ball) > 15.0;
}

Status judgeRobot(const std::string& log, const std::vector<sim::TruthFrame>& truth,
                  const body::FieldDescription& field, Found& found) {
  return eachAgentFrame(log, [&](const FrameInput& input, const FrameOutput& output) {
    if (input.game.state != PlayState::playing || input.game.penalised) return;
    const auto now = std::lower_bound(
        truth.begin(), truth.end(), input.time.us + kHalfExposureUs - 5000,
        [](const sim::TruthFrame& frame, std::int64_t us) { return frame.time.us < us; });
    if (now == truth.end() || now == truth.begin() || isCarried(*(now - 1), *now)) return;
    std::size_t self = 0;
    const Moment moment = momentOf(*(now - 1), *now, input, self);
    Frame(output, moment, self, field, found).judge();
  });
}

Status playOne(const cli::SessionOptions& session, Found& found) {
  Status judged = Done{};
  cli::SessionTalk talk;
  talk.all = [&](const std::vector<std::string>& logs, const std::string& worldLog) {
    const auto truth = value::readTruth(worldLog);
    if (!truth) judged = Error{truth.error()};
    const auto field = body::fieldDescription(session.field);
    for (const std::string& log : logs)
      if (judged) judged = judgeRobot(log, truth->frames, *field, found);
  };
  const cli::SessionResult result = cli::runSession(session, talk);
  if (!result.trouble.empty()) return Error{result.trouble};
  return judged;
}

Expected<Json> perceptNoise(const Request& request) {
  cli::catchInterrupts();
  Json figures = Json::object();
  for (const bool percepts : {true, false}) {
    Found found;
    const Status played = eachTrial(request, [&](const Trial& trial) -> Status {
      const double seconds = request.minutes > 0.0 ? 60.0 * request.minutes : kSeconds;
      auto session = teamSession(request, trial, "4v4", seconds);
      if (!session) return Error{session.error()};
      session->physical = false;
      session->percepts = percepts;
      return playOne(*session, found);
    });
    if (!played) return Error{played.error()};
    figures[percepts ? "percepts" : "images"] = found.figures();
  }
  return figures;
}

const Registration kPerceptNoise("percept-noise",
                                 "what robots recognise in matches from images and of percepts",
                                 {Option::trials, Option::seed, Option::params, Option::minutes}, 1,
                                 perceptNoise);

}  // namespace
}  // namespace kelpie::experiments
