// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/match/Matches.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

#include "tools/cli/DataFolder.h"
#include "tools/cli/Process.h"

namespace kelpie::experiments {
namespace {

struct One {
  cli::SessionResult result;
  Played played;
};

One playOne(const cli::SessionOptions& session) {
  One one;
  cli::SessionTalk talk;
  std::string trouble;
  talk.frames = [&](const std::string& agentLog, const std::string& worldLog) {
    auto read = readPlayed(agentLog, worldLog);
    if (read) one.played = std::move(*read);
    if (!read) trouble = read.error();
  };
  one.result = cli::runSession(session, talk);
  if (one.result.trouble.empty()) one.result.trouble = trouble;
  return one;
}

}  // namespace

std::string sideOr(const std::string& folder, const char* usual) {
  return folder.empty() ? cli::dataFolder() + "/teams/" + usual : folder;
}

cli::SessionOptions sessionOf(const Request& request, const Trial& trial) {
  cli::SessionOptions session;
  session.seed = trial.seed;
  session.randomised = request.randomised;
  session.physical = !request.fast;
  session.params = request.params;
  session.set = {cli::kNoReload};
  if (!request.field.empty()) session.field = request.field;
  return session;
}

Status playMatches(const Request& request, const Matches& matches) {
  cli::catchInterrupts();  // so that no match leaves its folder behind
  std::atomic<int> next{0};
  std::mutex mutex;
  int done = 0;
  std::string error;
  const auto worker = [&] {
    for (int i = next++; i < matches.count && !cli::interrupted(); i = next++) {
      const cli::SessionOptions session = matches.session(i);
      const One one = playOne(session);
      const std::lock_guard<std::mutex> lock(mutex);
      if (!one.result.trouble.empty() && error.empty())
        error = "seed " + std::to_string(session.seed) + ": " + one.result.trouble;
      if (error.empty()) matches.judge(i, one.result, one.played);
      if (!error.empty()) next = matches.count;
      if (request.progress) request.progress(++done, matches.count);
    }
  };
  std::vector<std::thread> workers;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
    workers.emplace_back(worker);
  for (auto& thread : workers) thread.join();
  if (cli::interrupted()) return Error{"interrupted"};
  return error.empty() ? Status(Done{}) : Status(Error{error});
}

}  // namespace kelpie::experiments
