// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/referee/UnusedControl.h"

#include <fmt/core.h>

#include <algorithm>

#include "robot/net/GameControlData.h"

namespace kelpie::sim {
namespace {

constexpr std::size_t kMaxLines = 40;  // noise of all kinds is not reported for ever

std::string wantedVersions() {
  std::string text = "Kelpie plays version";
  const char* between = " ";
  for (const net::ControlLayout& layout : net::kControlLayouts) {
    text += fmt::format("{}{} ({} bytes)", between, layout.version, layout.size);
    between = ", ";
  }
  return text;
}

std::string whatIsWrong(const ControlPacket& packet, ControlRefusal refusal) {
  const std::size_t size = packet.bytes.size();
  const auto version = net::controlVersion(packet.bytes.begin(), size);
  const bool other = refusal == ControlRefusal::version || refusal == ControlRefusal::size;
  if (version && other)
    return fmt::format("heard version {}, {} bytes{}; {}", *version, size,
                       size == kMaxControlBytes ? " or more" : "", wantedVersions());
  return fmt::format("its {}; {}", kControlRefusalNames[static_cast<std::size_t>(refusal)].name,
                     wantedVersions());
}

}  // namespace

std::optional<std::string> UnusedControl::lineFor(const ControlPacket& packet,
                                                  ControlRefusal refusal) {
  const std::string wrong = whatIsWrong(packet, refusal);
  const bool before = std::find(said_.begin(), said_.end(), wrong) != said_.end();
  if (before || said_.size() >= kMaxLines) return std::nullopt;
  said_.push_back(wrong);
  return fmt::format("a packet at port {} is not used: {}", port_, wrong);
}

}  // namespace kelpie::sim
