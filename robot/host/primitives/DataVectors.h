// SPDX-License-Identifier: Apache-2.0
// Builds the sensor and image vectors that the robot would send, and reads the command vectors that
// an object sends. All in the layouts of OPENR/ODataFormats.h.
#pragma once

#include <OPENR/RCRegion.h>

#include <string>
#include <vector>

#include "robot/core/types/Image.h"
#include "robot/host/world/WorldProtocol.h"

namespace kelpie::host {

class RobotPrimitives;

// Joints and sensors in an order that only the seed knows (0: the order of the tables), as the
// robot's is not documented either.
RCRegion* newSensorRegion(std::uint64_t orderSeed);
void fillSensors(RCRegion& region, std::uint32_t firstTick,
                 const std::array<RawSensors, kTicksPerMessage>& frames);

// Layer H alone; highPass: six rows per line instead of three.
RCRegion* newImageRegion(bool highPass);
// The last line becomes the tag with the field counter, as on the robot.
void fillImage(RCRegion& region, const Image& image, std::uint32_t fieldCounter);

// What a command vector orders. Empty text: all of it was understood; otherwise the first complaint
// about a part that was left out.
std::string readCommands(const RCRegion& region, const RobotPrimitives& primitives,
                         EffectorVector& out);

}  // namespace kelpie::host
