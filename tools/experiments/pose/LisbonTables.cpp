// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/pose/LisbonTables.h"

#include <algorithm>
#include <memory>

#include "tools/experiments/baselines/MatchTable.h"
#include "tools/experiments/harness/Trials.h"
#include "tools/experiments/pose/FromAGuess.h"
#include "vision/line/LinePoints.h"

namespace kelpie::experiments {
namespace {

constexpr double kEye = 20.0;       // cm, a standing robot's camera
constexpr double kNearest = 30.0;   // cm from the side that it looks at
constexpr double kFarthest = 80.0;  // cm
constexpr double kSpacing = 12.0;   // cm between points of a line or a border
constexpr double kGrid = 30.0;      // cm between points of the green
constexpr double kBlind = 25.0;     // cm, before the paws

const body::FieldDescription& field2004() {
  static const body::FieldDescription field = *body::fieldDescription("2004");
  return field;
}

// What a robot sees of the ground from one place.
class View {
 public:
  View(const sim::TruePose& truth, Random& random) : truth_(truth), random_(random) {}

  void add(Point2<Field> place, LinePointKind kind) {
    const Point2<Robot> exact = robotFromField(truth_.pose(), place);
    if (exact.y < 0.0 || exact.norm() < kBlind || isBehindBorder(place)) return;
    const double scale = 1.0 + random_.gaussian(0.0, 0.03);
    const Angle turn = Angle::rad(random_.gaussian(0.0, 0.017));
    const Point2<Robot> read{scale * (turn.cos() * exact.x - turn.sin() * exact.y),
                             scale * (turn.sin() * exact.x + turn.cos() * exact.y)};
    const double weight = vision::pointWeight(kind, read.norm(), {});
    if (weight > 0.0) points_.push_back({kind, read, weight, {}});
  }
  void addAlong(const body::FieldLine& line, LinePointKind kind) {
    const Point2<Field> way = line.end - line.start;
    for (double at = 0.5 * kSpacing; at < way.norm(); at += kSpacing)
      add(line.start + way * (at / way.norm()), kind);
  }
  const FixedVector<LinePoint, 256>& points() const { return points_; }

 private:
  // Where its ray leaves the field it must still be above the border, as high as it is wide.
  bool isBehindBorder(Point2<Field> place) const {
    const auto inside = [](double from, double to, double end) {
      if (to < 0.0) return from / (from - to);
      return to > end ? (end - from) / (to - from) : 1.0;
    };
    const double share = std::min(inside(truth_.x, place.x, field2004().width),
                                  inside(truth_.y, place.y, field2004().length));
    return share < 1.0 && kEye * (1.0 - share) < field2004().borderWidth;
  }

  sim::TruePose truth_;
  Random& random_;
  FixedVector<LinePoint, 256> points_;
};

void addWall(const body::Carpet& wall, View& view) {
  const Point2<Field> low = wall.low;
  const Point2<Field> high = wall.high;
  for (const body::FieldLine& side :
       {body::FieldLine{low, {low.x, high.y}}, body::FieldLine{{high.x, low.y}, high},
        body::FieldLine{low, {high.x, low.y}}, body::FieldLine{{low.x, high.y}, high}})
    view.addAlong(side, LinePointKind::border);
}

void addGreen(const gps::MatchGround& ground, View& view) {
  const body::Carpet& wall = ground.wall();
  for (double x = wall.low.x + 0.5 * kGrid; x < wall.high.x; x += kGrid)
    for (double y = wall.low.y + 0.5 * kGrid; y < wall.high.y; y += kGrid)
      if (ground.toGreen({x, y}) == 0.0) view.add({x, y}, LinePointKind::field);
}

// A robot that looks at a side of the border from near.
SeenPose seenFrom(const gps::MatchGround& ground, std::uint64_t seed) {
  Random random(seed);
  const body::FieldDescription& field = field2004();
  SeenPose view;
  const bool left = random.uniform(0.0, 1.0) < 0.5;
  const double away = random.uniform(kNearest, kFarthest);
  view.truth = {left ? away : field.width - away,
                random.uniform(kFarthest, field.length - kFarthest),
                (left ? maths::kPi : 0.0) + random.uniform(-1.0, 1.0)};
  View seen(view.truth, random);
  for (const body::FieldLine& line : field.lines) seen.addAlong(line, LinePointKind::line);
  for (const body::BorderPiece& piece : body::borderOf(field))
    seen.addAlong(piece.foot, LinePointKind::border);
  addWall(ground.wall(), seen);
  addGreen(ground, seen);
  view.seen = gps::seenLines(seen.points(), {});
  return view;
}

// A set of tables, and what came of it.
struct Tables {
  const char* ground;
  const char* equation;
  gps::MatchTables tables;
  std::array<FoundPoses, kStarts.size()> found;
  double match = 0.0;
};

std::vector<Tables> allTables(const gps::FieldFeatures& features) {
  std::vector<Tables> all;
  const auto add = [&](const char* ground, const char* equation, const gps::MatchOptions& options) {
    all.push_back({ground, equation, {field2004(), features, options}, {}, 0.0});
  };
  for (const double outside : {gps::kSeenAtHome, gps::kSeenInLisbon}) {
    const char* ground = outside > 0.0 ? "lisbon" : "home";
    add(ground, "equation_3_2", {gps::MatchDecay::reciprocal, 0.004, outside});
    add(ground, "equation_3_3", {gps::MatchDecay::bell, gps::kBellSharpness, outside});
  }
  return all;
}

Json jsonOf(const std::vector<Tables>& all, int trials) {
  Json json;
  for (const Tables& one : all)
    json["match_at_truth"][one.ground][one.equation] = ratio(one.match, trials);
  for (std::size_t i = 0; i < kStarts.size(); ++i) {
    Json start{{"start_cm", kStarts[i].sd}, {"start_deg", kStarts[i].sdDeg}};
    for (const Tables& one : all) start[one.ground][one.equation] = one.found[i].json();
    json["starts"].push_back(start);
  }
  return json;
}

}  // namespace

Json lisbonTables(const Request& request) {
  const auto features = std::make_unique<gps::FieldFeatures>();
  features->build(field2004());
  const gps::MatchGround ground(field2004(), *features, gps::kSeenInLisbon);
  std::vector<Tables> all = allTables(*features);
  for (int number = 0; number < request.trials; ++number) {
    const Trial trial = trialOf(request, number);
    const SeenPose view = seenFrom(ground, trial.seed);
    for (Tables& one : all) {
      one.match +=
          gps::overallMatch(view.seen, view.truth.pose(), one.tables, gps::Interpolation::thesis)
              .value;
      for (std::size_t i = 0; i < kStarts.size(); ++i) {
        const Pose2 guess = guessBeside(view.truth, kStarts[i], trial.seed);
        const gps::Ascent ascent = gps::ascend(view.seen, guess, one.tables, {});
        one.found[i].add(ascent.pose, ascent.steps, view.truth);
      }
    }
  }
  return jsonOf(all, request.trials);
}

}  // namespace kelpie::experiments
