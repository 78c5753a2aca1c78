// SPDX-License-Identifier: Apache-2.0
// Some seconds of a robot's whole object over a stick in a folder, and what came of it: somebody
// presses its head, so that it stands up if it can.
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "robot/host/AgentStub.h"
#include "robot/host/HostSystem.h"
#include "robot/object/RobotAgent.h"
#include "tests/host/FakeWorld.h"
#include "tests/stick/Sticks.h"

namespace kelpie::object {

struct Played {
  std::vector<std::uint32_t> leds;
  double firstPan = 0.0;
  double lastPan = 0.0;
  double lastKnee = 0.0;
  std::uint32_t gains = 0;
  bool motorPower = false;
  std::string log;
};

inline std::string textOf(std::FILE* file) {
  std::rewind(file);
  std::string text;
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
  std::fclose(file);
  return text;
}

constexpr std::size_t kMessages = 100;  // of 32 ms

inline void addSeconds(host::FakeSource& source) {
  for (std::size_t i = 0; i < kMessages; ++i) {
    source.addSensors(1);
    const bool pressed = i >= 30 && i < 40;
    for (host::RawSensors& raw : source.steps.back().sensors)
      raw.sensors[openr::index(openr::Sensor::headTouch)] = pressed ? 40 : 0;
    source.addImage(32000 * (static_cast<std::int64_t>(i) + 1) + 10000);
  }
}

inline Played played(const std::string& root) {
  host::FakeSource source;
  addSeconds(source);
  host::HostParams params;
  params.printTo = std::tmpfile();
  const auto object = std::make_unique<RobotAgent>(root.c_str());
  host::HostSystem system(source, params);
  const auto summary = system.run(host::agentStub(*object), {});
  EXPECT_TRUE(summary) << summary.error();
  Played result;
  for (const auto& reply : source.replies)
    for (const auto& vector : reply.vectors) result.leds.push_back(vector.leds);
  const JointAngles first = host::anglesOf(source.replies.at(0).vectors[0].targets[0]);
  const JointAngles last =
      host::anglesOf(source.replies.at(2 * kMessages - 2).vectors[0].targets[3]);
  result.firstPan = first[Joint::headPan].deg();
  result.lastPan = last[Joint::headPan].deg();
  result.lastKnee = last[Joint::leftFrontKnee].deg();
  for (const auto& reply : source.replies) {
    result.gains |= reply.gains;
    result.motorPower = result.motorPower || reply.motorPower;
  }
  result.log = textOf(params.printTo);
  return result;
}

inline std::string folderOf(const stick::StickTree& tree, const std::string& name) {
  const stick::fs::path root = stick::fs::path(testing::TempDir()) / ("object_" + name);
  stick::fs::remove_all(root);
  for (const auto& file : tree) stick::put(root / file.path, file.bytes);
  return root.string();
}

}  // namespace kelpie::object
