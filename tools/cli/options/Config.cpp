// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/options/Config.h"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <filesystem>

#include "robot/body/FieldDescription.h"
#include "robot/core/parameters/ParameterFile.h"
#include "tools/cli/DataFolder.h"
#include "tools/sim/bodies/FastActuator.h"

namespace kelpie::cli {
namespace {

Status setInitialPose(const std::string& text, gps::InitialPose& initial) {
  double numbers[3] = {};
  const char* next = text.data();
  const char* const end = text.data() + text.size();
  for (int i = 0; i < 3; ++i) {
    if (i > 0 && (next == end || *next++ != ',')) next = nullptr;
    if (next == nullptr) break;
    const auto [rest, error] = std::from_chars(next, end, numbers[i]);
    const bool sane = std::isfinite(numbers[i]) && std::fabs(numbers[i]) < 2000.0;
    next = error == std::errc() && sane ? rest : nullptr;
    if (next == nullptr) break;
  }
  if (next != end) return Error{"--init " + text + ": expected x,y,heading in cm and degrees"};
  initial.present = true;
  initial.pose = {{numbers[0], numbers[1]}, Angle::deg(numbers[2])};
  return Done{};
}

void addSections(ParameterSet& set, agent::AgentConfig& config) {
  set.add("field", config.field);
  set.add("body", config.body);
  set.add("vision", config.vision);
  set.add("gps", config.gps);
  set.add("behaviour", config.behaviour);
  set.add("actuator", config.actuator);
  set.add("game", config.game);
  set.add("camera", config.camera);
}

// KEY=NUMBER, with the key's unit if it has one, or true or false.
Status setParameter(const std::string& words, ParameterSet& set) {
  const std::size_t equals = words.find('=');
  const std::string key = words.substr(0, equals);
  const std::string value = equals == std::string::npos ? "" : words.substr(equals + 1);
  double number = value == "true" ? 1.0 : 0.0;
  const bool truth = value == "true" || value == "false";
  const char* const end = value.data() + value.size();
  const auto [rest, error] = std::from_chars(value.data(), end, number);
  if (!truth && error != std::errc())
    return Error{"--set " + words + ": expected KEY=NUMBER, or true or false"};
  const bool measured = !truth && rest != end;
  const Status assigned = measured ? set.assign(key, value) : set.assign(key, number);
  return assigned ? assigned : Status(Error{"--set " + words + ": " + assigned.error()});
}

Status overlayParameters(const ConfigOptions& options, ParameterSet& set) {
  for (const auto& file : options.params) {
    const Status read = set.overlay(file);
    if (!read) return read;
  }
  for (const auto& words : options.set) {
    const Status assigned = setParameter(words, set);
    if (!assigned) return assigned;
  }
  return Done{};
}

Status applyCalibration(const ConfigOptions& options, vision::VisionCalibration& calibration) {
  if (!options.colourTable.empty()) {
    const auto table = vision::loadColourTable(options.colourTable);
    if (!table) return Error{table.error()};
    calibration.colour = *table;
  }
  if (!options.ring.empty()) {
    const auto ring = vision::loadRingTable(options.ring);
    if (!ring) return Error{ring.error()};
    calibration.ring = *ring;
  }
  return Done{};
}

}  // namespace

void addConfigOptions(CommandLine& command, ConfigOptions& options) {
  command.option("--field", options.field, "2006, osaka2005 or 2004");
  command.option("--team", options.team, "red (attacks the blue goal) or blue")
      .check(oneOf({"red", "blue"}));
  command.option("--colour-table", options.colourTable,
                 "Colour table: Kelpie's own or the 128^3 bytes of 2005");
  command.option("--ring", options.ring, "Ring correction: nominal, none, 2006 or a file");
  command.option("--init", options.initial, "Known start: x,y,heading in cm and degrees");
  command.option("--params", options.params, "TOML files, general to specific");
  command.option("--set", options.set,
                 "One parameter each, over the files': KEY=NUMBER or KEY=80cm, or true or false");
}

Status applyConfig(const ConfigOptions& options, agent::AgentConfig& config) {
  std::vector<std::string> files = options.params;
  files.push_back(options.colourTable);
  files.push_back(options.ring);
  for (const auto& file : files)
    if (std::filesystem::is_directory(file)) return Error{file + ": is a folder, not a file"};
  if (!options.field.empty()) {
    const auto field = body::fieldDescription(options.field);
    if (!field) return Error{field.error()};
    config.field = *field;
    config.gps.pinks.wall = body::wallAround(*field, gps::kWallBeyondCarpet);
  }
  if (!options.team.empty())
    config.team = options.team == "blue" ? TeamColour::blue : TeamColour::red;
  if (options.player > 0) config.player = static_cast<std::uint8_t>(options.player);
  const Status calibration = applyCalibration(options, config.calibration);
  if (!calibration) return calibration;
  // A table from a file does not tell what its surfaces look like (LightParams); the parameters
  // that `kelpie calibrate colour` writes beside it do, and put this on again.
  if (!options.colourTable.empty()) config.vision.light.follow = false;
  if (options.body != Body::asItIs) config.gps.stuck.byLoad = options.body == Body::physical;
  if (options.body == Body::fast) sim::makeFast({}, config.actuator);
  ParameterSet set;
  addSections(set, config);
  const Status overlaid = overlayParameters(options, set);
  if (!overlaid) return overlaid;
  agent::shareField(config);
  if (options.initial.empty()) return Done{};
  return setInitialPose(options.initial, config.gps.initialPose);
}

Expected<agent::AgentConfig> makeConfig(const ConfigOptions& options) {
  return makeConfig(options, vision::nominalCalibration());
}

Expected<agent::AgentConfig> makeConfig(const ConfigOptions& options,
                                        const vision::VisionCalibration& nominal) {
  agent::AgentConfig config;
  config.calibration = nominal;
  ConfigOptions request = options;
  if (request.field.empty()) request.field = "2006";
  const Status applied = applyConfig(request, config);
  if (!applied) return Error{applied.error()};
  return config;
}

std::map<std::string, std::string> parameterNotes(const ConfigOptions& options) {
  agent::AgentConfig config;
  ParameterSet set;
  addSections(set, config);
  static_cast<void>(overlayParameters(options, set));  // was read before, by applyConfig
  std::map<std::string, std::string> notes;
  for (const auto& change : set.changes())
    notes[change.key] =
        change.value + " (default " + change.defaultValue + ") from " + change.source;
  notes["hash"] = fmt::format("{:016x}", set.hash());
  return notes;
}

Status checkScripts(const std::string& scripts) {
  std::error_code error;
  const std::filesystem::path folder(scripts);
  if (!std::filesystem::exists(folder, error)) return Error{scripts + ": does not exist"};
  if (std::filesystem::is_directory(folder, error) &&
      !std::filesystem::exists(folder / "main.py", error))
    return Error{scripts + "/main.py: does not exist"};
  return Done{};
}

std::string defaultScripts() { return dataFolder() + "/pycode"; }
std::string defaultTeam() { return dataFolder() + "/teams/kelpie"; }

}  // namespace kelpie::cli
