// SPDX-License-Identifier: Apache-2.0
// Sticks to test with: a small one with every kind of file, folders of a test's own, and what
// Sony's system leaves on a programming stick, as empty files.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "robot/stick/StickFormat.h"
#include "tools/stick/MakeStick.h"
#include "tools/stick/Programs.h"
#include "tools/stick/medium/StickFolder.h"

namespace kelpie::stick {

namespace fs = std::filesystem;

inline std::unique_ptr<agent::AgentConfig> sampleConfig() {
  auto config = std::make_unique<agent::AgentConfig>();
  config->calibration = vision::nominalCalibration();
  config->team = TeamColour::blue;
  config->player = 3;
  config->field = *body::fieldDescription("osaka2005");
  config->behaviour.reload = false;
  agent::shareField(*config);
  return config;
}

inline StickContents sampleContents() {
  return {std::string(5000, '\x1f'), std::string("PK zip of behaviours\0 with a zero", 33),
          "ESSID=field\nETHER_IP=10.0.1.3\n"};
}

inline StickTree sampleTree() {
  const auto tree = makeTree(*sampleConfig(), sampleContents());
  EXPECT_TRUE(tree) << tree.error();
  return *tree;
}

inline void put(const fs::path& path, const std::string& bytes) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << bytes;
}

// A folder that looks like a mounted programming stick; without a radio when asked.
inline std::string mountedStick(const std::string& name, bool radio = true) {
  const fs::path root = fs::path(testing::TempDir()) / name;
  for (const auto* file : {"OPEN-R/APERIOS.GZ", "OPEN-R/APERINIT.GZ", "OPEN-R/BOOTPARA",
                           "OPEN-R/SYSTEM/OBJS/POWERMON.BIN", "OPEN-R/SYSTEM/CONF/OBJECT.CFG"})
    put(root / file, "Sony's");
  if (radio) put(root / "OPEN-R/SYSTEM/CONF/CARDDRV.CFG", "Sony's");
  return root.string();
}

inline void silently(const std::string& /*step*/) {}

}  // namespace kelpie::stick
