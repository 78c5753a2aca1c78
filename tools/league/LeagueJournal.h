// SPDX-License-Identifier: Apache-2.0
// A league's memory: FOLDER/league.jsonl. Its first line holds the plan and the plan's hash, each
// further one a finished match, appended in one write. Whenever its process is killed, at most an
// unfinished last line is lost; a power cut may take the last half minute. A lock on
// FOLDER/league.lock keeps other processes out as long as the object lives; that file stays.
#pragma once

#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "tools/league/Schedule.h"

namespace kelpie::league {

std::string journalPath(const std::string& folder);

// What a league has played so far, also while it goes on; changes nothing. Error: there is none, or
// its journal is damaged elsewhere than in an unfinished last line.
Expected<LeagueRecord> readLeague(const std::string& folder);

class LeagueJournal {
 public:
  // Makes the folder and the journal where there are none, and goes on with the journal of the same
  // plan. Errors in one line: plan that cannot be played, another process plays here, journal of
  // another league or damaged, folder that cannot be written.
  static Expected<LeagueJournal> open(const std::string& folder, const LeaguePlan& plan);
  LeagueJournal(LeagueJournal&& other) noexcept;
  LeagueJournal& operator=(LeagueJournal&&) = delete;
  LeagueJournal(const LeagueJournal&) = delete;
  LeagueJournal& operator=(const LeagueJournal&) = delete;
  ~LeagueJournal();

  const LeaguePlan& plan() const { return record_.plan; }
  const std::vector<ScheduledMatch>& schedule() const { return schedule_; }
  const Results& results() const { return record_.results; }

  // Keeps the result of a match that has none yet, or a void one. When it cannot be written whole,
  // nothing of it stays in the file.
  Status add(std::size_t match, const MatchResult& result);
  // From now on void matches count as still to be played, for when their cause has been mended.
  void forgetVoids();

 private:
  LeagueJournal(std::string path, LeagueRecord record);
  Status append(const std::string& line);

  std::string path_;
  LeagueRecord record_;
  std::vector<ScheduledMatch> schedule_;
  int lock_ = -1;  // file descriptors
  int file_ = -1;
};

}  // namespace kelpie::league
