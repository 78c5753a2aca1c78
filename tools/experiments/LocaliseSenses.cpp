// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/LocaliseSenses.h"

#include <cmath>

namespace kelpie::experiments {
namespace {

constexpr double kDegrees = 180.0 / maths::kPi;

std::vector<double> joined(const std::vector<Json>& matches, const std::string& key) {
  std::vector<double> all;
  for (const Json& match : matches)
    for (const Json& value : match[key]) all.push_back(value.get<double>());
  return all;
}

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v * v;
  return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

double sum(const std::vector<double>& values) {
  return mean(values) * static_cast<double>(values.size());
}

// Slope through the origin of what was done over what was said, and the rest's spread.
Json slope(const std::vector<double>& said, const std::vector<double>& did) {
  double cross = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < said.size(); ++i) {
    cross += said[i] * did[i];
    square += said[i] * said[i];
  }
  const double ratio = square > 0.0 ? cross / square : 0.0;
  std::vector<double> rest;
  for (std::size_t i = 0; i < said.size(); ++i) rest.push_back(did[i] - ratio * said[i]);
  return {{"ratio", ratio}, {"bias", mean(rest)}, {"rms", rms(rest)}};
}

}  // namespace

SenseErrors::SenseErrors(const gps::GpsParams& params, const std::string& csv) : params_(params) {
  if (csv.empty()) return;
  csv_.open(csv);
  csv_ << "t_s,kind,distance_cm,true_distance_cm,heading_deg,true_heading_deg,distance_sd_cm,"
          "heading_sd_deg,cut\n";
}

void SenseErrors::write(const LandmarkPercept& percept, const TrueLandmark& truth, TimeUs time) {
  csv_ << time.seconds() << ',' << static_cast<int>(percept.kind) << ',' << percept.distance << ','
       << truth.distance << ',' << percept.heading.deg() << ',' << truth.heading.deg() << ','
       << std::sqrt(percept.distanceVariance) << ','
       << std::sqrt(percept.headingVariance) * kDegrees << ','
       << (percept.leftEdgeCut || percept.rightEdgeCut ? 1 : 0) << '\n';
}

void SenseErrors::landmark(const LandmarkPercept& percept, const WatchedFrame& frame) {
  const TrueLandmark truth =
      trueLandmark(percept.kind, frame.truth, params_, frame.input.game.team);
  if (csv_.is_open()) write(percept, truth, frame.input.time);
  if (!isThere(percept, truth)) {
    ++falseOnes_[0];
    return;
  }
  const bool goal =
      percept.kind == LandmarkKind::goalBlue || percept.kind == LandmarkKind::goalYellow;
  if (goal && (percept.leftEdgeCut || percept.rightEdgeCut)) return;
  Errors& errors = errors_[goal ? 1 : 0];
  const double far = percept.distance - truth.distance;
  const double aside = (percept.heading - truth.heading).rad();
  errors.distance.push_back(far / truth.distance);
  errors.heading.push_back(aside * kDegrees);
  errors.distanceOverSd.push_back(far / std::sqrt(percept.distanceVariance));
  errors.headingOverSd.push_back(aside / std::sqrt(percept.headingVariance));
}

void SenseErrors::step(const WatchedFrame& frame) {
  const auto second = static_cast<std::size_t>(frame.input.time.seconds());
  if (second >= saidTurn_.size())
    for (auto* sums : {&saidForward_, &saidLeft_, &saidTurn_, &didForward_, &didLeft_, &didTurn_})
      sums->resize(second + 1);
  const Odometry& said = frame.input.odometry;
  const Angle turn = frame.truth.heading - frame.before.heading;
  const Point2<Robot> moved = robotFromField(
      {frame.before.position, frame.before.heading + turn * 0.5}, frame.truth.position);
  saidForward_[second] += said.forward;
  saidLeft_[second] += said.left;
  saidTurn_[second] += said.turn.deg();
  didForward_[second] += moved.y;
  didLeft_[second] -= moved.x;
  didTurn_[second] += turn.deg();
}

void SenseErrors::frame(const WatchedFrame& frame) {
  seconds_[0] = frame.input.time.seconds();
  for (const LandmarkPercept& percept : frame.output.percepts.landmarks) landmark(percept, frame);
  step(frame);
}

Json SenseErrors::json() const {
  Json all{{"seconds", seconds_},   {"false", falseOnes_},   {"saidForward", saidForward_},
           {"saidLeft", saidLeft_}, {"saidTurn", saidTurn_}, {"didForward", didForward_},
           {"didLeft", didLeft_},   {"didTurn", didTurn_}};
  for (std::size_t i = 0; i < errors_.size(); ++i) {
    const std::string kind = i == 0 ? "beacon" : "goal";
    all[kind + "Distance"] = errors_[i].distance;
    all[kind + "Heading"] = errors_[i].heading;
    all[kind + "DistanceOverSd"] = errors_[i].distanceOverSd;
    all[kind + "HeadingOverSd"] = errors_[i].headingOverSd;
  }
  return all;
}

Json SenseErrors::summary(const std::vector<Json>& matches) {
  const double seconds = sum(joined(matches, "seconds"));
  Json all;
  for (const std::string kind : {"beacon", "goal"}) {
    const auto distance = joined(matches, kind + "Distance");
    const auto heading = joined(matches, kind + "Heading");
    all[kind] = {{"per_s", static_cast<double>(distance.size()) / seconds},
                 {"distance_bias_rate", mean(distance)},
                 {"distance_rms_rate", rms(distance)},
                 {"heading_bias_deg", mean(heading)},
                 {"heading_rms_deg", rms(heading)},
                 {"distance_over_sd_rms", rms(joined(matches, kind + "DistanceOverSd"))},
                 {"heading_over_sd_rms", rms(joined(matches, kind + "HeadingOverSd"))}};
  }
  all["false_per_s"] = sum(joined(matches, "false")) / seconds;
  for (const std::string way : {"Forward", "Left", "Turn"})
    all["odometry" + way] = slope(joined(matches, "said" + way), joined(matches, "did" + way));
  return all;
}

}  // namespace kelpie::experiments
