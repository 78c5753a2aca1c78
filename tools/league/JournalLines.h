// SPDX-License-Identifier: Apache-2.0
// The lines of a league's journal and back. Nothing here touches a file.
#pragma once

#include <string>

#include "robot/core/Expected.h"
#include "tools/league/Schedule.h"

namespace kelpie::league {

// What every header begins with.
constexpr const char* kHeaderStart = "{\"kelpie_league\":1,";

// 16 hexadecimal digits that name the plan: FNV-1a (64 bits) of the plan as JSON.
std::string hashOf(const LeaguePlan& plan);
// Without the line's end.
std::string headerLine(const LeaguePlan& plan);
Expected<LeaguePlan> planOfHeader(const std::string& line);
// "minutes 10.0 there, 5.0 asked for": the first thing in which they differ; empty when in none.
std::string differenceOf(const LeaguePlan& there, const LeaguePlan& asked);

std::string matchLine(std::size_t number, const LeagueMatch& match, const MatchResult& result);
// Puts the line's result in its place. False: no line of a match of this schedule, or of one that
// has a result already that is not void.
bool readMatchLine(const std::string& line, const std::vector<ScheduledMatch>& schedule,
                   Results& results);

}  // namespace kelpie::league
