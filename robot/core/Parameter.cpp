// SPDX-License-Identifier: Apache-2.0
#include "robot/core/Parameter.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>

#include "robot/core/Maths.h"

namespace kelpie {
namespace {

using Kind = Parameter::Kind;

constexpr double kDegree = maths::kPi / 180.0;

// "rad/s" -> "/s" when the unit is an angle or a rate of one.
std::optional<std::string> afterAngle(const std::string& unit) {
  if (unit.compare(0, 3, "rad") != 0 && unit.compare(0, 3, "deg") != 0) return std::nullopt;
  if (unit.size() > 3 && unit[3] != '/') return std::nullopt;
  return unit.substr(3);
}

double angleFactor(const std::string& unit) { return unit[0] == 'd' ? kDegree : 1.0; }

// In seconds; 0 when it is no unit of time.
double timeFactor(const std::string& unit) {
  if (unit == "s") return 1.0;
  if (unit == "ms") return 1e-3;
  return unit == "us" ? 1e-6 : 0.0;
}

// The unit that the member is kept in.
std::string keptUnit(const Parameter& parameter) {
  if (parameter.kind == Kind::time) return "us";
  if (parameter.kind != Kind::angle) return parameter.unit;
  return "rad" + afterAngle(parameter.unit).value_or("");
}

// What a number with this unit is multiplied by; nothing when the unit is a wrong one.
std::optional<double> factor(const std::string& kept, const std::string& written) {
  if (kept == written) return 1.0;
  const auto keptRest = afterAngle(kept);
  if (keptRest && keptRest == afterAngle(written)) {
    return angleFactor(written) == 1.0 ? 1.0 / kDegree : kDegree;
  }
  const double keptTime = timeFactor(kept);
  const double writtenTime = timeFactor(written);
  if (keptTime == 0.0 || writtenTime == 0.0) return std::nullopt;
  return writtenTime / keptTime;
}

// How people are told to write it.
std::string shownUnit(const Parameter& parameter) {
  const std::string kept = keptUnit(parameter);
  if (parameter.kind == Kind::time) return "s or ms";
  if (const auto rest = afterAngle(kept)) return "deg" + *rest + " or rad" + *rest;
  return kept == "s" ? "s or ms" : kept;
}

Error wrong(const Parameter& parameter, const std::string& what) {
  return {parameter.key + ": " + what};
}

std::string shortText(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.10g", value);
  return text.data();
}

std::string rangeText(const Parameter& parameter) {
  const std::string low = std::isfinite(parameter.min) ? shortText(parameter.min) : "";
  const std::string high = std::isfinite(parameter.max) ? shortText(parameter.max) : "";
  const std::string unit = parameter.kind == Kind::angle ? "deg" : parameter.unit;
  return low + ".." + high + (unit.empty() ? "" : ' ' + unit);
}

// `kept` is in the member's unit; `written` is for the message.
Expected<double> checked(const Parameter& parameter, double kept, const std::string& written) {
  const double inRangeUnit = parameter.kind == Kind::angle ? kept / kDegree : kept;
  // A limit in degrees given in radians may come out a rounding error beyond it.
  const double slack = parameter.kind == Kind::angle ? 1e-9 : 0.0;
  const bool good = std::isfinite(kept) && inRangeUnit >= parameter.min - slack &&
                    inRangeUnit <= parameter.max + slack;
  if (!good) return wrong(parameter, written + " is outside " + rangeText(parameter));
  const bool needsWhole = parameter.kind == Kind::whole || parameter.kind == Kind::time;
  if (needsWhole && kept != std::floor(kept)) {
    return wrong(parameter, written + " is not a whole number");
  }
  return kept;
}

}  // namespace

Expected<double> numberWithUnit(const Parameter& parameter, const std::string& text) {
  const std::string kept = keptUnit(parameter);
  if (parameter.kind == Kind::boolean) return wrong(parameter, "takes true or false, not a text");
  if (kept.empty()) return wrong(parameter, "takes a number without quotes and unit");
  double number = 0.0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), number);
  if (parsed.ec != std::errc()) return wrong(parameter, '"' + text + "\" is not a number");
  std::string unit(parsed.ptr, text.data() + text.size());
  if (!unit.empty() && unit.front() == ' ') unit.erase(0, 1);
  const std::string expected = "expected " + shownUnit(parameter);
  if (unit.empty()) return wrong(parameter, '"' + text + "\" has no unit, " + expected);
  const auto scale = factor(kept, unit);
  if (!scale) return wrong(parameter, '"' + text + "\" has a wrong unit, " + expected);
  // Times are kept in whole microseconds: 0.1 ms times 1000 must not miss one by a rounding error.
  const double value = number * *scale;
  const bool isTime = parameter.kind == Kind::time;
  return checked(parameter, isTime ? std::round(value) : value, text);
}

Expected<double> bareNumber(const Parameter& parameter, double number) {
  if (parameter.kind == Kind::boolean) return wrong(parameter, "takes true or false, not a number");
  if (!keptUnit(parameter).empty()) {
    return wrong(parameter, shortText(number) + " has no unit, expected " + shownUnit(parameter) +
                                ", in quotes");
  }
  return checked(parameter, number, shortText(number));
}

std::string valueText(const Parameter& parameter, const std::vector<double>& values) {
  std::string unit = keptUnit(parameter);
  double scale = 1.0;
  if (const auto rest = afterAngle(unit)) {
    scale = 1.0 / angleFactor("deg") * angleFactor(unit);
    unit = "deg" + *rest;
  } else if (parameter.kind == Kind::time) {
    scale = 1e-6;
    unit = "s";
  }
  std::string text;
  for (const double value : values) {
    if (!text.empty()) text += ", ";
    if (parameter.kind == Kind::boolean) {
      text += value != 0.0 ? "true" : "false";
    } else {
      text += shortText(value * scale) + unit;
    }
  }
  return parameter.isSequence ? '[' + text + ']' : text;
}

}  // namespace kelpie
