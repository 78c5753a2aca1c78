// SPDX-License-Identifier: Apache-2.0
#include "tools/league/JournalLines.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

namespace kelpie::league {
namespace {

using Json = nlohmann::ordered_json;

Json planJson(const LeaguePlan& plan) {
  return {{"sides", plan.sides},     {"reference", plan.reference},
          {"seed", plan.seed},       {"matches_a_pair", plan.matchesAPair},
          {"minutes", plan.minutes}, {"fast", plan.fast},
          {"about", plan.about}};
}

// Of nlohmann's exceptions when a key is missing or of another type.
LeaguePlan planOf(const Json& json) {
  LeaguePlan plan;
  plan.sides = json.at("sides").get<std::vector<std::string>>();
  plan.reference = json.at("reference").get<std::string>();
  plan.seed = json.at("seed").get<std::uint64_t>();
  plan.matchesAPair = json.at("matches_a_pair").get<int>();
  plan.minutes = json.at("minutes").get<double>();
  plan.fast = json.at("fast").get<bool>();
  plan.about = json.at("about").get<std::string>();
  return plan;
}

MatchResult resultOf(const Json& json) {
  MatchResult result;
  result.redGoals = json.at("red_goals").get<int>();
  result.blueGoals = json.at("blue_goals").get<int>();
  result.redOwnGoals = json.at("red_own_goals").get<int>();
  result.blueOwnGoals = json.at("blue_own_goals").get<int>();
  result.outs = json.at("outs").get<int>();
  result.seconds = json.at("seconds").get<double>();
  result.trouble = json.at("trouble").get<std::string>();
  return result;
}

// Bytes that are no UTF-8, as a program may print them, become U+FFFD.
std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string hashOfText(const std::string& text) {
  std::uint64_t hash = 14695981039346656037ULL;  // FNV-1a: offset basis, and the prime below
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return fmt::format("{:016x}", hash);
}

bool isOf(const Json& json, const LeagueMatch& match) {
  return json.at("red").get<std::string>() == match.red &&
         json.at("blue").get<std::string>() == match.blue &&
         json.at("seed").get<std::uint64_t>() == match.seed;
}

}  // namespace

std::string hashOf(const LeaguePlan& plan) { return hashOfText(dumped(planJson(plan))); }

std::string headerLine(const LeaguePlan& plan) {
  return dumped(Json{{"kelpie_league", 1}, {"hash", hashOf(plan)}, {"plan", planJson(plan)}});
}

Expected<LeaguePlan> planOfHeader(const std::string& line) {
  const Json json = Json::parse(line, nullptr, false);
  try {
    if (json.at("kelpie_league").get<int>() != 1) return Error{"journal of another version"};
    LeaguePlan plan = planOf(json.at("plan"));
    if (json.at("hash").get<std::string>() != hashOf(plan)) return Error{"damaged header"};
    const Status playable = checkPlan(plan);
    return playable ? Expected<LeaguePlan>(plan) : Error{playable.error()};
  } catch (const Json::exception&) {
    return Error{"not the journal of a league"};
  }
}

std::string differenceOf(const LeaguePlan& there, const LeaguePlan& asked) {
  const Json theirs = planJson(there);
  const Json ours = planJson(asked);
  for (const auto& [key, value] : theirs.items())
    if (dumped(value) != dumped(ours.at(key)))
      return fmt::format("{} {} there, {} asked for", key, dumped(value), dumped(ours.at(key)));
  return "";
}

std::string matchLine(std::size_t number, const LeagueMatch& match, const MatchResult& result) {
  return dumped(Json{{"match", number},
                     {"red", match.red},
                     {"blue", match.blue},
                     {"seed", match.seed},
                     {"red_goals", result.redGoals},
                     {"blue_goals", result.blueGoals},
                     {"red_own_goals", result.redOwnGoals},
                     {"blue_own_goals", result.blueOwnGoals},
                     {"outs", result.outs},
                     {"seconds", result.seconds},
                     {"trouble", result.trouble}});
}

bool readMatchLine(const std::string& line, const std::vector<ScheduledMatch>& schedule,
                   Results& results) {
  const Json json = Json::parse(line, nullptr, false);
  try {
    const auto number = json.at("match").get<std::size_t>();
    if (number >= schedule.size() || !isOf(json, schedule[number].match)) return false;
    auto& place = results[number];
    if (place && place->trouble.empty()) return false;
    place = resultOf(json);
    return true;
  } catch (const Json::exception&) {
    return false;
  }
}

}  // namespace kelpie::league
