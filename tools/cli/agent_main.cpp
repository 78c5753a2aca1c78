// SPDX-License-Identifier: Apache-2.0
// kelpie-agent: one robot's brain as a process. Talks to a simulated world through the
// OPEN-R-shaped services and writes its log. `kelpie play` starts it; by hand it joins any
// kelpie-world.
#include <fmt/core.h>

#include <exception>
#include <memory>
#include <optional>

#include "robot/agent/loops/AgentLoops.h"
#include "robot/host/RecordingSource.h"
#include "robot/host/RunAgent.h"
#include "robot/host/radio/UdpControl.h"
#include "robot/host/radio/UdpRadio.h"
#include "robot/host/world/DriverLink.h"
#include "robot/host/world/WorldSource.h"
#include "robot/net/GameControlData.h"
#include "tools/cli/AgentTalk.h"
#include "tools/cli/Process.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/log/Logs.h"
#include "tools/cli/match/Describe.h"
#include "tools/cli/options/Config.h"
#include "tools/session/Confinement.h"
#include "tools/sim/referee/UnusedControl.h"

namespace kelpie::cli {
namespace {

constexpr std::uint32_t kStatusFrames = 15;  // twice a simulated second

struct AgentOptions {
  std::string socket;
  std::string recording;
  std::string log;
  std::string pycode = defaultScripts();
  double dropRate = 0.0;
  std::uint64_t seed = 1;
  bool status = false;
  bool allImages = false;
  bool noImages = false;
  bool planes = false;
  bool plainLog = false;
  bool patient = false;
  std::string driver;
  std::string radio = "world";
  std::uint16_t controller = 0;  // UDP port; 0: heard through the world
  ConfigOptions config;
  bool physical = true;
  bool again = false;
  bool confined = false;
};

// Passes frames on to the log and the driver, if there are such, and says now and then what the
// robot believes.
class AgentSink : public agent::LogSink {
 public:
  AgentSink(LogFile* log, host::DriverLink* driver, bool status)
      : log_(log), driver_(driver), status_(status) {}
  void motion(const MotionInput& input, const MotionOutput& output) override {
    if (log_ != nullptr) log_->motion(input, output);
  }
  void frame(const FrameInput& input, const FrameOutput& output) override {
    if (log_ != nullptr) log_->frame(input, output);
    if (log_ != nullptr && !log_->status()) endLog(input.time);
    if (driver_ != nullptr && !driverGone_) tellDriver(input, output);
    if (!status_ || input.frame % kStatusFrames != 0) return;
    fmt::print("{}{}\n", kStatusMark, describe(input, output));
    std::fflush(stdout);
  }

 private:
  // The match goes on without it.
  void endLog(TimeUs now) {
    fmt::print("{}{}{:.1f} s\n", log_->status().error(), kLogEndsMark, now.seconds());
    std::fflush(stdout);
    log_ = nullptr;
  }
  void tellDriver(const FrameInput& input, const FrameOutput& output) {
    const Status reported = driver_->tell(input, output);
    driverGone_ = !reported;
    if (driverGone_) fmt::print(stderr, "{}; the robot stands\n", reported.error());
  }

  LogFile* log_;
  host::DriverLink* driver_;
  bool status_;
  bool driverGone_ = false;
};

int fail(const std::string& message, int code) {
  fmt::print(stderr, "{}{}\n", kComplaintMark, message);
  return code;
}

// What goes by the machine's own network goes not through the world.
struct Links {
  std::optional<host::DriverLink> driver;
  std::optional<host::UdpRadio> radio;
  std::optional<host::UdpControl> controller;
  std::optional<sim::UnusedControl> unused;

