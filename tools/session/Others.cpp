// SPDX-License-Identifier: Apache-2.0
#include "tools/session/Others.h"

#include <fmt/core.h>

#include <utility>

#include "tools/cli/AgentTalk.h"
#include "tools/session/SessionCommands.h"

namespace kelpie::cli {

Expected<Others> Others::start(const SessionOptions& options, const RunDirectory& runDirectory) {
  Others others;
  for (const OtherRobot& one : options.others) {
    if (!options.strangerOf(one.team).empty()) continue;
    const auto command = [&options, &runDirectory, one](int life) {
      return otherCommand(options, one, runDirectory, life);
    };
    auto process = Process::start(command(0), true);
    if (!process) return Error{process.error()};
    others.all_.push_back(
        {fmt::format("the {} {} {}", one.team == options.team ? "mate" : "opponent", one.team,
                     one.player),
         command, std::move(*process), "", ""});
  }
  return others;
}

void Others::hearOne(One& one, const std::function<void(const std::string&)>& tell) {
  std::string line;
  while (one.process->readLine(line, 0)) {
    if (line.compare(0, kComplaintMark.size(), kComplaintMark) == 0)
      one.complaint = line.substr(kComplaintMark.size());
    else
      tell(one.name + ": " + (one.last = line));
  }
}

void Others::hear(const std::function<void(const std::string&)>& tell) {
  for (const std::string& line : std::exchange(unreported_, {})) tell(line);
  for (One& one : all_) hearOne(one, tell);
}

// One whose script hung as it loaded had no time for a complaint.
std::string Others::endOf(const One& one) {
  if (!one.complaint.empty()) return one.complaint;
  if (hung()) return fmt::format("it ended with code {}", code_);
  if (!badInput()) return "it gave up";
  unreported_.clear();
  return one.last;
}

bool Others::failed() {
  for (One& one : all_) {
    if (!trouble_.empty()) break;
    if (!one.process->ended()) continue;
    hearOne(one, [this](const std::string& line) { unreported_.push_back(line); });
    code_ = one.process->wait();
    if (code_ == 0) continue;
    failed_ = &one;
    if (code_ >= 128)
      trouble_ = fmt::format("{} died (signal {})", one.name, code_ - 128);
    else
      trouble_ = one.name + ": " + endOf(one);
  }
  return !trouble_.empty();
}

void Others::kill() {
  for (One& one : all_) one.process->kill();
}

bool Others::revive() {
  if (failed_ == nullptr || --failed_->lives <= 0) return false;
  auto process = Process::start(failed_->command(kMaxLives - failed_->lives), true);
  if (!process) return false;
  failed_->process.emplace(std::move(*process));
  failed_->complaint.clear();
  failed_ = nullptr;
  trouble_.clear();
  return true;
}

}  // namespace kelpie::cli
