// SPDX-License-Identifier: Apache-2.0
// How well vision recognises objects: seeded random views with every artefact, spectators in the
// objects' colours, robots and partly hidden things. By object and distance: share of those to be
// seen that were (recall), false percepts, errors of distance and heading.
#include "tools/experiments/views/Objects.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>

#include "tools/experiments/views/Looks.h"
#include "tools/match/Draw.h"
#include "tools/picture/PngFile.h"
#include "vision/Refusal.h"

namespace kelpie::experiments {
namespace {

struct Sums {
  int toSee = 0;
  int seen = 0;
  int measured = 0;
  double distance = 0.0;  // of (measured - true) / true
  double distance2 = 0.0;
  double heading2 = 0.0;  // deg2

  void add(double share, double headingDeg) {
    ++measured;
    distance += share;
    distance2 += share * share;
    heading2 += headingDeg * headingDeg;
  }
  void add(const Sums& other) {
    toSee += other.toSee;
    seen += other.seen;
    measured += other.measured;
    distance += other.distance;
    distance2 += other.distance2;
    heading2 += other.heading2;
  }
  double recall() const { return toSee > 0 ? static_cast<double>(seen) / toSee : 1.0; }
  double biasPct() const { return measured > 0 ? 100.0 * distance / measured : 0.0; }
  double rmsPct() const { return measured > 0 ? 100.0 * std::sqrt(distance2 / measured) : 0.0; }
  double headingDeg() const { return measured > 0 ? std::sqrt(heading2 / measured) : 0.0; }
};

struct Kind {
  ObjectKind kind;
  const char* name;
  std::vector<double> borders;  // cm, of the distance bands
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = {
      {ObjectKind::ball, "ball", {25, 50, 100, 150, 200, 250, 300, 350}},
      {ObjectKind::beacon, "beacon", {50, 100, 150, 200, 250, 300, 350, 420}},
      {ObjectKind::goal, "goal", {80, 150, 220, 290, 360, 430, 500}},
      {ObjectKind::robot, "robot", {30, 65, 100, 150, 200, 300}}};
  return all;
}

const char* nameOf(ObjectKind kind) {
  for (const auto& k : kinds())
    if (k.kind == kind) return k.name;
  return "";
}

double offDeg(const SeenObject& p, const TrueObject& o) { return (p.heading - o.heading).deg(); }

constexpr int kMaxPictures = 80;

// The image with the percepts and, in words, what is wrong with them and what was refused.
void keepPicture(const std::string& folder, const Look& look,
                 const std::vector<std::string>& faults) {
  FrameOutput output;
  output.body = look.body;
  output.percepts = look.seen;
  cv::Mat picture = match::drawCamera(look.view.input, output, 4);
  int row = 16;
  for (const auto& fault : faults) {
    cv::putText(picture, fault, {4, row}, cv::FONT_HERSHEY_SIMPLEX, 0.5, {0, 0, 255}, 1,
                cv::LINE_AA);
    row += 16;
  }
  std::string refusals;
  for (std::size_t i = 0; i < vision::kRefusalCount; ++i)
    if (look.seen.counts.refused[i] > 0)
      refusals +=
          fmt::format("{} {}  ", vision::kRefusalNames[i].name, look.seen.counts.refused[i]);
  for (std::size_t at = 0; at < refusals.size(); at += 95, row += 16)
    cv::putText(picture, refusals.substr(at, 95), {4, row}, cv::FONT_HERSHEY_SIMPLEX, 0.45,
                {255, 255, 255}, 1, cv::LINE_AA);
  const std::string path = fmt::format("{}/view{:05}.png", folder, look.number);
  const Status written = picture::writePng(path, picture);
  if (!written) fmt::print(stderr, "{}\n", written.error());
}

class Score {
 public:
  void add(const View& view, const body::FieldDescription& field,
           const std::vector<TrueObject>& objects, const Percepts& seen) {
    ++views_;
    const auto percepts = seenObjects(seen);
    faults_.clear();
    for (const auto& object : objects) addObject(object, percepts);
    for (const auto& p : percepts) {
      const bool real = std::any_of(objects.begin(), objects.end(),
                                    [&p](const TrueObject& o) { return matches(p, o); });
      if (real) continue;
      ++false_[p.kind];
      faults_.push_back(fmt::format("false {} {} at {:.0f} cm {:.0f} deg", nameOf(p.kind),
                                    static_cast<int>(p.landmark), p.distance, p.heading.deg()));
    }
    for (const auto& object : objects)
      if (object.kind == ObjectKind::goal && object.toSee) addGaps(view, field, object, seen);
  }

