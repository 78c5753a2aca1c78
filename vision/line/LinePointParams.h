// SPDX-License-Identifier: Apache-2.0
// Tunables of line, border and deep field points. `whiteOverGreen` depends on paint and carpet: the
// nominal colours have 189 over 77; a wrong one moves only the width of lines below two pixels.
#pragma once

#include "robot/core/Angle.h"
#include "robot/core/fields/Fields.h"

namespace kelpie::vision {

struct LinePointParams {
  double minStep = 12;           // grey levels of Y over two pixels, at both edges
  double minContrast = 14;       // grey levels, the brightest pixel above the carpet
  double maxChroma = 40;         // grey levels that Cr and Cb may change by, facts-2005 4.2
  double maxSegment = 60;        // px of white; more is never a line
  double widthTolerance = 0.4;   // of the line's width
  double widthSlack = 0.6;       // px, on top of it
  double whiteOverGreen = 2.4;   // brightness of paint over that of carpet
  double besideReach = 3;        // px to both sides in which a line must go on
  double cornerBuffer = 10;      // px, thesis 2004 equation 3.1
  double objectMargin = 2;       // px around the boxes of ball, landmarks and robots
  double borderMin = 20;         // px without green that make a border, checklist U10
  double borderShare = 0.85;     // of the height that must be white
  double borderWhite = 0.7;      // of these pixels
  double borderReach = 6;        // px to both sides in which its foot must go on
  double borderBend = 2;         // px that it may be off a straight line there
  double borderSide = 15;        // px to each side, thesis 2004 3.1.3
  double fieldSpacing = 25;      // cm between field points along a grid line
  double minFieldInterval = 4;   // px, of the field interval
  double maxFieldInterval = 40;  // px
  double fieldBump = 8;          // grey levels that a point may be brighter than 4 px away
  double fieldSide = 15;         // px to each side that must be green, thesis 2004 3.1.3
  double fieldMaxOther = 2;      // of these not green
  double fullWeight = 70;        // cm, thesis 2004 3.2.1
  double noWeight = 350;         // cm
  bool linearWeight = true;      // in the distance (thesis 2004); false: in its square (2005)
  double minOfKind = 4;          // fewer points of a kind are dropped, thesis 2004 3.2.1
  // Per frame. Checklist U11 proposes 3 deg, 2005 took 0.09 rad. With the turn during the exposure
  // taken into account the median error within 150 cm is 0.7 cm at rest and 0.7 to 1.4 cm at 4 to
  // 5 deg, the fastest measured (`kelpie evaluate line-points`).
  Angle maxHeadSpeed = Angle::deg(5.2);

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("minStep", &LinePointParams::minStep, "", 1, 100),
                     field("minContrast", &LinePointParams::minContrast, "", 1, 200),
                     field("maxChroma", &LinePointParams::maxChroma, "", 1, 255),
                     field("maxSegment", &LinePointParams::maxSegment, "px", 1, 160),
                     field("widthTolerance", &LinePointParams::widthTolerance, "", 0, 5),
                     field("widthSlack", &LinePointParams::widthSlack, "px", 0, 10),
                     field("whiteOverGreen", &LinePointParams::whiteOverGreen, "", 1.1, 10),
                     field("besideReach", &LinePointParams::besideReach, "px", 1, 10),
                     field("cornerBuffer", &LinePointParams::cornerBuffer, "px", 0, 60),
                     field("objectMargin", &LinePointParams::objectMargin, "px", 0, 40),
                     field("borderMin", &LinePointParams::borderMin, "px", 1, 100),
                     field("borderShare", &LinePointParams::borderShare, "", 0, 1),
                     field("borderWhite", &LinePointParams::borderWhite, "", 0, 1),
                     field("borderReach", &LinePointParams::borderReach, "px", 1, 30),
                     field("borderBend", &LinePointParams::borderBend, "px", 0, 20),
                     field("borderSide", &LinePointParams::borderSide, "px", 1, 60),
                     field("fieldSpacing", &LinePointParams::fieldSpacing, "cm", 1, 200),
                     field("minFieldInterval", &LinePointParams::minFieldInterval, "px", 2, 100),
                     field("maxFieldInterval", &LinePointParams::maxFieldInterval, "px", 2, 160),
                     field("fieldBump", &LinePointParams::fieldBump, "", 0, 100),
                     field("fieldSide", &LinePointParams::fieldSide, "px", 1, 60),
                     field("fieldMaxOther", &LinePointParams::fieldMaxOther, "", 0, 60),
                     field("fullWeight", &LinePointParams::fullWeight, "cm", 1, 500),
                     field("noWeight", &LinePointParams::noWeight, "cm", 2, 1000),
                     field("linearWeight", &LinePointParams::linearWeight),
                     field("minOfKind", &LinePointParams::minOfKind, "", 0, 100),
                     field("maxHeadSpeed", &LinePointParams::maxHeadSpeed, "rad/frame", 0, 180));
  }
};

}  // namespace kelpie::vision
