// SPDX-License-Identifier: Apache-2.0
// The field from above in a frame of a canvas, up-field up, and what happened on it: paths that
// fade with age, places, times. Paths are broken where somebody was carried.
#pragma once

#include <string>
#include <vector>

#include "robot/body/FieldDescription.h"
#include "tools/match/Draw.h"
#include "tools/picture/Canvas.h"

namespace kelpie::match {

// Points in the order of time; `from` is when the path begins to be as strong as it gets.
struct TimedPoint {
  double seconds = 0.0;
  Point2<Field> place;
};
using TimedPath = std::vector<TimedPoint>;

// "2, 5, 10, 20, 30, 60 ... s": the smallest that gives at most `most` marks in so many seconds.
double timeBetweenMarks(double seconds, int most);
// Where a path is at the multiples of that time, the first moment and what is broken left out.
TimedPath timeMarks(const TimedPath& path, double every);
// Pieces between two of which somebody carried what moves: faster than `fastest` cm/s, and farther
// than a jitter.
std::vector<TimedPath> unbroken(const TimedPath& path, double fastest);

// Where a label of each spot goes: `away` from it, to the side where the others are farthest.
std::vector<picture::Spot> besideEach(const std::vector<picture::Spot>& spots, double away);

class FieldDrawing {
 public:
  // The height follows from the width.
  FieldDrawing(const body::FieldDescription& field, TeamColour team, double left, double top,
               double width);

  double height() const { return frame_.height; }
  picture::Spot spot(Point2<Field> place) const;
  double pixels(double cm) const { return cm * scale_; }
  const picture::Frame& frame() const { return frame_; }

  void ground(picture::Canvas& canvas) const;
  // At the left side, the way that the team attacks.
  void attack(picture::Canvas& canvas, const std::string& words) const;
  // Strongest at `now`, weakest `fade` seconds before it and earlier.
  struct Fading {
    double now = 0.0;
    double fade = 1.0;
  };
  void robotPath(picture::Canvas& canvas, const TimedPath& path, const Fading& fading) const;
  void ballPath(picture::Canvas& canvas, const TimedPath& path, const Fading& fading) const;
  void belief(picture::Canvas& canvas, const TimedPath& path) const;
  void marks(picture::Canvas& canvas, const TimedPath& marks) const;
  // All robots and the ball, and what the log's robot believes.
  void places(picture::Canvas& canvas, const Moment& moment) const;
  // Numbers 1, 2, ... beside their places, apart from each other.
  void badges(picture::Canvas& canvas, const std::vector<Point2<Field>>& places) const;

 private:
  void fadingPath(picture::Canvas& canvas, const std::vector<TimedPath>& pieces,
                  const Fading& fading, const picture::Ink& ink, double width) const;
  void goal(picture::Canvas& canvas, bool own) const;
  void robot(picture::Canvas& canvas, const TrueRobot& robot) const;
  void believed(picture::Canvas& canvas, const WorldModel& world) const;

  const body::FieldDescription& field_;
  TeamColour team_;
  picture::Frame frame_;
  double scale_;
};

// A number in a circle.
void drawBadge(picture::Canvas& canvas, picture::Spot middle, int number);

}  // namespace kelpie::match