  // What went wrong in the last view, a line each.
  const std::vector<std::string>& faults() const { return faults_; }

  Json figures() const {
    Json json;
    const Sums ball = within(ObjectKind::ball, 25, 300);
    const Sums robot = within(ObjectKind::robot, 30, 200);
    json["views"] = views_;
    json["ball_recall_250"] = within(ObjectKind::ball, 25, 250).recall();
    json["ball_recall_350"] = within(ObjectKind::ball, 250, 350).recall();
    json["ball_bias_pct"] = ball.biasPct();
    json["ball_rms_pct"] = ball.rmsPct();
    json["ball_heading_deg"] = ball.headingDeg();
    json["beacon_recall_350"] = within(ObjectKind::beacon, 50, 350).recall();
    json["beacon_recall_420"] = within(ObjectKind::beacon, 350, 420).recall();
    json["goal_recall"] = within(ObjectKind::goal, 80, 500).recall();
    json["gap_deg"] = gapEnds_ > 0 ? std::sqrt(gapDeg2_ / gapEnds_) : 0.0;
    json["gap_ends"] = gapEnds_;
    json["gap_recall"] = gapsToSee_ > 0 ? static_cast<double>(gapsSeen_) / gapsToSee_ : 1.0;
    json["robot_recall_200"] = robot.recall();
    json["robot_heading_deg"] = robot.headingDeg();
    int wrong = 0;
    for (const auto& [kind, count] : false_) wrong += count;
    json["false_positives_per_1000"] = 1000.0 * wrong / views_;
    for (const auto& kind : kinds())
      json["false_" + std::string(kind.name) + "_per_1000"] = perThousand(kind.kind);
    json["bands"] = bands();
    return json;
  }

 private:
  void addObject(const TrueObject& object, const std::vector<SeenObject>& percepts) {
    const auto band = bandOf(object);
    if (!band || !object.toSee) return;
    Sums& sums = sums_[*band];
    ++sums.toSee;
    const SeenObject* best = nullptr;
    for (const auto& p : percepts)
      if (matches(p, object) &&
          (best == nullptr || std::fabs(offDeg(p, object)) < std::fabs(offDeg(*best, object))))
        best = &p;
    if (best == nullptr) {
      faults_.push_back(fmt::format("missed {} {} at {:.0f} cm {:.0f} deg", nameOf(object.kind),
                                    static_cast<int>(object.landmark), object.distance,
                                    object.heading.deg()));
      return;
    }
    ++sums.seen;
    sums.add(best->distance / object.distance - 1.0, offDeg(*best, object));
  }

  // A gap of five degrees or more is to be seen; its ends count where they are in the image.
  void addGaps(const View& view, const body::FieldDescription& field, const TrueObject& goal,
               const Percepts& seen) {
    for (const TrueGap& gap : trueGaps(view, field, goal.landmark)) {
      if ((gap.left - gap.right).deg() < 5.0 || (!gap.leftInImage && !gap.rightInImage)) continue;
      ++gapsToSee_;
      const GoalGap* best = nullptr;
      double largest = 0.0;
      for (const auto& p : seen.gaps) {
        if (p.goal != goal.landmark) continue;
        const double shared = overlapDeg(gap, p);
        if (shared > largest) {
          largest = shared;
          best = &p;
        }
      }
      if (best == nullptr) continue;
      ++gapsSeen_;
      if (gap.leftInImage && !best->leftCut) addEnd((best->left - gap.left).deg());
      if (gap.rightInImage && !best->rightCut) addEnd((best->right - gap.right).deg());
    }
  }
  static double overlapDeg(const TrueGap& a, const GoalGap& b) {
    const Angle left = (a.left - b.left).rad() < 0.0 ? a.left : b.left;
    const Angle right = (a.right - b.right).rad() > 0.0 ? a.right : b.right;
    return (left - right).deg();
  }
  void addEnd(double errorDeg) {
    ++gapEnds_;
    gapDeg2_ += errorDeg * errorDeg;
  }

