// SPDX-License-Identifier: Apache-2.0
// What a simulated world and one agent process say to each other over a Unix-domain stream socket.
// Lock-stepped: the world sends WorldStep (followed by Image when imagePresent), and waits for the
// AgentReply before its time goes on. Each message is a MessageHeader and a body encoded from its
// field list (robot/core/fields/Encoding.h). The agent learns here only what the robot's own
// sensors, camera and game controller would tell it, in the robot's own numbers (RawFrame.h).
#pragma once

#include <array>
#include <cstdint>

#include "robot/core/FixedVector.h"
#include "robot/core/types/ControlPacket.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Motion.h"
#include "robot/core/types/Radio.h"
#include "robot/host/primitives/RawFrame.h"

namespace kelpie::host {

constexpr std::uint32_t kWorldMagic = 0x4b4c5031;  // "1PLK" in memory

// The last two pass between an agent and its driver (DriverProtocol.h).
enum class MessageType : std::uint32_t { hello, step, image, reply, goodbye, view, drive };

struct MessageHeader {
  std::uint32_t magic = kWorldMagic;
  MessageType type = MessageType::hello;
  std::uint32_t size = 0;  // bytes of the body
};

// Agent to world, once: who is there.
struct AgentHello {
  TeamColour team = TeamColour::red;
  std::uint8_t player = 1;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("team", &AgentHello::team, "", 0, 1),
                     field("player", &AgentHello::player, "", 1, 4));
  }
};

// World to agent. Time is that of the end of the step. A step brings four sensor ticks, or an
// image, or both; sensors come every 32 ms, images every 1/30 s.
struct WorldStep {
  TimeUs time;
  bool sensorsPresent = false;
  std::uint32_t firstTick = 0;  // number of the first of the four 8 ms ticks
  std::array<RawSensors, kTicksPerMessage> sensors{};
  std::uint32_t vectorsDone = 0;  // command vectors whose output has ended since the last step
  bool imagePresent = false;      // an image message follows; its exposure ended at `time`
  ControlPacket control;          // of the game controller; empty: none has come
  double batteryCurrent = 0.0;    // mA
  double batteryCharge = 1.0;     // share of a full one
  RadioPackets packets;           // heard since the last step

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(
        field("time", &WorldStep::time, "us"), field("sensorsPresent", &WorldStep::sensorsPresent),
        field("firstTick", &WorldStep::firstTick), field("sensors", &WorldStep::sensors),
        field("vectorsDone", &WorldStep::vectorsDone),
        field("imagePresent", &WorldStep::imagePresent), field("control", &WorldStep::control),
        field("batteryCurrent", &WorldStep::batteryCurrent, "mA", 0, 2e4),
        field("batteryCharge", &WorldStep::batteryCharge, "", 0, 1),
        field("packets", &WorldStep::packets));
  }
};

// One OPEN-R command vector: targets for `ticks` ticks of 8 ms. Joints outside `joints` keep their
// target.
constexpr std::size_t kMaxVectorTicks = 16;
struct EffectorVector {
  std::uint32_t ticks = 0;
  std::uint32_t joints = 0;  // bit i: joint i is commanded
  std::array<RawJoints, kMaxVectorTicks> targets{};
  std::uint32_t leds = 0;
  std::uint32_t ears = 0;  // bit 0: left up, bit 1: right up

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(
        field("ticks", &EffectorVector::ticks, "", 0, kMaxVectorTicks),
        field("joints", &EffectorVector::joints), field("targets", &EffectorVector::targets),
        field("leds", &EffectorVector::leds), field("ears", &EffectorVector::ears, "", 0, 3));
  }
};

// Agent to world, after each step: what was sent to the effectors meanwhile.
struct AgentReply {
  bool motorPower = false;
  std::uint32_t gains = 0;  // bit i: the gain of joint i is enabled
  double legGain = 1.0;     // proportional gain of the leg joints over the standard one, their mean
  FixedVector<EffectorVector, 4> vectors;
  RadioPacket packet;  // sent meanwhile; empty: none

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("motorPower", &AgentReply::motorPower),
                     field("gains", &AgentReply::gains),
                     field("legGain", &AgentReply::legGain, "", 0.05, 10),
                     field("vectors", &AgentReply::vectors), field("packet", &AgentReply::packet));
  }
};

// World to agent: the match is over.
struct Goodbye {
  std::uint8_t reason = 0;  // 0 match over, 1 the world stops early

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("reason", &Goodbye::reason));
  }
};

}  // namespace kelpie::host
