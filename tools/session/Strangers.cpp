// SPDX-License-Identifier: Apache-2.0
#include "tools/session/Strangers.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>
#include <utility>

#include "tools/session/Others.h"

namespace kelpie::cli {
namespace {

void sleepShortly() { std::this_thread::sleep_for(std::chrono::milliseconds(10)); }

// A world that cannot begin ends instead.
void awaitSocket(const std::string& path, Process& world) {
  std::error_code error;
  while (!std::filesystem::exists(path, error) && !world.ended() && !interrupted()) sleepShortly();
}

std::optional<Process> started(const std::vector<std::string>& command) {
  auto process = Process::startGroup(command);
  return process ? std::optional<Process>(std::move(*process)) : std::nullopt;
}

}  // namespace

Strangers Strangers::start(const SessionOptions& options, const RunDirectory& runDirectory,
                           Process& world) {
  Strangers strangers;
  strangers.respawn_ = options.respawn;
  for (const host::AgentHello& robot : strangersOf(options)) {
    awaitSocket(strangerSocket(robot, runDirectory), world);
    const auto command = strangerCommand(options, robot, runDirectory);
    strangers.all_.push_back({sim::nameOf(robot), command, started(command), kMaxLives});
  }
  return strangers;
}

void Strangers::watch(const std::function<void(const std::string&)>& tell) {
  for (One& one : all_) {
    if (!one.process || !one.process->ended()) continue;
    const int code = one.process->wait();
    one.process.reset();
    if (code == 0) continue;
    const bool again = respawn_ && --one.lives > 0;
    tell(fmt::format("agent {}: its program ended with code {}{}", one.name, code,
                     again ? "; it is started again"
                     : respawn_
                         ? fmt::format(", for the {}th time, and is not started again", kMaxLives)
                         : ""));
    auto next = again ? started(one.command) : std::nullopt;
    if (next) one.process.emplace(std::move(*next));
  }
}

void Strangers::end() {
  constexpr int kPatience = 200;  // looks
  const auto goesOn = [](One& one) { return one.process && !one.process->ended(); };
  for (int i = 0; i < kPatience && std::any_of(all_.begin(), all_.end(), goesOn); ++i)
    sleepShortly();
  all_.clear();
}

}  // namespace kelpie::cli