  using Band = std::pair<ObjectKind, double>;  // kind and lower border
  static std::optional<Band> bandOf(const TrueObject& object) {
    for (const auto& kind : kinds()) {
      if (kind.kind != object.kind) continue;
      for (std::size_t i = 0; i + 1 < kind.borders.size(); ++i)
        if (object.distance >= kind.borders[i] && object.distance < kind.borders[i + 1])
          return Band{kind.kind, kind.borders[i]};
    }
    return std::nullopt;
  }
  Sums within(ObjectKind kind, double low, double high) const {
    Sums all;
    for (const auto& [band, sums] : sums_)
      if (band.first == kind && band.second >= low && band.second < high) all.add(sums);
    return all;
  }
  double perThousand(ObjectKind kind) const {
    const auto found = false_.find(kind);
    return found == false_.end() ? 0.0 : 1000.0 * found->second / views_;
  }
  Json bands() const {
    Json list = Json::array();
    for (const auto& kind : kinds())
      for (std::size_t i = 0; i + 1 < kind.borders.size(); ++i) {
        const auto found = sums_.find({kind.kind, kind.borders[i]});
        if (found == sums_.end()) continue;
        const Sums& s = found->second;
        list.push_back({{"object", kind.name},
                        {"from_cm", kind.borders[i]},
                        {"to_cm", kind.borders[i + 1]},
                        {"to_see", s.toSee},
                        {"recall", s.recall()},
                        {"bias_pct", s.biasPct()},
                        {"rms_pct", s.rmsPct()},
                        {"heading_deg", s.headingDeg()}});
      }
    return list;
  }

  std::vector<std::string> faults_;
  int views_ = 0;
  std::map<Band, Sums> sums_;
  std::map<ObjectKind, int> false_;
  int gapsToSee_ = 0;
  int gapsSeen_ = 0;
  int gapEnds_ = 0;
  double gapDeg2_ = 0.0;
};

Json figuresOf(const ViewParams& params, const Request& request) {
  const body::FieldDescription& field = params.field;
  Visibility visibility;
  Score score;
  int pictures = 0;
  lookAtViews(params, request, [&](const Look& look) {
    score.add(look.view, field, trueObjects(look.view, field, visibility), look.seen);
    if (!request.pictures.empty() && !score.faults().empty() && pictures++ < kMaxPictures)
      keepPicture(request.pictures, look, score.faults());
  });
  return score.figures();
}

Expected<Json> objects(const Request& request) { return figuresOf({}, request); }

constexpr double kTilt = 2.0;     // deg
constexpr double kStartSd = 1.5;  // deg, what a robot at its start knows of it

// Robots that do not know that they lean, but know that they might, and robots in settled play.
Expected<Json> tiltedObjects(const Request& request) {
  ViewParams start;
  start.tilt.sd = kStartSd;
  Json by = Json::array();
  for (const double tilt : {-kTilt, 0.0, kTilt}) {
    Request tilted = request;
    tilted.randomised.tiltError = tilt;
    by.push_back(figuresOf(start, tilted));
  }
  ViewParams settled;
  settled.tilt = {0.0, 0.25, 0.35};
  Json json{{"settled", figuresOf(settled, request)}};
  const auto min = [&by](const char* key) {
    return std::min(by[0][key].get<double>(), by[2][key].get<double>()) / by[1][key].get<double>();
  };
  const auto max = [&by](const char* key) {
    return std::max({by[0][key].get<double>(), by[1][key].get<double>(), by[2][key].get<double>()});
  };
  json["beacon_recall_ratio"] = min("beacon_recall_350");
  json["goal_recall_ratio"] = min("goal_recall");
  json["false_positives_per_1000"] = max("false_positives_per_1000");
  json["by_tilt"] = by;
  return json;
}

const Registration kObjects("objects",
                            "rendered views: recall, false percepts, errors by object and distance",
                            {Option::trials, Option::seed, Option::randomised, Option::pictures},
                            6000, objects);

const Registration kTiltedObjects(
    "tilted-objects", "objects where bodies lean by -2, 0 and 2 deg, unknown, and as in play",
    {Option::trials, Option::seed, Option::pictures}, 2000, tiltedObjects);

}  // namespace
}  // namespace kelpie::experiments
