// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/walk/WalkFile.h"

#include <fmt/format.h>

#include <sstream>

namespace kelpie::learn {
namespace {

template <class M>
std::string valueText(const M& value, const std::string& unit) {
  if constexpr (std::is_same_v<M, Angle>) return fmt::format("\"{:.6g}deg\"", value.deg());
  if constexpr (std::is_enum_v<M>) return fmt::format("{}", static_cast<int>(value));
  if constexpr (std::is_floating_point_v<M>) {
    return unit.empty() ? fmt::format("{:.6g}", value) : fmt::format("\"{:.6g}{}\"", value, unit);
  }
  return "";
}

template <class S>
void write(const std::string& section, const S& value, std::string& out) {
  std::string own;
  forEachField(value, [&](const auto& f, const auto& member) {
    using Member = std::decay_t<decltype(member)>;
    if constexpr (!HasFields<Member>::value)
      own += fmt::format("{} = {}\n", f.name, valueText(member, f.unit));
  });
  if (!own.empty()) out += fmt::format("\n[{}]\n{}", section, own);
  forEachField(value, [&](const auto& f, const auto& member) {
    using Member = std::decay_t<decltype(member)>;
    if constexpr (HasFields<Member>::value) write(section + '.' + f.name, member, out);
  });
}

}  // namespace

const char* nameOf(WalkKind kind) {
  constexpr std::array<const char*, kWalkKindCount> kNames{"normal", "fast", "turning", "dribble",
                                                           "back",   "low",  "weak"};
  return kNames[static_cast<std::size_t>(kind) % kNames.size()];
}

std::string walkText(WalkKind kind, const actuator::WalkSet& set, const std::string& heading) {
  std::string out = "# SPDX-License-Identifier: Apache-2.0\n";
  std::istringstream lines(heading);
  for (std::string line; std::getline(lines, line);) out += "# " + line + '\n';
  write(fmt::format("actuator.walks.{}", nameOf(kind)), set, out);
  return out;
}

}  // namespace kelpie::learn
