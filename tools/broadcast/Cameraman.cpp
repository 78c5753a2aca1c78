// SPDX-License-Identifier: Apache-2.0
#include "tools/broadcast/Cameraman.h"

#include <algorithm>
#include <cmath>

namespace kelpie::broadcast {
namespace {

constexpr double kCm = 0.01;           // m
constexpr double kTargetSmooth = 0.7;  // s, standard deviation
constexpr double kZoomSmooth = 1.3;
constexpr double kMargin = 0.50;   // m round what must be seen
constexpr double kNearest = 1.05;  // m, half of what the picture is wide, at least and at most
constexpr double kWidest = 1.90;
constexpr double kStandBehind = 2.6;   // m of the stand behind the side line
constexpr double kStandHigh = 0.50;    // its height over its distance, of the way of sight
constexpr std::size_t kInPicture = 2;  // robots beside the ball

// Where to look, and how wide.
struct Aim {
  cv::Vec3d target;
  double half = 1.0;  // m
};

cv::Vec3d onGround(Point2<Field> p) { return {kCm * p.x, kCm * p.y, 0.06}; }

// The ball kept near the field: one that lies far outside is not followed.
Point2<Field> watched(const Tableau& tableau, const body::FieldDescription& field) {
  if (!tableau.ballThere) {
    Point2<Field> middle{0.5 * field.width, 0.5 * field.length};
    return tableau.actors.empty() ? middle : tableau.actors.front().pose.position;
  }
  return {std::clamp(tableau.ball.x, 0.0, field.width),
          std::clamp(tableau.ball.y, 0.0, field.length)};
}

Aim aimAt(const Tableau& tableau, const body::FieldDescription& field) {
  const cv::Vec3d ball = onGround(watched(tableau, field));
  std::vector<cv::Vec3d> robots;
  for (const Actor& actor : tableau.actors) robots.push_back(onGround(actor.pose.position));
  std::sort(robots.begin(), robots.end(), [&](const cv::Vec3d& a, const cv::Vec3d& b) {
    return cv::norm(a - ball) < cv::norm(b - ball);
  });
  if (robots.size() > kInPicture) robots.resize(kInPicture);
  cv::Vec3d low = ball, high = ball;
  for (const cv::Vec3d& robot : robots)
    for (int i = 0; i < 2; ++i) {
      low[i] = std::min(low[i], robot[i]);
      high[i] = std::max(high[i], robot[i]);
    }
  Aim aim;
  aim.target = 0.5 * (low + high);
  // What lies along the way of sight takes up less of the picture than what lies across it.
  const double wide = std::max(0.5 * (high[1] - low[1]), 0.9 * (high[0] - low[0]));
  aim.half = std::clamp(wide + kMargin, kNearest, kWidest);
  // One so far away that both do not fit loses to the ball.
  const cv::Vec3d off = ball - aim.target;
  const double most = std::max(0.0, aim.half - kMargin);
  if (cv::norm(off) > most && cv::norm(off) > 0.0) aim.target = ball - off * (most / cv::norm(off));
  return aim;
}

template <class Value, class Get>
Value smoothed(const std::vector<Aim>& aims, const std::vector<double>& times, std::size_t at,
               double deviation, Get get) {
  Value sum = get(aims[at]) * 1.0;
  double weights = 1.0;
  const auto take = [&](std::size_t i) {
    const double off = (times[i] - times[at]) / deviation;
    const double weight = std::exp(-0.5 * off * off);
    sum += get(aims[i]) * weight;
    weights += weight;
    return weight > 0.02;
  };
  for (std::size_t i = at + 1; i < aims.size() && take(i); ++i) {
  }
  for (std::size_t i = at; i > 0 && take(i - 1); --i) {
  }
  return sum * (1.0 / weights);
}

View fromStand(const cv::Vec3d& target, double half, const body::FieldDescription& field,
               double aspect) {
  const double away = half / (std::tan(0.5 * kOpening * maths::kPi / 180.0) * aspect);
  const cv::Vec3d stand(kCm * field.width + kStandBehind, 0.5 * kCm * field.length, 0.0);
  cv::Vec3d way = stand - target;
  way[2] = kStandHigh * std::hypot(way[0], way[1]);
  View view;
  view.target = target;
  view.eye = target + cv::normalize(way) * away;
  return view;
}

// Beside the goal that the ball goes into, on the side of the stand, looking in.
View besideGoal(const sim::MatchEvent& goal, const Tableau& tableau,
                const body::FieldDescription& field) {
  const bool far = goal.ball.y > 0.5 * field.length;
  const double line = far ? field.length : 0.0;
  const double in = far ? -1.0 : 1.0;
  const Point2<Field> mouth{0.5 * field.width, line};
  const Point2<Field> ball = watched(tableau, field);
  View view;
  view.target = onGround(mouth * 0.55 + ball * 0.45);
  view.eye = {kCm * mouth.x + 1.05, kCm * (line + in * 95.0), 0.62};
  return view;
}

const sim::MatchEvent* goalAt(const std::vector<sim::MatchEvent>& events, double seconds) {
  for (const sim::MatchEvent& event : events) {
    const double since = seconds - event.time.seconds();
    if (event.kind == sim::EventKind::goal && since >= -kBeforeGoal && since <= kAfterGoal)
      return &event;
  }
  return nullptr;
}

}  // namespace

std::vector<View> followPlay(const Course& course, const body::FieldDescription& field,
                             const std::vector<double>& times, double aspect) {
  std::vector<Aim> aims;
  for (const double time : times) aims.push_back(aimAt(course.at(time), field));
  std::vector<View> views;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (const sim::MatchEvent* goal = goalAt(course.events(), times[i])) {
      const Tableau then = course.at(goal->time.seconds() - 0.5);
      views.push_back(besideGoal(*goal, then, field));
      continue;
    }
    const auto target = smoothed<cv::Vec3d>(aims, times, i, kTargetSmooth,
                                            [](const Aim& aim) { return aim.target; });
    const auto half =
        smoothed<double>(aims, times, i, kZoomSmooth, [](const Aim& aim) { return aim.half; });
    views.push_back(fromStand(target, half, field, aspect));
  }
  return views;
}

}  // namespace kelpie::broadcast
