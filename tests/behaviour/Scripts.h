// SPDX-License-Identifier: Apache-2.0
// A folder of behaviours of its own for each test, and frames to run them on.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "behaviour/Behaviour.h"

namespace kelpie::behaviour {

class Scripts {
 public:
  Scripts() {
    std::string pattern = (std::filesystem::temp_directory_path() / "kelpieXXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  explicit Scripts(const std::string& decideBody) : Scripts() { writeDecide(decideBody); }
  ~Scripts() { std::filesystem::remove_all(folder_); }
  Scripts(const Scripts&) = delete;
  Scripts& operator=(const Scripts&) = delete;

  void write(const std::string& name, const std::string& text) const {
    const std::filesystem::path path = folder_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  void writeDecide(const std::string& body) const {
    write("main.py", "import kelpie\nimport math\n\ndef decide(world):\n    " + body + "\n");
  }
  void remove(const std::string& name) const { std::filesystem::remove_all(folder_ / name); }
  std::string path() const { return folder_.string(); }

 private:
  std::filesystem::path folder_;
};

// One loop around a state: counts frames and looks at the files in each of them.
class HostRun {
 public:
  explicit HostRun(const Scripts& scripts) : state(scripts.path()) { params.reloadFrames = 1; }
  HostRun(const Scripts& scripts, const HostRun& beside)
      : state(scripts.path(), {}, &beside.state) {}
  HostRun(const Scripts& scripts, const Constants& constants, const HostRun& beside)
      : state(scripts.path(), constants, &beside.state) {}

  Command step() {
    input.frame += 1;
    input.time = TimeUs::fromSeconds(input.frame * kFrameSeconds);
    return behaviour::step({input, percepts, world, field, infrared}, params, state);
  }

  FrameInput input;
  Percepts percepts;
  WorldModel world;
  body::FieldDescription field;
  body::InfraredParams infrared;
  BehaviourParams params;
  BehaviourState state;
};

}  // namespace kelpie::behaviour
