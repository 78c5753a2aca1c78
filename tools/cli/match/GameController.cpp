// SPDX-License-Identifier: Apache-2.0
// kelpie gamecontroller: a game controller for people who have not the league's program. Reads
// words and sends packets, twice a second and at once when something has changed.
#include <fmt/core.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <utility>

#include "robot/host/radio/UdpSocket.h"
#include "tools/cli/Commands.h"
#include "tools/cli/Process.h"
#include "tools/cli/options/Usage.h"
#include "tools/session/RefereeWords.h"

namespace kelpie::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kEvery = 0.5;  // s between packets

struct ControllerOptions {
  int port = net::kGameControlPort;
  std::string address = "127.0.0.1";
  std::uint32_t red = 1;
  std::uint32_t blue = 0;
  double halfMinutes = 10.0;
};

// Lines of standard input as they come, without ever waiting for one longer than asked.
class Lines {
 public:
  bool ended() const { return ended_ && text_.empty(); }
  // Nothing when no whole line has come.
  bool next(std::string& line) {
    const std::size_t end = text_.find('\n');
    if (end == std::string::npos && !(ended_ && !text_.empty())) return false;
    line = text_.substr(0, end);
    text_.erase(0, end == std::string::npos ? end : end + 1);
    return true;
  }
  void wait(double seconds) {
    pollfd standard{STDIN_FILENO, POLLIN, 0};
    const int milliseconds = static_cast<int>(1000.0 * seconds);
    if (poll(&standard, ended_ ? 0 : 1, milliseconds) <= 0) return;
    char some[512];
    const ssize_t size = read(STDIN_FILENO, some, sizeof some);
    if (size > 0) text_.append(some, static_cast<std::size_t>(size));
    ended_ = size <= 0;
  }

 private:
  std::string text_;
  bool ended_ = false;
};

const char* wordFor(PlayState state) {
  constexpr const char* kWords[] = {"initial", "ready", "set", "playing", "finished"};
  return kWords[static_cast<std::size_t>(state)];
}

void tell(const net::GameControlData& control) {
  fmt::print("{}, red {} : {} blue, kick-off {}, {} s left of the {} half\n",
             wordFor(control.state), control.teams[1].score, control.teams[0].score,
             control.kickOff == TeamColour::red ? "red" : "blue", control.secondsLeft,
             control.firstHalf ? "first" : "second");
  std::fflush(stdout);
}

class Controller {
 public:
  Controller(const ControllerOptions& options, host::UdpSocket socket)
      : options_(options),
        socket_(std::move(socket)),
        desk_(refereeDesk(options.red, options.blue, 60.0 * options.halfMinutes)) {}

  // Until the words end, and one more packet's time, so that the last is heard.
  void run() {
    send();
    while (!interrupted() && !over()) {
      lines_.wait(std::min(kEvery, std::max(0.0, untilNext())));
      pass();
      obey();
      if (untilNext() <= 0.0) send();
    }
    send();
  }

 private:
  // A pause that nobody follows is not waited for.
  bool over() const { return desk_.quits || (lines_.ended() && desk_.waits <= 0.0); }
  double untilNext() const {
    return kEvery - std::chrono::duration<double>(Clock::now() - sent_).count();
  }
  void pass() {
    const auto now = Clock::now();
    const double gone = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    goOn(gone, desk_);
    desk_.waits = std::max(0.0, desk_.waits - gone);
  }
  void obey() {
    std::string line;
    while (!desk_.quits && desk_.waits <= 0.0 && lines_.next(line)) {
      const Status said = say(line, desk_);
      if (!said) {
        fmt::print(stderr, "kelpie: {}\n", said.error());
        continue;
      }
      send();
      tell(desk_.control);
    }
  }
  void send() {
    const auto bytes = net::encodeControl(desk_.control);
    sent_ = Clock::now();
    const bool gone = socket_.send(options_.address, static_cast<std::uint16_t>(options_.port),
                                   bytes.data(), bytes.size());
    if (!gone && !silent_)
      fmt::print(stderr, "kelpie: nothing can be sent to {}\n", options_.address);
    silent_ = !gone;
  }

  ControllerOptions options_;
  host::UdpSocket socket_;
  RefereeDesk desk_;
  Lines lines_;
  Clock::time_point last_ = Clock::now();
  Clock::time_point sent_;
  bool silent_ = false;  // the last packet could not be sent
};

int control(const ControllerOptions& options) {
  if (!host::isAddress(options.address))
    return fail("--address " + options.address + ": expected four numbers, as 127.0.0.1",
                kExitBadInput);
  if (options.red == options.blue)
    return fail("--red and --blue: two teams have two numbers", kExitBadInput);
  auto socket = host::UdpSocket::open({0, true, false});
  if (!socket) return fail(socket.error(), kExitMachine);
  catchInterrupts();
  Controller(options, std::move(*socket)).run();
  return kExitDone;
}

}  // namespace

void addGameController(CommandLine& app, int& code) {
  auto command = app.subcommand(
      "gamecontroller", "Rules a match by words on standard input: ready, set, playing, ...");
  auto options = std::make_shared<ControllerOptions>();
  command.option("--port", options->port, "UDP port where it is heard")
      .check(integerInRange(1, 65535))
      .showDefault();
  command.option("--address", options->address, "Where to; 255.255.255.255 is everybody")
      .showDefault();
  command.option("--red", options->red, "Number of the red team")
      .check(integerInRange(0, 255))
      .showDefault();
  command.option("--blue", options->blue, "Number of the blue team")
      .check(integerInRange(0, 255))
      .showDefault();
  command.option("--half", options->halfMinutes, "Minutes of a half")
      .check(inRange(0.1, 60.0))
      .showDefault();
  command.footer(
      "Words, one line each: initial, ready, set, playing, finished, half (the second begins),\n"
      "kickoff TEAM, goal TEAM, out TEAM, penalise TEAM PLAYER [REASON], back TEAM PLAYER,\n"
      "wait SECONDS, quit. TEAM is red or blue.");
  command.callback([=, &code] { code = control(*options); });
}

}  // namespace kelpie::cli
