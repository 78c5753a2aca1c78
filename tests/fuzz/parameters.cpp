// SPDX-License-Identifier: Apache-2.0
// A file of parameters of any text (a robot's, a field's, a team's, a walk's): refused with a line
// that names the file, and nothing of it is applied; or all is within its ranges.
#include <memory>

#include "robot/agent/AgentConfig.h"
#include "robot/core/fields/FieldCheck.h"
#include "robot/core/parameters/ParameterFile.h"
#include "tests/fuzz/Input.h"

namespace {

using namespace kelpie;
using fuzz::require;

// Calls visit("gps", member) for the sections that a file may have.
template <class Visit>
void forEachSection(agent::AgentConfig& config, Visit visit) {
  visit("field", config.field);
  visit("body", config.body);
  visit("vision", config.vision);
  visit("gps", config.gps);
  visit("behaviour", config.behaviour);
  visit("actuator", config.actuator);
  visit("game", config.game);
  visit("camera", config.camera);
}

// Made once, because the names of thousands of parameters are; each input begins with the defaults.
struct Parameters {
  const std::unique_ptr<agent::AgentConfig> defaults = std::make_unique<agent::AgentConfig>();
  const std::unique_ptr<agent::AgentConfig> config = std::make_unique<agent::AgentConfig>();
  ParameterSet set;

  Parameters() {
    forEachSection(*config, [&](const char* name, auto& section) { set.add(name, section); });
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Parameters all;
  *all.config = *all.defaults;
  static const std::uint64_t kUntouched = all.set.hash();
  const fuzz::File file(fuzz::Bytes(data, data + size), ".toml");
  const Status read = all.set.overlay(file.name());
  if (!read) {
    fuzz::requireLine(read.error(), file.name());
    require(all.set.hash() == kUntouched, "nothing of a refused file is applied");
    return 0;
  }
  forEachSection(*all.config, [](const char* name, const auto& section) {
    std::string why;
    require(verify(section, &why), std::string(name) + " is in range: " + why);
  });
  for (const ParameterChange& change : all.set.changes())
    require(!change.text().empty(), "a change can be told");
  return 0;
}
