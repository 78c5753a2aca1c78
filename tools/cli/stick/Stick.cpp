// SPDX-License-Identifier: Apache-2.0
// A robot's memory stick: as a folder, as an image, or on the stick itself.
#include <fmt/core.h>
#include <sys/stat.h>

#include <filesystem>
#include <memory>

#include "robot/stick/StdioFiles.h"
#include "robot/stick/StickFormat.h"
#include "tools/cli/Commands.h"
#include "tools/cli/Process.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/options/Config.h"
#include "tools/picture/FileNames.h"
#include "tools/stick/Behaviours.h"
#include "tools/stick/BootReads.h"
#include "tools/stick/MakeStick.h"
#include "tools/stick/Player.h"
#include "tools/stick/Programs.h"
#include "tools/stick/WlanFile.h"
#include "tools/stick/medium/FormerFiles.h"
#include "tools/stick/medium/StickDifference.h"
#include "tools/stick/medium/StickFolder.h"
#include "tools/stick/medium/StickImage.h"

namespace kelpie::cli {
namespace {

struct StickOptions {
  ConfigOptions config;
  std::string pycode = defaultScripts();
  std::string object;
  std::string wlan;
  std::string out;
  std::string diff;
  std::string install;
  bool replace = false;
  bool keepJamDetection = false;
};

// What a stick is made of, and what is reported to a person.
struct Parts {
  stick::StickContents contents;
  std::string player;       // empty without --object
  std::string unknownKeys;  // a line; empty: none
};

// What a robot of flesh plays with: a body with masses, and scripts that nobody edits meanwhile.
Expected<agent::AgentConfig> robotConfig(const StickOptions& options) {
  ConfigOptions request = options.config;
  request.body = Body::physical;
  auto config = makeConfig(request);
  if (config) config->behaviour.reload = false;
  return config;
}

Status take(const Expected<std::string>& bytes, std::string& place) {
  if (!bytes) return Error{bytes.error()};
  place = *bytes;
  return Done{};
}

Status takeWlan(const std::string& file, Parts& parts) {
  const auto settings = stick::readWlanFile(file);
  if (!settings) return Error{settings.error()};
  parts.contents.wlan = settings->text;
  parts.unknownKeys = stick::unknownKeysLine(*settings, file);
  return Done{};
}

Expected<Parts> readParts(const StickOptions& options) {
  Parts parts;
  parts.contents.relaxedJams = !options.keepJamDetection;
  Status status = checkScripts(options.pycode);
  const bool program = !options.object.empty();
  if (status && program) status = take(stick::playerOfFile(options.object), parts.player);
  if (status && program) status = take(stick::readWhole(options.object), parts.contents.object);
  if (status && !options.wlan.empty()) status = takeWlan(options.wlan, parts);
  if (status) status = take(stick::zipBehaviours(options.pycode), parts.contents.behaviours);
  if (!status) return Error{status.error()};
  return parts;
}

bool isImage(const std::string& out) { return picture::endingOf(out) == ".img"; }

Status verifyFolder(const std::string& root, const agent::AgentConfig& config) {
  stick::StdioFiles files(root.c_str());
  return stick::verifyStick(files, config);
}

Status writeOut(const StickOptions& options, const agent::AgentConfig& config,
                const stick::StickTree& tree) {
  if (isImage(options.out)) return stick::writeImage(tree, options.out);
  Status status = stick::checkFolder(tree, options.out);
  if (status) status = stick::writeFiles(tree, options.out, [](const std::string&) {});
  return status ? verifyFolder(options.out, config) : status;
}

// At once, so that who looks on sees each step before it is done.
void tell(const std::string& step) {
  fmt::print("{}\n", step);
  std::fflush(stdout);
}

// Nothing of another program, and no setting of the owner's, is replaced before it is kept.
// Settings alone need no --replace: no program is lost, and the options have asked for others.
Status keepFormer(const StickOptions& options, const stick::StickTree& tree) {
  const auto former = stick::formerFiles(tree, options.install);
  if (!former) return Error{former.error()};
  if (former->empty()) return Done{};
  if (!options.replace && stick::haveAnotherProgram(*former))
    return Error{options.install + ": another program's " + stick::namesOf(*former) +
                 " would be replaced; with --replace they are, and kept in a folder of the stick"};
  const auto folder = stick::keepFormer(*former, options.install, tell);
  if (!folder) return Error{folder.error()};
  tell((stick::haveAnotherProgram(*former) ? "another program's files are kept in "
                                           : "the settings that were there are kept in ") +
       *folder);
  return Done{};
}

Status install(const StickOptions& options, const agent::AgentConfig& config,
               const stick::StickTree& tree) {
  if (stick::findFile(tree, stick::kObjectPath) == nullptr)
    return Error{std::string("--install needs --object FILE, or the stick lacks ") +
                 stick::kObjectPath + " and does not play"};
  Status status = stick::checkMount(tree, options.install);
  if (status) status = keepFormer(options, tree);
  if (status) status = stick::writeFiles(tree, options.install, tell);
  return status ? verifyFolder(options.install, config) : status;
}

Status showDifference(const StickOptions& options, const agent::AgentConfig& config,
                      const stick::StickTree& tree) {
  const Status mount = stick::checkMount(tree, options.diff);
  if (!mount) return mount;
  for (const auto& line : stick::differenceLines(tree, config, options.diff))
    fmt::print("{}\n", line);
  return Done{};
}

void tellSizes(const std::string& where, const stick::StickTree& tree) {
  for (const auto& file : tree) fmt::print("{:>8} {}\n", file.bytes.size(), file.path);
  fmt::print("{}: {} files, {} bytes; the robot's reader takes them\n", where, tree.size(),
             stick::bytesOf(tree));
  if (stick::findFile(tree, stick::kObjectPath) == nullptr)
    fmt::print("without --object FILE it lacks {}: a robot does not play with it\n",
               stick::kObjectPath);
}

Status writeStick(const StickOptions& options) {
  const auto config = robotConfig(options);
  if (!config) return Error{config.error()};
  const auto parts = readParts(options);
  if (!parts) return Error{parts.error()};
  if (!parts->unknownKeys.empty()) tell(parts->unknownKeys);
  const auto tree = stick::makeTree(*config, parts->contents);
  if (!tree) return Error{tree.error()};
  Status status = Done{};
  if (!options.diff.empty()) status = showDifference(options, *config, *tree);
  if (status && !options.out.empty()) status = writeOut(options, *config, *tree);
  if (status && !options.install.empty()) status = install(options, *config, *tree);
  if (!status) return status;
  if (!options.out.empty()) tellSizes(options.out, *tree);
  if (!options.install.empty()) tellSizes(options.install, *tree);
  if (!options.object.empty()) fmt::print("{}\n", stick::playerLine(parts->player, options.pycode));
  const bool python = parts->player != "simple";
  fmt::print("{}\n", stick::bootLine(stick::bootReads(*tree, python)));
  return Done{};
}

int run(const StickOptions& options) {
  if (options.out.empty() && options.diff.empty() && options.install.empty())
    return fail("nothing to do: give --out, --diff or --install", kExitBadInput);
  catchInterrupts();  // so that no folder with a radio's key stays behind
  if (!options.wlan.empty()) umask(S_IRWXG | S_IRWXO);  // nor can others read it
  const Status written = writeStick(options);
  return written ? kExitDone : fail(written.error(), kExitBadInput);
}

}  // namespace

void addStick(CommandLine& app, int& code) {
  auto command = app.subcommand("stick",
                                "A robot's memory stick: configuration, behaviours, "
                                "program (docs/flash.md)");
  auto options = std::make_shared<StickOptions>();
  command.option("--robot", options->config.player, "The player's number, 1 to 4")
      .required()
      .check(integerInRange(1, 4));
  addConfigOptions(command, options->config);
  command.option("--pycode", options->pycode, "Folder of the behaviours").showDefault();
  command.option("--object", options->object, "The program, AGENT.BIN, linked with the SDK")
      .check(notEmpty());
  command
      .option("--wlan", options->wlan,
              "The radio's settings, KEY=VALUE a line, outside the repository")
      .check(notEmpty());
  command.option("--out", options->out, "Folder, or image when it ends in .img").check(notEmpty());
  command.option("--diff", options->diff, "Say what would change on the mounted stick")
      .check(notEmpty());
  const auto install =
      command.option("--install", options->install, "Write to the mounted stick").check(notEmpty());
  command
      .flag("--replace", options->replace,
            "Replace another program's files too, and keep them in a folder of the stick")
      .needs(install);
  command.flag("--keep-jam-detection", options->keepJamDetection,
               "Write no VRCOMM.CFG, which has the robot wait before it takes a joint for "
               "jammed");
  command.callback([options, &code] { code = run(*options); });
}

}  // namespace kelpie::cli
