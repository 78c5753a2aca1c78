// SPDX-License-Identifier: Apache-2.0
#include "tools/match/TraceWords.h"

#include <fmt/core.h>

#include <cmath>
#include <vector>

#include "actuator/motion/MotionData.h"

namespace kelpie::match {
namespace {

// Bytes of the UTF-8 character at the beginning, 0 when there is none that may be shown.
std::size_t characterAt(std::string_view text) {
  const auto lead = static_cast<std::uint8_t>(text[0]);
  if (lead < 0x80) return lead >= 0x20 && lead != 0x7f ? 1 : 0;
  const std::size_t size = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((static_cast<std::uint8_t>(text[i]) & 0xc0U) != 0x80U) return 0;
  return size;
}

std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t size = characterAt(text);
    shown += size > 0 ? text.substr(0, size) : "?";
    text.remove_prefix(size > 0 ? size : 1);
  }
  return shown;
}

// What stands behind the first word of a module, a place in the decision tree, is for `kelpie
// tree`.
std::string moduleOf(const TraceStep& step) {
  const std::string_view whole = step.module.view();
  return printable(whole.substr(0, whole.find(' ')));
}

// Who decided: a module without a name goes by its layer.
std::string deciderOf(const TraceStep& step) {
  return step.module.empty() ? wordFor(step.layer) : moduleOf(step);
}

std::string choiceOf(const TraceStep& step) {
  return deciderOf(step) + ": " + (step.branch.empty() ? "?" : printable(step.branch.view()));
}

// "12 cm/s ahead"; empty where it rounds to nothing.
std::string speed(double value, const char* unit, const char* positive, const char* negative) {
  const std::string number = shortNumber(std::fabs(value));
  if (number == "0") return {};
  return number + ' ' + unit + ' ' + (value > 0.0 ? positive : negative);
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts)
    if (!part.empty()) text += (text.empty() ? "" : " and ") + part;
  return text;
}

std::string walkWords(const WalkRequest& walk) {
  const std::string way = joined({speed(walk.forward, "cm/s", "ahead", "back"),
                                  speed(walk.left, "cm/s", "to the left", "to the right")});
  const std::string turn =
      speed(Angle::rad(walk.turn).deg(), "deg/s", "to the left", "to the right");
  const std::string words =
      joined({way.empty() ? "" : "walk " + way, turn.empty() ? "" : "turn " + turn});
  return words.empty() ? "stand" : words;
}

std::string headWords(const HeadRequest& head) {
  if (head.aim == HeadAim::point)
    return fmt::format("look at a point {} cm ahead and {} cm to the {}",
                       shortNumber(head.target.y), shortNumber(std::fabs(head.target.x)),
                       head.target.x > 0.0 ? "right" : "left");
  const bool joints = head.aim == HeadAim::joints;
  const Angle pan = joints ? head.headPan : head.direction;
  const Angle up = joints ? head.neckTilt + head.headNod : head.elevation;
  const std::string way = joined({speed(pan.deg(), "deg", "to the left", "to the right"),
                                  speed(up.deg(), "deg", "up", "down")});
  return "look " + (way.empty() ? "straight ahead" : way);
}

std::string fallbackWords(Fallback fallback) {
  switch (fallback) {
    case Fallback::none: return {};
    case Fallback::notLoaded: return "the behaviours did not load";
    case Fallback::scriptError: return "the behaviours stopped with an error";
    case Fallback::badCommand: return "the behaviours' Command could not be used";
    default: return "the behaviours took too long";
  }
}

}  // namespace

const char* wordFor(TraceLayer layer) {
  switch (layer) {
    case TraceLayer::player: return "player";
    case TraceLayer::role: return "role";
    case TraceLayer::decision: return "decision";
    default: return "skill";
  }
}

std::string shortNumber(double number) {
  const double size = std::fabs(number);
  const int decimals = size >= 9.95 ? 0 : size >= 0.995 ? 1 : 2;
  std::string text = fmt::format("{:.{}f}", number, decimals);
  if (decimals > 0) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string reasonOf(const TraceStep& step) {
  std::string_view left = step.reason.view();
  std::string filled;
  std::size_t next = 0;
  for (std::size_t at = left.find("{}"); at != std::string_view::npos; at = left.find("{}")) {
    filled += left.substr(0, at);
    filled += next < step.numbers.size() ? shortNumber(step.numbers[next++]) : "?";
    left.remove_prefix(at + 2);
  }
  return printable(filled + std::string(left));
}

std::string lineOf(const TraceStep& step) {
  const std::string reason = reasonOf(step);
  return choiceOf(step) + (reason.empty() ? "" : " - " + reason);
}

std::string sentenceOf(const TraceStep& step) {
  const std::string reason = reasonOf(step);
  const std::string name = step.module.empty() ? "" : ' ' + moduleOf(step);
  return fmt::format("The {}{} chose {}{}.", wordFor(step.layer), name,
                     step.branch.empty() ? "?" : printable(step.branch.view()),
                     reason.empty() ? "" : ": " + reason);
}

std::string chainOf(const Trace& trace) {
  std::string text;
  for (const TraceStep& step : trace) text += (text.empty() ? "" : " > ") + choiceOf(step);
  return text;
}

std::string requestOf(const Command& command) {
  if (command.motion != MotionKind::none)
    return fmt::format("play the motion {}",
                       actuator::kMotionNames[static_cast<std::size_t>(command.motion)]);
  return walkWords(command.walk) + "; " + headWords(command.head);
}

std::string insteadOf(bool driven, const Command& command) {
  if (driven) return "a person drives the robot";
  const std::string words = fallbackWords(command.fallback);
  return words.empty() ? words : words + ", so the robot stands and looks left and right";
}

std::vector<std::string> reasonLines(bool driven, const Command& command) {
  const std::string instead = insteadOf(driven, command);
  if (!instead.empty()) return {instead};
  std::vector<std::string> lines;
  lines.reserve(command.trace.size());
  for (const TraceStep& step : command.trace) lines.push_back(lineOf(step));
  return lines;
}

}  // namespace kelpie::match
