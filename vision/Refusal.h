// SPDX-License-Identifier: Apache-2.0
// Why a candidate was refused. The number is the place in VisionCounts::refused and in recorded
// logs: append, never reorder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <tuple>

#include "robot/core/types/Percepts.h"
#include "robot/core/types/RefusalNames.h"

namespace kelpie::vision {

enum class Refusal : std::uint8_t {
  ballTooSmall,
  ballFewEdges,     // too few edge points for a circle
  ballPoorCircle,   // edge points do not lie on one
  ballFewOrange,    // the circle is not filled with orange
  ballOtherColour,  // too much pink, red or yellow inside
  ballAboveHorizon,
  ballAboveFieldEdge,
  ballNoField,    // nothing green around it
  ballOffGround,  // size and direction do not fit a ball that lies on the ground
  ballTooFar,
  beaconTooSmall,
  beaconNoPartner,  // neither blue nor yellow right above or below the pink
  beaconBothSides,  // partner colour above and below
  beaconSizeRatio,
  beaconAspect,
  beaconBelowHorizon,
  beaconNoWhiteBelow,
  beaconElevation,  // its height does not fit its size
  beaconTooFar,
  goalTooSmall,
  goalAspect,
  goalAboveHorizon,
  goalNoField,
  goalIsBeacon,
  goalTooFar,
  goalNoHeight,  // neither upper nor lower edge inside the image
  goalAboveFieldEdge,
  bufferFull,
  goalWidth,      // its angle and distance make no 80 cm
  goalOpposite,   // the other goal is in the image and likelier, or less likely
  beaconCut,      // by two borders of the image
  beaconNoField,  // no carpet at the foot of its white part
  beaconOffFieldEdge,
  ballOnGoal,       // a goal's or beacon's colour right below it
  ballPartOfPatch,  // the orange is far larger than the circle
  goalOblique,      // seen from behind or along its goal line
  goalUnlikely,     // each check passed, but few of them well
  robotTooSmall,
  robotAboveHorizon,
  robotAboveFieldEdge,
  robotNoShell,  // neither white nor grey beside the patch
  robotOffGround,
  robotTooFar,
  pinkTooSmall,
  pinkIsBeacon,
  pinkAboveHorizon,
  pinkAboveFieldEdge,
  pinkOffGround,
  obstacleAboveHorizon,
  obstacleAboveFieldEdge,
  obstacleGreenAbove,  // a shadow: the carpet goes on right above it
  lineAmbiguous,       // too wide on the ground for a line, too narrow for a border
  lineInCorner,        // of the image, thesis 2004 equation 3.1
  lineInObject,        // inside the box of a ball or robot
  lineGreenBeside,     // a single white pixel
  borderGreenBeside,
  fieldNotGreen,     // green only along the scan
  lineNotInGreen,    // no two greens on one of its sides
  lineTooDim,        // hardly brighter than the carpet
  lineColoured,      // changes the chroma more than white on green does
  lineTooThin,       // on the ground narrower than a line
  borderTooShort,    // not as high as a border
  borderBent,        // its foot does not go on straight to both sides
  fieldUneven,       // brighter than the carpet above and below: a thin line
  pointTooFar,       // weight 0
  pointsTooFew,      // of a kind
  edgeFewFeatures,   // too few features on the carpet's borders
  edgeNoCorner,      // a further border with carpet beyond it, or no corner on the ground
  robotSize,         // its patch is too wide or too high at its distance
  robotOtherColour,  // as much pink, orange, blue or black as uniform
  robotOnAnother,    // specks of one team's colour on a robot of the other team
  beaconMerged,      // one of its bands is part of something far wider
  robotSpeck,        // its patches are far too small for so near a robot
  robotFeetNear,     // its feet should show: the image shows ground far behind where it stands
  poseOutOfRange,    // the camera's pose or the horizon is NaN or absurd: nothing is looked at
  beaconUnlikely,    // each check passed, but few of them well
  robotUnlikely,     // each check passed, but few of them well
  ballUnlikely,      // each check passed, but few of them well
};

// In the order of the numbers.
inline constexpr RefusalName<Refusal> kRefusalNames[] = {
    {Refusal::ballTooSmall, "ballTooSmall"},
    {Refusal::ballFewEdges, "ballFewEdges"},
    {Refusal::ballPoorCircle, "ballPoorCircle"},
    {Refusal::ballFewOrange, "ballFewOrange"},
    {Refusal::ballOtherColour, "ballOtherColour"},
    {Refusal::ballAboveHorizon, "ballAboveHorizon"},
    {Refusal::ballAboveFieldEdge, "ballAboveFieldEdge"},
    {Refusal::ballNoField, "ballNoField"},
    {Refusal::ballOffGround, "ballOffGround"},
    {Refusal::ballTooFar, "ballTooFar"},
    {Refusal::beaconTooSmall, "beaconTooSmall"},
    {Refusal::beaconNoPartner, "beaconNoPartner"},
    {Refusal::beaconBothSides, "beaconBothSides"},
    {Refusal::beaconSizeRatio, "beaconSizeRatio"},
    {Refusal::beaconAspect, "beaconAspect"},
    {Refusal::beaconBelowHorizon, "beaconBelowHorizon"},
    {Refusal::beaconNoWhiteBelow, "beaconNoWhiteBelow"},
    {Refusal::beaconElevation, "beaconElevation"},
    {Refusal::beaconTooFar, "beaconTooFar"},
    {Refusal::goalTooSmall, "goalTooSmall"},
    {Refusal::goalAspect, "goalAspect"},
    {Refusal::goalAboveHorizon, "goalAboveHorizon"},
    {Refusal::goalNoField, "goalNoField"},
    {Refusal::goalIsBeacon, "goalIsBeacon"},
    {Refusal::goalTooFar, "goalTooFar"},
    {Refusal::goalNoHeight, "goalNoHeight"},
    {Refusal::goalAboveFieldEdge, "goalAboveFieldEdge"},
    {Refusal::bufferFull, "bufferFull"},
    {Refusal::goalWidth, "goalWidth"},
    {Refusal::goalOpposite, "goalOpposite"},
    {Refusal::beaconCut, "beaconCut"},
    {Refusal::beaconNoField, "beaconNoField"},
    {Refusal::beaconOffFieldEdge, "beaconOffFieldEdge"},
    {Refusal::ballOnGoal, "ballOnGoal"},
    {Refusal::ballPartOfPatch, "ballPartOfPatch"},
    {Refusal::goalOblique, "goalOblique"},
    {Refusal::goalUnlikely, "goalUnlikely"},
    {Refusal::robotTooSmall, "robotTooSmall"},
    {Refusal::robotAboveHorizon, "robotAboveHorizon"},
    {Refusal::robotAboveFieldEdge, "robotAboveFieldEdge"},
    {Refusal::robotNoShell, "robotNoShell"},
    {Refusal::robotOffGround, "robotOffGround"},
    {Refusal::robotTooFar, "robotTooFar"},
    {Refusal::pinkTooSmall, "pinkTooSmall"},
    {Refusal::pinkIsBeacon, "pinkIsBeacon"},
    {Refusal::pinkAboveHorizon, "pinkAboveHorizon"},
    {Refusal::pinkAboveFieldEdge, "pinkAboveFieldEdge"},
    {Refusal::pinkOffGround, "pinkOffGround"},
    {Refusal::obstacleAboveHorizon, "obstacleAboveHorizon"},
    {Refusal::obstacleAboveFieldEdge, "obstacleAboveFieldEdge"},
    {Refusal::obstacleGreenAbove, "obstacleGreenAbove"},
    {Refusal::lineAmbiguous, "lineAmbiguous"},
    {Refusal::lineInCorner, "lineInCorner"},
    {Refusal::lineInObject, "lineInObject"},
    {Refusal::lineGreenBeside, "lineGreenBeside"},
    {Refusal::borderGreenBeside, "borderGreenBeside"},
    {Refusal::fieldNotGreen, "fieldNotGreen"},
    {Refusal::lineNotInGreen, "lineNotInGreen"},
    {Refusal::lineTooDim, "lineTooDim"},
    {Refusal::lineColoured, "lineColoured"},
    {Refusal::lineTooThin, "lineTooThin"},
    {Refusal::borderTooShort, "borderTooShort"},
    {Refusal::borderBent, "borderBent"},
    {Refusal::fieldUneven, "fieldUneven"},
    {Refusal::pointTooFar, "pointTooFar"},
    {Refusal::pointsTooFew, "pointsTooFew"},
    {Refusal::edgeFewFeatures, "edgeFewFeatures"},
    {Refusal::edgeNoCorner, "edgeNoCorner"},
    {Refusal::robotSize, "robotSize"},
    {Refusal::robotOtherColour, "robotOtherColour"},
    {Refusal::robotOnAnother, "robotOnAnother"},
    {Refusal::beaconMerged, "beaconMerged"},
    {Refusal::robotSpeck, "robotSpeck"},
    {Refusal::robotFeetNear, "robotFeetNear"},
    {Refusal::poseOutOfRange, "poseOutOfRange"},
    {Refusal::beaconUnlikely, "beaconUnlikely"},
    {Refusal::robotUnlikely, "robotUnlikely"},
    {Refusal::ballUnlikely, "ballUnlikely"},
};
constexpr std::size_t kRefusalCount = std::size(kRefusalNames);

static_assert(areInOrder(kRefusalNames), "each refusal has its name, in the order of the numbers");
static_assert(kRefusalCount <= std::tuple_size_v<decltype(VisionCounts::refused)>,
              "a log keeps a count of each");

inline void refuse(VisionCounts& counts, Refusal reason) {
  ++counts.refused[static_cast<std::size_t>(reason)];
}

}  // namespace kelpie::vision
