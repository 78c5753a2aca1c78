// SPDX-License-Identifier: Apache-2.0
// What came of a try of a skill, by the truth of its match and what the first robot saw and did in
// it (Played.h). A red robot tries; a blue one, where there is one, is in its way or keeps the
// goal.
#pragma once

#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/match/Played.h"

namespace kelpie::experiments {

// The first shot that follows a hold.
struct Aimed {
  bool shot = false;
  bool onTarget = false;  // it would cross the goal line between the posts
  double errorDeg = 0.0;  // left of the middle of the goal positive
};
Aimed aimedIn(const Played& played);

// A ball that gets 40 cm past the opponent, towards the goal, before it is out.
struct Dodged {
  bool passed = false;
  Share shots;  // that were made before the opponent, and got past it
};
Dodged dodgedIn(const Played& played, double limit);

// A ball that a hand puts out of sight at `thrown` (s), and is searched for `limit` (s).
struct Searched {
  bool watched = false;  // the robot had the ball before; else the try does not count
  bool lost = false;     // it did not have it at once
  double seconds = 0.0;  // from the throw until it has it again, rightly; else the limit
};
Searched searchedIn(const Played& played, double thrown, double limit);

// The blue keeper of the far goal.
struct Kept {
  bool setOff = false;  // it set off the ball that went into its goal itself
  Share outside;        // frames with its neck base beyond its box
};
Kept keptIn(const Played& played, bool scored);

// Holds of the ball, and whether any is a grab as it should be: kept, carried and let go within 3 s
// and 50 cm.
struct Grabbed {
  bool kept = false;
  bool success = false;
  int tooLong = 0;
  int tooFar = 0;
  Values holds;       // s; those that were kept
  Values grabs;       // frames of each
  Values quickGrabs;  // so, with infrared
};
Grabbed grabbedIn(const Played& played);

// A ball that is thrown past the robot at `thrown` (s) and watched for `limit` (s).
struct Met {
  bool reached = false;  // before it left
  bool kept = false;     // it did not leave at all
  double seconds = 0.0;  // from the throw until it is reached; else the limit
};
Met metIn(const Played& played, double thrown, double limit);

}  // namespace kelpie::experiments
