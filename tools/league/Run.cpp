// SPDX-License-Identifier: Apache-2.0
#include "tools/league/Run.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

namespace kelpie::league {
namespace {

bool isPossible(const MatchResult& result) {
  return result.redOwnGoals >= 0 && result.redOwnGoals <= result.blueGoals &&
         result.blueOwnGoals >= 0 && result.blueOwnGoals <= result.redGoals && result.outs >= 0 &&
         std::isfinite(result.seconds) && result.seconds >= 0.0;
}

constexpr std::size_t kLongestTrouble = 500;  // characters

// One line that every table can show, whatever a dying program printed.
MatchResult inTrouble(const std::string& trouble) {
  MatchResult result;
  result.trouble = trouble.empty() ? "unknown" : trouble.substr(0, kLongestTrouble);
  for (char& c : result.trouble) c = c >= ' ' && c <= '~' ? c : '?';
  return result;
}

// Whatever goes wrong is the result's trouble; a result in trouble has no other figures.
MatchResult playOnce(const Play& play, const LeagueMatch& match) {
  try {
    MatchResult result = play(match);
    if (!result.trouble.empty()) return inTrouble(result.trouble);
    return isPossible(result) ? result : inTrouble("an impossible result");
  } catch (const std::exception& error) {
    return inTrouble(error.what());
  }
}

// What the threads share.
class Round {
 public:
  Round(LeagueJournal& journal, const Play& play, const RunTalk& talk)
      : journal_(journal), play_(play), talk_(talk) {}

  void work() {
    for (std::size_t match = 0; take(match);) {
      MatchResult result = playOnce(play_, journal_.schedule()[match].match);
      if (!result.trouble.empty() && !stopAsked()) {
        tellAgain(match, result.trouble);
        result = playOnce(play_, journal_.schedule()[match].match);
      }
      if (result.trouble.empty() || !stopAsked()) keep(match, result);
    }
  }

  Expected<RunSummary> end() {
    if (!error_.empty()) return Error{error_};
    const auto& results = journal_.results();
    summary_.left = static_cast<std::size_t>(
        std::count_if(results.begin(), results.end(), [](const auto& r) { return !r; }));
    summary_.stopped = summary_.left > 0;
    return summary_;
  }

 private:
  bool stopAsked() const { return talk_.stop && talk_.stop(); }

  bool take(std::size_t& match) {
    if (stopAsked()) return false;
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto& results = journal_.results();
    while (next_ < results.size() && results[next_]) ++next_;
    if (next_ >= results.size() || !error_.empty()) return false;
    match = next_++;
    return true;
  }

  void tellAgain(std::size_t match, const std::string& trouble) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (talk_.again) talk_.again(match, trouble);
  }

  void keep(std::size_t match, const MatchResult& result) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!error_.empty()) return;
    const Status kept = journal_.add(match, result);
    if (!kept) {
      error_ = kept.error();
      return;
    }
    ++summary_.played;
    summary_.voids += result.trouble.empty() ? 0U : 1U;
    if (talk_.finished) talk_.finished(match, result);
  }

  LeagueJournal& journal_;
  const Play& play_;
  const RunTalk& talk_;
  std::mutex mutex_;  // of the journal and of what follows
  std::size_t next_ = 0;
  std::string error_;
  RunSummary summary_;
};

}  // namespace

Expected<RunSummary> runLeague(LeagueJournal& journal, const Play& play, int workers,
                               const RunTalk& talk) {
  Round round(journal, play, talk);
  std::vector<std::thread> threads;
  for (int i = 1; i < workers; ++i) threads.emplace_back([&round] { round.work(); });
  round.work();  // this thread is one of them
  for (std::thread& thread : threads) thread.join();
  return round.end();
}

}  // namespace kelpie::league
