// SPDX-License-Identifier: Apache-2.0
#include "tools/session/RefereeWords.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <sstream>
#include <vector>

namespace kelpie::cli {
namespace {

using Words = std::vector<std::string>;

constexpr double kLongestWait = 3600.0;  // s
constexpr const char* kUsage =
    "words are initial, ready, set, playing, finished, half, kickoff TEAM, goal TEAM, out TEAM, "
    "penalise TEAM PLAYER [REASON], back TEAM PLAYER, wait SECONDS, quit";

// In the order of their numbers on the wire, from 1.
constexpr const char* kReasons[] = {"holding",     "goalie", "pushing", "defender", "defence",
                                    "obstruction", "pickup", "leaving", "damage"};

struct State {
  const char* word;
  PlayState state;
};
constexpr State kStates[] = {{"initial", PlayState::initial},
                             {"ready", PlayState::ready},
                             {"set", PlayState::set},
                             {"playing", PlayState::playing},
                             {"finished", PlayState::finished}};

std::size_t placeOf(TeamColour team, const RefereeDesk& desk) {
  return desk.control.teams[0].colour == team ? 0 : 1;
}

Expected<TeamColour> teamFrom(const std::string& word) {
  if (word == "red") return TeamColour::red;
  if (word == "blue") return TeamColour::blue;
  return Error{"'" + word + "': the teams are red and blue"};
}

TeamColour otherThan(TeamColour team) {
  return team == TeamColour::red ? TeamColour::blue : TeamColour::red;
}

Expected<double> secondsFrom(const std::string& word) {
  double seconds = 0.0;
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, seconds);
  if (error != std::errc() || rest != end || !(seconds >= 0.0 && seconds <= kLongestWait))
    return Error{"'" + word + "': a wait is from 0 to 3600 seconds"};
  return seconds;
}

Expected<net::ControlPenalty> penaltyFrom(const std::string& word) {
  const auto* const found = std::find(std::begin(kReasons), std::end(kReasons), word);
  if (found == std::end(kReasons))
    return Error{"'" + word +
                 "': reasons are holding, goalie, pushing, defender, defence, "
                 "obstruction, pickup, leaving, damage"};
  return static_cast<net::ControlPenalty>(1 + (found - std::begin(kReasons)));
}

void endPenalties(RefereeDesk& desk) {
  desk.penaltyLeft = {};
  for (net::ControlTeam& team : desk.control.teams) team.players = {};
}

Status secondHalf(RefereeDesk& desk) {
  if (!desk.control.firstHalf) return Error{"'half': the second half has begun already"};
  desk.control.kickOff = otherThan(desk.control.kickOff);
  desk.control.firstHalf = false;
  desk.control.state = PlayState::initial;
  desk.left = desk.halfTime;
  endPenalties(desk);
  return Done{};
}

Status ofTeam(const Words& words, RefereeDesk& desk) {
  const auto team = teamFrom(words[1]);
  if (!team) return Error{team.error()};
  if (words[0] == "kickoff") desk.control.kickOff = *team;
  if (words[0] == "out") {
    desk.control.dropInTeam = *team;
    desk.control.dropInSeconds = 0;
    desk.sinceDropIn = 0.0;
  }
  if (words[0] != "goal") return Done{};
  std::uint32_t& score = desk.control.teams[placeOf(*team, desk)].score;
  score = std::min(score + 1U, 255U);
  desk.control.kickOff = otherThan(*team);
  desk.control.state = PlayState::ready;
  return Done{};
}

Status ofPlayer(const Words& words, RefereeDesk& desk) {
  const auto team = teamFrom(words[1]);
  if (!team) return Error{team.error()};
  const std::string& number = words[2];
  if (number.size() != 1 || number[0] < '1' || number[0] > '4')
    return Error{"'" + number + "': players are 1 to 4"};
  const std::size_t place = placeOf(*team, desk);
  const auto player = static_cast<std::size_t>(number[0] - '1');
  net::ControlPenalty penalty = net::ControlPenalty::none;
  if (words[0] == "penalise") {
    const auto reason = penaltyFrom(words.size() > 3 ? words[3] : "pickup");
    if (!reason) return Error{reason.error()};
    penalty = *reason;
  }
  desk.control.teams[place].players[player].penalty = penalty;
  desk.penaltyLeft[place][player] = penalty == net::ControlPenalty::none ? 0.0 : desk.penaltyTime;
  return Done{};
}

Status ofOneWord(const std::string& word, RefereeDesk& desk) {
  const auto* const found = std::find_if(std::begin(kStates), std::end(kStates),
                                         [&](const State& state) { return word == state.word; });
  if (found != std::end(kStates))
    desk.control.state = found->state;
  else if (word == "half")
    return secondHalf(desk);
  else if (word == "quit")
    desk.quits = true;
  else
    return Error{"'" + word + "': " + kUsage};
  return Done{};
}

Status follow(const Words& words, const std::string& line, RefereeDesk& desk) {
  const std::string& first = words[0];
  const std::size_t count = words.size();
  if (count == 1) return ofOneWord(first, desk);
  if (count == 2 && (first == "kickoff" || first == "goal" || first == "out"))
    return ofTeam(words, desk);
  if ((first == "penalise" && (count == 3 || count == 4)) || (first == "back" && count == 3))
    return ofPlayer(words, desk);
  if (first != "wait" || count != 2) return Error{"'" + line + "': " + kUsage};
  const auto seconds = secondsFrom(words[1]);
  if (!seconds) return Error{seconds.error()};
  desk.waits = *seconds;
  return Done{};
}

std::uint32_t whole(double seconds) { return static_cast<std::uint32_t>(std::ceil(seconds)); }

}  // namespace

RefereeDesk refereeDesk(std::uint32_t redNumber, std::uint32_t blueNumber, double halfTime) {
  RefereeDesk desk;
  desk.control.teams[0] = {blueNumber, TeamColour::blue, 0, {}};
  desk.control.teams[1] = {redNumber, TeamColour::red, 0, {}};
  desk.control.kickOff = TeamColour::red;
  desk.halfTime = desk.left = halfTime;
  desk.control.secondsLeft = whole(halfTime);
  return desk;
}

Status say(const std::string& line, RefereeDesk& desk) {
  std::istringstream stream(line);
  const Words words{std::istream_iterator<std::string>(stream), {}};
  if (words.empty() || words[0][0] == '#') return Done{};
  const Status followed = follow(words, line, desk);
  goOn(0.0, desk);
  return followed;
}

// The half's clock runs in play only. A penalty that has run out stays until it is taken back.
void goOn(double seconds, RefereeDesk& desk) {
  if (desk.control.state == PlayState::playing) desk.left = std::max(0.0, desk.left - seconds);
  desk.control.secondsLeft = whole(desk.left);
  desk.sinceDropIn += seconds;
  if (desk.control.dropInSeconds != net::kNoDropIn)
    desk.control.dropInSeconds = static_cast<std::uint32_t>(std::min(desk.sinceDropIn, 86400.0));
  for (std::size_t team = 0; team < desk.penaltyLeft.size(); ++team)
    for (std::size_t player = 0; player < net::kControlPlayers; ++player) {
      double& left = desk.penaltyLeft[team][player];
      left = std::max(0.0, left - seconds);
      desk.control.teams[team].players[player].secondsLeft = whole(left);
    }
}

}  // namespace kelpie::cli
