// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/OrderJson.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

namespace kelpie::studio {
namespace {

using nlohmann::json;

// Numbers and words as one word each; anything else as one that no order has.
std::string word(const json& order, const char* key) {
  const auto found = order.find(key);
  if (found == order.end()) return "?";
  if (found->is_string()) return found->get<std::string>();
  return found->is_number() ? found->dump() : "?";
}

}  // namespace

Expected<sim::LiveOrder> orderFromJson(const std::string& text) {
  const json order = json::parse(text, nullptr, false);
  if (!order.is_object()) return Error{"an order is a JSON object"};
  const auto at = [&order](const char* key) { return word(order, key); };
  const std::string what = at("do");
  if (what == "step") return sim::liveOrderFrom("step " + at("frames"));
  if (what == "speed") return sim::liveOrderFrom("speed " + at("factor"));
  if (what == "ball") return sim::liveOrderFrom(fmt::format("ball {},{}", at("x"), at("y")));
  if (what == "robot")
    return sim::liveOrderFrom(fmt::format("carry {}:{}:{},{},{}", at("team"), at("player"), at("x"),
                                          at("y"), at("heading_deg")));
  return sim::liveOrderFrom(what);
}

}  // namespace kelpie::studio
