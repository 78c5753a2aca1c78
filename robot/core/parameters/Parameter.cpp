// SPDX-License-Identifier: Apache-2.0
#include "robot/core/parameters/Parameter.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <optional>

#include "robot/core/Maths.h"
#include "robot/core/fields/FieldCheck.h"

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

// How people are asked to write it.
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

Kind kindOf(const MemberType& type) {
  switch (type.kind) {
    case MemberKind::boolean: return Kind::boolean;
    case MemberKind::angle: return Kind::angle;
    case MemberKind::time: return Kind::time;
    case MemberKind::real: return Kind::real;
    case MemberKind::structure: return Kind::list;
    default: return Kind::whole;
  }
}

// What the member's type can hold narrows the field's range. Doubles hold whole numbers exactly up
// to 2^53.
void narrowRange(Parameter& parameter, const MemberType& type) {
  if (parameter.kind != Kind::whole && parameter.kind != Kind::time) return;
  const int bits = 8 * static_cast<int>(type.size);
  double low = -9007199254740992.0;
  double high = 9007199254740992.0;
  if (parameter.kind == Kind::whole) {
    low = std::max(low, type.isSigned ? -std::ldexp(1.0, bits - 1) : 0.0);
    high = std::min(high, std::ldexp(1.0, type.isSigned ? bits - 1 : bits) - 1.0);
  }
  parameter.min = std::max(parameter.min, low);
  parameter.max = std::min(parameter.max, high);
}

template <class T>
void writeAs(T value, void* at) {
  std::memcpy(at, &value, sizeof value);
}

void writeSigned(double number, std::size_t size, void* at) {
  if (size == 1) return writeAs(static_cast<std::int8_t>(number), at);
  if (size == 2) return writeAs(static_cast<std::int16_t>(number), at);
  if (size == 4) return writeAs(static_cast<std::int32_t>(number), at);
  writeAs(static_cast<std::int64_t>(number), at);
}

void writeUnsigned(double number, std::size_t size, void* at) {
  if (size == 1) return writeAs(static_cast<std::uint8_t>(number), at);
  if (size == 2) return writeAs(static_cast<std::uint16_t>(number), at);
  if (size == 4) return writeAs(static_cast<std::uint32_t>(number), at);
  writeAs(static_cast<std::uint64_t>(number), at);
}

void writeNumber(const MemberType& type, double number, void* at) {
  switch (type.kind) {
    case MemberKind::boolean: return writeAs(number != 0.0, at);
    case MemberKind::angle: return writeAs(Angle::rad(number), at);
    case MemberKind::time: return writeSigned(number, type.size, at);
    case MemberKind::real:
      return type.size == 4 ? writeAs(static_cast<float>(number), at) : writeAs(number, at);
    default:
      return type.isSigned ? writeSigned(number, type.size, at)
                           : writeUnsigned(number, type.size, at);
  }
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

std::vector<double> Parameter::get() const {
  if (!isSequence) return {detail::numberOf(*type, member)};
  const Items items = type->items(member);
  std::vector<double> values;
  values.reserve(items.count);
  for (std::size_t i = 0; i < items.count; ++i)
    values.push_back(detail::numberOf(*type->item, items.at(i, type->item->size)));
  return values;
}

void Parameter::set(const std::vector<double>& values) {
  if (!isSequence) return writeNumber(*type, values[0], member);
  if (type->resize != nullptr) type->resize(member, values.size());
  const Items items = type->items(member);
  for (std::size_t i = 0; i < values.size(); ++i)
    writeNumber(*type->item, values[i], const_cast<void*>(items.at(i, type->item->size)));
}

Parameter parameterOf(const std::string& section, const FieldRow& row, void* member) {
  Parameter parameter{section + '.' + row.name, row.unit, {}, row.min, row.max};
  const MemberType& scalar = row.type->isSequence() ? *row.type->item : *row.type;
  parameter.kind = kindOf(scalar);
  parameter.type = row.type;
  parameter.member = member;
  if (parameter.kind == Kind::list) return parameter;
  narrowRange(parameter, scalar);
  parameter.isSequence = row.type->isSequence();
  if (parameter.isSequence) parameter.maxCount = row.type->capacity;
  parameter.minCount = row.type->kind == MemberKind::vector ? 0 : parameter.maxCount;
  parameter.defaults = parameter.get();
  return parameter;
}

}  // namespace kelpie
