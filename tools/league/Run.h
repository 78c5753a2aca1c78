// SPDX-License-Identifier: Apache-2.0
// Plays what is left of a league on several threads. The order in which matches end changes the
// order of the journal's lines and nothing else.
#pragma once

#include <functional>
#include <string>

#include "tools/league/LeagueJournal.h"

namespace kelpie::league {

// What happens meanwhile. The first two are called one at a time, from the threads that play, and
// may look at the journal's results; each may be empty.
struct RunTalk {
  // A match is in the journal. It is void when its result has trouble.
  std::function<void(std::size_t match, const MatchResult& result)> finished;
  // A match got into trouble and is tried once more.
  std::function<void(std::size_t match, const std::string& trouble)> again;
  // Asked by all threads at once, before each match: true begins no further one. Those under way
  // are waited for, so that `play` has to end them itself when it is to be quick.
  std::function<bool()> stop;
};

struct RunSummary {
  std::size_t played = 0;  // now, void ones included
  std::size_t voids = 0;   // of them
  std::size_t left = 0;    // still to be played
  bool stopped = false;    // on request
};

// `workers`: matches at a time, at least 1. A match in trouble is tried once more, and is void when
// that fails as well. What ends in trouble after the request to stop is not kept: it was cut short.
// Error: the journal could not be written; what it holds until then stays good.
Expected<RunSummary> runLeague(LeagueJournal& journal, const Play& play, int workers,
                               const RunTalk& talk = {});

}  // namespace kelpie::league
