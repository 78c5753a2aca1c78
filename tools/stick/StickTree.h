// SPDX-License-Identifier: Apache-2.0
// A stick's files in memory, in the order in which they are written: STICK.BIN, which lists the
// others, is the last. Only ours: Sony's system files are the user's and are never touched.
#pragma once

#include <string>
#include <vector>

#include "robot/stick/StickFiles.h"

namespace kelpie::stick {

struct TreeFile {
  std::string path;  // "OPEN-R/MW/CONF/OBJECT.CFG"
  std::string bytes;
};
using StickTree = std::vector<TreeFile>;

constexpr const char* kObjectListPath = "OPEN-R/MW/CONF/OBJECT.CFG";
constexpr const char* kConnectPath = "OPEN-R/MW/CONF/CONNECT.CFG";
constexpr const char* kDesignPath = "OPEN-R/MW/CONF/DESIGNDB.CFG";
constexpr const char* kJamPath = "OPEN-R/SYSTEM/CONF/VRCOMM.CFG";
constexpr const char* kWlanPath = "OPEN-R/SYSTEM/CONF/WLANCONF.TXT";

std::size_t bytesOf(const StickTree& tree);
// Nothing when the tree has no such file.
const TreeFile* findFile(const StickTree& tree, const std::string& path);

// Every name of the path has at most eight characters, a dot and three more, of A-Z, 0-9, _ and -.
bool isShortName(const std::string& path);

// The tree as the robot's reader sees files.
class TreeFiles : public StickFiles {
 public:
  explicit TreeFiles(const StickTree& tree) : tree_(tree) {}
  bool open(const char* path) override;
  std::int32_t read(std::uint8_t* to, std::size_t count) override;
  void close() override { file_ = nullptr; }

 private:
  const StickTree& tree_;
  const TreeFile* file_ = nullptr;
  std::size_t at_ = 0;
};

}  // namespace kelpie::stick