  void hear(TimeUs now, agent::AgentLoops& loops) {
    if (driver) loops.setDrive(driver->drive());
    RadioPacket packet;
    while (radio && radio->receive(packet)) loops.hear(packet, now);
    ControlPacket control;
    while (controller && controller->receive(control)) {
      sayIfUnused(control);
      loops.hear(control, now);
    }
  }
  void sayIfUnused(const ControlPacket& packet) {
    net::GameControlData ignored;
    const auto refusal = net::decodeControl(packet.bytes.begin(), packet.bytes.size(), ignored);
    const auto line = refusal ? unused->lineFor(packet, *refusal) : std::nullopt;
    if (line) fmt::print(stderr, "{}\n", *line);
  }
  bool sends(RadioPacket& packet, agent::AgentLoops& loops) {
    const bool made = loops.takePacket(packet);
    if (!radio) return made;
    if (made) radio->send(packet);
    return false;
  }
};

// Game controller, team and driver are heard at each step, ahead of its image.
Status runFrom(host::Source& source, const AgentOptions& options, Links& links,
               agent::AgentLoops& loops) {
  host::HostParams params;
  params.dropRate = options.dropRate;
  params.seed = options.seed;
  host::Network network;
  network.tick = [&](TimeUs now) { links.hear(now, loops); };
  network.control = [&](const ControlPacket& packet, TimeUs now) {
    if (!links.controller) loops.hear(packet, now);
  };
  network.heard = [&](const RadioPacket& packet, TimeUs now) {
    if (!links.radio) loops.hear(packet, now);
  };
  network.sends = [&](RadioPacket& packet) { return links.sends(packet, loops); };
  const auto summary = host::runAgent(source, loops, params, network);
  if (!summary) return Error{summary.error()};
  return Done{};
}

using SourcePtr = std::unique_ptr<host::Source>;

Expected<SourcePtr> openSource(const AgentOptions& options, const agent::AgentConfig& config) {
  if (!options.recording.empty()) {
    auto recording = host::RecordingSource::open(options.recording);
    if (!recording) return Error{recording.error()};
    return SourcePtr(std::make_unique<host::RecordingSource>(std::move(*recording)));
  }
  host::ConnectionParams params;
  if (options.patient) params.timeout = 0.0;
  auto world = host::WorldSource::connect(options.socket, {config.team, config.player}, params);
  if (!world) return Error{world.error()};
  return SourcePtr(std::make_unique<host::WorldSource>(std::move(*world)));
}

// Puts what was opened into its place.
template <class Link>
Status keep(Expected<Link> opened, std::optional<Link>& place) {
  if (!opened) return Error{opened.error()};
  place.emplace(std::move(*opened));
  return Done{};
}

Status openLinks(const AgentOptions& options, const host::AgentHello& self, Links& links) {
  Status opened = Done{};
  if (!options.driver.empty())
    opened = keep(host::DriverLink::connect(options.driver), links.driver);
  if (opened && options.radio == "udp") opened = keep(host::UdpRadio::open(self), links.radio);
  if (opened && options.controller != 0)
    opened = keep(host::UdpControl::open(options.controller, true), links.controller);
  links.unused.emplace(options.controller);
  return opened;
}

ImagesKept imagesKept(const AgentOptions& options) {
  if (options.noImages) return ImagesKept::none;
  if (options.planes) return ImagesKept::planes;
  return options.allImages ? ImagesKept::all : ImagesKept::some;
}

Status confineTo(const std::string& scripts) {
  const auto lack = confineScripts({scripts});
  if (!lack) return Error{lack.error()};
  if (!lack->empty()) fmt::print(stderr, "{}\n", *lack);
  return Done{};
}

// A script that does not load is bad input: reported before the match, not during it. During it the
// robot stands until the script is mended, as one does whose scripts are edited while it plays.
int run(const AgentOptions& options) {
  const Status scripts = checkScripts(options.pycode);
  if (!scripts && !options.again) return fail(scripts.error(), 2);
  ConfigOptions request = options.config;
  request.body = options.physical ? Body::physical : Body::fast;
  const auto config = makeConfig(request);
  if (!config) return fail(config.error(), 2);
  if (sameFile(options.recording, options.log))
    return fail(options.log + ": is the recording itself", 2);
  auto source = openSource(options, *config);
  if (!source) return fail(source.error(), 1);
  // Only now: an earlier log is not lost to a world that is not there.
  std::optional<LogFile> log;
  if (!options.log.empty()) {
    auto created =
        LogFile::create(options.log, *config, parameterNotes(options.config), imagesKept(options),
                        options.plainLog ? LogOptions{} : playLogOptions());
    if (!created) return fail(created.error(), 2);
    log.emplace(std::move(*created));
  }
  Links links;
  const Status linked = openLinks(options, {config->team, config->player}, links);
  if (!linked) return fail(linked.error(), 1);
  const Status confined = options.confined ? confineTo(options.pycode) : Done{};
  if (!confined) return fail(confined.error(), 1);
  AgentSink sink(log ? &*log : nullptr, links.driver ? &*links.driver : nullptr, options.status);
  agent::AgentLoops loops(*config, options.pycode, sink);
  if (!loops.scriptError().empty() && !options.again) return fail(loops.scriptError(), 2);
  const Status played = runFrom(**source, options, links, loops);
  const bool ended = log && !log->status();  // which was reported
  const Status closed = log && !ended ? log->close() : Status(Done{});
  if (!played) return fail(played.error(), 1);
  return closed ? 0 : fail(closed.error(), 1);
}

}  // namespace
}  // namespace kelpie::cli

