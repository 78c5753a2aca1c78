// SPDX-License-Identifier: Apache-2.0
// The bytes of the world's messages, as examples/agent/README.md tells them to strangers.
#include <gtest/gtest.h>

#include "robot/core/fields/Encoding.h"
#include "robot/core/types/Image.h"
#include "robot/host/world/WorldProtocol.h"

namespace kelpie::host {
namespace {

using Bytes = std::vector<std::uint8_t>;

template <class T>
Bytes bytesOf(const T& value) {
  Bytes bytes;
  encode(value, bytes);
  return bytes;
}

TEST(WorldProtocol, AStepHasItsPartsWhereStrangersLookForThem) {
  WorldStep step;
  step.sensorsPresent = true;
  step.firstTick = 7;
  step.sensors[3].sensors[14] = 9;
  step.vectorsDone = 2;
  step.imagePresent = true;
  step.control.bytes.resize(120);
  const Bytes bytes = bytesOf(step);
  EXPECT_EQ(bytes[8], 1);
  EXPECT_EQ(bytes[9], 7);
  EXPECT_EQ(bytes[13 + 4 * (4 * 51 - 1)], 9);
  EXPECT_EQ(bytes[829], 2);
  EXPECT_EQ(bytes[833], 1);
  EXPECT_EQ(bytes[834], 120);
  EXPECT_EQ(bytes.size(), 838U + 120U + 16U + 4U);
}

TEST(WorldProtocol, AReplyIsAsLongAsStrangersAreTold) {
  AgentReply reply;
  EXPECT_EQ(bytesOf(reply).size(), 1U + 4U + 8U + 4U + 4U);
  reply.vectors.push_back({});
  EXPECT_EQ(bytesOf(reply).size(), 21U + 1168U);
  EXPECT_EQ(bytesOf(AgentHello{TeamColour::blue, 3}), (Bytes{1, 3}));
  EXPECT_EQ(bytesOf(Image{}).size(), 3U * 208U * 160U);
}

}  // namespace
}  // namespace kelpie::host
