// SPDX-License-Identifier: Apache-2.0
#include "tools/match/Draw.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "tools/picture/CameraPicture.h"

namespace kelpie::match {
namespace {

using namespace ink;

const cv::Scalar kCarpet(60, 110, 40);
constexpr double kMargin = 45.0;  // cm of carpet and goal round the lines

cv::Point at(PixelPoint p, int scale) {
  return {static_cast<int>(std::lround(p.x * scale)), static_cast<int>(std::lround(p.y * scale))};
}

void label(cv::Mat& picture, const std::string& text, cv::Point where, const cv::Scalar& colour) {
  where.x = std::max(2, std::min(where.x, picture.cols - 10 * static_cast<int>(text.size())));
  where.y = std::max(12, std::min(where.y, picture.rows - 4));
  cv::putText(picture, text, where, cv::FONT_HERSHEY_SIMPLEX, 0.45, kBlack, 3, cv::LINE_AA);
  cv::putText(picture, text, where, cv::FONT_HERSHEY_SIMPLEX, 0.45, colour, 1, cv::LINE_AA);
}

// Nothing of a line outside these rows can be seen.
constexpr double kFarthestRow = 2000.0;

PixelPoint cutEnd(PixelPoint end, PixelPoint other) {
  const double row = maths::clamp(end.y, -kFarthestRow, kFarthestRow);
  if (row == end.y || end.y == other.y) return {end.x, row};
  return {end.x + (other.x - end.x) * (row - end.y) / (other.y - end.y), row};
}

void drawLine(cv::Mat& picture, double left, double right, int scale, const cv::Scalar& colour) {
  const PixelPoint from{0.0, left};
  const PixelPoint to{kImageWidth, right};
  cv::line(picture, at(cutEnd(from, to), scale), at(cutEnd(to, from), scale), colour, 1,
           cv::LINE_AA);
}

void drawBall(cv::Mat& picture, const BallPercept& ball, int scale) {
  if (!ball.present) return;
  const int radius = std::max(2, static_cast<int>(std::lround(ball.radius * scale)));
  cv::circle(picture, at(ball.centre, scale), radius, kBlack, 3, cv::LINE_AA);
  cv::circle(picture, at(ball.centre, scale), radius, kOrange, 2, cv::LINE_AA);
  label(picture, fmt::format("ball {:.0f} cm {:.0f} deg", ball.distance, ball.heading.deg()),
        at(ball.centre, scale) + cv::Point(radius + 4, 4), kOrange);
}

void drawLandmark(cv::Mat& picture, const LandmarkPercept& seen, int scale) {
  const cv::Point corner = at({seen.box.left, seen.box.top}, scale);
  cv::rectangle(picture, corner, at({seen.box.right, seen.box.bottom}, scale), inkFor(seen.kind),
                2);
  label(
      picture,
      fmt::format("{} {:.0f} cm {:.0f} deg", wordFor(seen.kind), seen.distance, seen.heading.deg()),
      corner + cv::Point(0, -4), inkFor(seen.kind));
}

void drawBox(cv::Mat& picture, const PixelBox& box, int scale, const cv::Scalar& colour,
             const std::string& text) {
  const cv::Point corner = at({box.left, box.top}, scale);
  cv::rectangle(picture, corner, at({box.right, box.bottom}, scale), colour, 1);
  label(picture, text, corner + cv::Point(0, -4), colour);
}

// A bar across the free stretch, with ticks at its ends; no tick where the image cuts it.
void drawGap(cv::Mat& picture, const GoalGap& gap, int scale) {
  const double y = gap.box.bottom;
  cv::line(picture, at({gap.box.left, y}, scale), at({gap.box.right, y}, scale), kGap, 2);
  if (!gap.leftCut)
    cv::line(picture, at({gap.box.left, gap.box.top}, scale), at({gap.box.left, y}, scale), kGap);
  if (!gap.rightCut)
    cv::line(picture, at({gap.box.right, gap.box.top}, scale), at({gap.box.right, y}, scale), kGap);
}

void drawPoints(cv::Mat& picture, const Percepts& seen, int scale) {
  for (const auto& point : seen.linePoints)
    cv::circle(picture, at(point.pixel, scale), 2, inkFor(point.kind), cv::FILLED);
  for (const auto& point : seen.obstacles)
    cv::drawMarker(picture, at(point.pixel, scale), kObstacle, cv::MARKER_TILTED_CROSS, 7, 2);
}

void drawOthers(cv::Mat& picture, const Percepts& seen, int scale) {
  for (const auto& robot : seen.robots)
    drawBox(picture, robot.box, scale, inkFor(robot.team),
            fmt::format("robot {:.0f} cm {:.0f} deg", robot.distance, robot.heading.deg()));
  for (const auto& patch : seen.pinkPatches)
    drawBox(picture, patch.box, scale, kPink, fmt::format("pink {:.0f} cm", patch.distance));
  for (const auto& gap : seen.gaps) drawGap(picture, gap, scale);
}

void drawGoal(cv::Mat& picture, const body::FieldDescription& field, double scale, bool own,
              const cv::Scalar& colour) {
  const double middle = field.width / 2;
  const double line = own ? 0.0 : field.length;
  const double back = own ? -field.goalDepth : field.length + field.goalDepth;
  const auto corner = onPicture(field, scale, {middle - field.goalWidth / 2, line});
  const auto opposite = onPicture(field, scale, {middle + field.goalWidth / 2, back});
  cv::rectangle(picture, corner, opposite, colour, cv::FILLED);
}

void drawRobot(cv::Mat& picture, const body::FieldDescription& field, double scale,
               const Pose2& pose, const cv::Scalar& colour) {
  // Neck base in front, body 20 cm behind it, 14 cm wide.
  const std::array<Point2<Robot>, 5> outline = {
      {{0.0, 5.0}, {7.0, 0.0}, {7.0, -20.0}, {-7.0, -20.0}, {-7.0, 0.0}}};
  std::vector<cv::Point> corners;
  corners.reserve(outline.size());
  for (const auto& corner : outline)
    corners.push_back(onPicture(field, scale, fieldFromRobot(pose, corner)));
  cv::polylines(picture, corners, true, colour, 2, cv::LINE_AA);
}

std::string wordFor(Role role) {
  return role == Role::none ? "" : std::string(" ") + kRoleNames[static_cast<std::size_t>(role)];
}

// What the log's own robot does, or what it heard that a mate does; nothing of opponents.
std::string roleOf(const TrueRobot& robot, const Moment& moment) {
  if (robot.own) return wordFor(moment.output.command.team.role);
  if (robot.team != moment.input.game.team) return "";
  for (const TeammateEstimate& mate : moment.output.world.teammates)
    if (mate.player == robot.player) return wordFor(mate.note.role);
  return "";
}

// The log's own robot is white, like its path; the others have their team's colour. Beside each
// stand its number and its role.
void drawTrueRobot(cv::Mat& picture, const body::FieldDescription& field, double scale,
                   const TrueRobot& robot, const Moment& moment) {
  drawRobot(picture, field, scale, robot.pose, robot.own ? kWhite : inkFor(robot.team));
  const Point2<Field> middle = fieldFromRobot(robot.pose, Point2<Robot>{0.0, -10.0});
  const cv::Point beside(static_cast<int>(14 * scale), 5);
  const std::string role = roleOf(robot, moment);
  if (!robot.own || !role.empty())
    label(picture, std::to_string(robot.player) + role, onPicture(field, scale, middle) + beside,
          kWhite);
}

void drawBelief(cv::Mat& picture, const body::FieldDescription& field, double scale,
                const WorldModel& world) {
  const auto& c = world.covariance;
  const double middle = 0.5 * (c[0] + c[4]);
  const double spread = std::sqrt(maths::square(0.5 * (c[0] - c[4])) + c[1] * c[1]);
  const double major = std::sqrt(std::max(0.0, middle + spread)) * scale;
  const double minor = std::sqrt(std::max(0.0, middle - spread)) * scale;
  const double angle = 0.5 * std::atan2(2.0 * c[1], c[0] - c[4]) * 180.0 / maths::kPi;
  const auto centre = onPicture(field, scale, world.pose.position);
  const cv::Size axes(static_cast<int>(maths::clamp(2 * major, 1.0, 3000.0)),
                      static_cast<int>(maths::clamp(2 * minor, 1.0, 3000.0)));
  cv::ellipse(picture, centre, axes, -angle, 0, 360, kPink, 1, cv::LINE_AA);
  const auto tip = onPicture(field, scale, fieldFromRobot(world.pose, Point2<Robot>{0.0, 20.0}));
  cv::arrowedLine(picture, centre, tip, kPink, 2, cv::LINE_AA, 0, 0.3);
  if (world.ball.present)
    cv::circle(picture, onPicture(field, scale, world.ball.position),
               std::max(3, static_cast<int>(6 * scale)), kPink, 2, cv::LINE_AA);
}

}  // namespace

cv::Point onPicture(const body::FieldDescription& field, double scale, Point2<Field> p) {
  return {static_cast<int>(std::lround((p.x + kMargin) * scale)),
          static_cast<int>(std::lround((field.length + kMargin - p.y) * scale))};
}

const TrueRobot* TruePlaces::own() const {
  const auto found =
      std::find_if(robots.begin(), robots.end(), [](const TrueRobot& robot) { return robot.own; });
  return found == robots.end() ? nullptr : &*found;
}

const char* wordFor(LandmarkKind kind) {
  switch (kind) {
    case LandmarkKind::goalBlue: return "blue goal";
    case LandmarkKind::goalYellow: return "yellow goal";
    case LandmarkKind::beaconBlueOnPink: return "blue/pink";
    case LandmarkKind::beaconPinkOnBlue: return "pink/blue";
    case LandmarkKind::beaconYellowOnPink: return "yellow/pink";
    default: return "pink/yellow";
  }
}

cv::Scalar inkFor(LandmarkKind kind) {
  switch (kind) {
    case LandmarkKind::goalBlue: return kBlue;
    case LandmarkKind::goalYellow: return kYellow;
    default: return kPink;
  }
}

cv::Scalar inkFor(TeamColour team) { return team == TeamColour::red ? kRed : kBlue; }

cv::Scalar inkFor(LinePointKind kind) {
  switch (kind) {
    case LinePointKind::line: return kLine;
    case LinePointKind::border: return kBorder;
    default: return kField;
  }
}

cv::Mat drawCamera(const FrameInput& input, const FrameOutput& output, int scale) {
  cv::Mat picture;
  cv::resize(picture::pictureOf(input.image), picture, {}, scale, scale, cv::INTER_NEAREST);
  drawLine(picture, output.body.horizon.atLeft, output.body.horizon.atRight, scale, kGrey);
  for (const auto& edge : output.percepts.fieldEdges)
    drawLine(picture, edge.atLeft, edge.atRight, scale, kRed);
  drawPoints(picture, output.percepts, scale);
  drawOthers(picture, output.percepts, scale);
  for (const auto& seen : output.percepts.landmarks) drawLandmark(picture, seen, scale);
  drawBall(picture, output.percepts.ball, scale);
  return picture;
}

void drawLines(cv::Mat& picture, const std::vector<std::string>& lines, cv::Point where, int width,
               double size, const cv::Scalar& colour) {
  constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
  const auto wide = [&](const std::string& text) {
    return cv::getTextSize(text, kFont, size, 1, nullptr).width > width;
  };
  for (std::string text : lines) {
    if (wide(text)) {
      while (text.size() > 1 && wide(text + "...")) text.pop_back();
      text += "...";
    }
    cv::putText(picture, text, where, kFont, size, colour, 1, cv::LINE_AA);
    where.y += kReasonLine;
  }
}

cv::Mat drawField(const body::FieldDescription& field, TeamColour team, double scale) {
  const cv::Size size(static_cast<int>((field.width + 2 * kMargin) * scale),
                      static_cast<int>((field.length + 2 * kMargin) * scale));
  cv::Mat picture(size, CV_8UC3, kCarpet);
  const bool red = team == TeamColour::red;
  drawGoal(picture, field, scale, true, red ? kYellow : kBlue);
  drawGoal(picture, field, scale, false, red ? kBlue : kYellow);
  const int width = std::max(1, static_cast<int>(std::lround(field.lineWidth * scale)));
  for (const auto& line : field.lines)
    cv::line(picture, onPicture(field, scale, line.start), onPicture(field, scale, line.end),
             kWhite, width, cv::LINE_AA);
  cv::circle(picture, onPicture(field, scale, {field.width / 2, field.length / 2}),
             static_cast<int>(field.circleDiameter / 2 * scale), kWhite, width, cv::LINE_AA);
  for (const auto& landmark : field.landmarks)
    if (landmark.kind > LandmarkKind::goalYellow)
      cv::circle(picture, onPicture(field, scale, landmark.position),
                 static_cast<int>(field.beaconRadius * scale) + 2, kPink, cv::FILLED, cv::LINE_AA);
  return picture;
}

void drawPaths(cv::Mat& picture, const body::FieldDescription& field, double scale,
               const Paths& paths) {
  const auto draw = [&](const std::vector<Point2<Field>>& path, const cv::Scalar& colour) {
    std::vector<cv::Point> points;
    points.reserve(path.size());
    for (const auto& p : path) points.push_back(onPicture(field, scale, p));
    cv::polylines(picture, points, false, colour, 2, cv::LINE_AA);
  };
  draw(paths.belief, kPink);
  draw(paths.ball, kOrange);
  draw(paths.robot, kWhite);
}

void drawPlaces(cv::Mat& picture, const body::FieldDescription& field, double scale,
                const Moment& moment) {
  drawBelief(picture, field, scale, moment.output.world);
  if (!moment.truth.present) return;
  for (const TrueRobot& robot : moment.truth.robots)
    drawTrueRobot(picture, field, scale, robot, moment);
  if (!moment.truth.ballThere) return;
  cv::circle(picture, onPicture(field, scale, moment.truth.ball),
             std::max(3, static_cast<int>(body::kBallRadius * scale)), kOrange, cv::FILLED,
             cv::LINE_AA);
}

}  // namespace kelpie::match