int main(int argc, char** argv) {
  using kelpie::cli::AgentOptions;
  kelpie::cli::useTargetMaths(argv);
  kelpie::cli::ProgramLine app{"One robot's brain: joins a simulated world and plays",
                               "kelpie-agent"};
  AgentOptions options;
  auto from = app.oneOfGroup("source", "where sensors and images come from");
  from.option("--socket", options.socket, "Socket of a simulated world");
  from.option("--recording", options.recording, "Log of an agent, through OPEN-R again");
  app.option("--log", options.log, "Log to write");
  const auto all = app.flag("--all-images", options.allImages,
                            "The log keeps every image, not only those of the beginning");
  app.flag("--no-images", options.noImages,
           "The log keeps no images and no motion messages, only what the robot knew, decided "
           "and did in each frame")
      .excludes(all);
  app.flag("--planes", options.planes,
           "The log keeps class planes in place of images, and less of what is between them")
      .excludes(all);
  app.flag("--plain-log", options.plainLog, "The log's records go out one by one, uncompressed");
  app.flag("--patient", options.patient, "A silent world is waited for: somebody has paused it");
  app.option("--pycode", options.pycode, "Behaviours, folder or zip");
  app.option("--player", options.config.player, "Number in the team")
      .check(kelpie::cli::integerInRange(1, 4));
  app.flag("--physical,!--fast", options.physical,
           "The body has masses and servos (the default), or is a kinematic one");
  app.option("--drop-rate", options.dropRate, "Share of images lost on the way")
      .check(kelpie::cli::inRange(0.0, 1.0));
  app.option("--seed", options.seed, "Of the losses")
      .check(kelpie::cli::inRange(0.0, kelpie::cli::kLargestSeed));
  app.option("--driver", options.driver,
             "Socket of a driver, who is told what the robot sees and whose commands the body "
             "gets; the behaviours are not asked");
  app.option("--radio", options.radio,
             "How the team is heard: through the world, or udp of this machine")
      .check(kelpie::cli::oneOf({"world", "udp"}));
  app.option("--game-controller", options.controller,
             "UDP port where a game controller is heard (3838 is the league's); without it "
             "through the world")
      .check(kelpie::cli::integerInRange(1, 65535));
  app.flag("--again", options.again,
           "The match goes on: scripts that do not load are waited for, not refused");
  app.flag("--confined", options.confined,
           "The scripts are somebody else's: no files but theirs, no sockets, programs or memory "
           "without end");
  app.flag("--status", options.status, "Says twice a second what the robot believes");
  addConfigOptions(app, options.config);
  bool done = false;
  const int usage = kelpie::cli::parseOptions(app, argc, argv, done);
  if (done) return usage;
  try {
    return kelpie::cli::run(options);
  } catch (const std::exception& error) {
    return kelpie::cli::fail(error.what(), 2);
  }
}
