// SPDX-License-Identifier: Apache-2.0
// One tunable as the parameter reader sees it: its full key ("vision.ball.maxDistance"), unit,
// range and the way to its member. Numbers pass as doubles in the unit that the member is kept in:
// angles in radians, TimeUs in microseconds.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "robot/core/fields/MemberType.h"

namespace kelpie {

struct Parameter {
  // list: of structs, which a parameter file cannot set
  enum class Kind { boolean, whole, real, angle, time, list };

  std::string key;
  std::string unit;
  Kind kind = Kind::real;
  double min = 0.0;  // of the field; degrees for an angle
  double max = 0.0;
  bool isSequence = false;
  std::size_t minCount = 1;
  std::size_t maxCount = 1;
  const MemberType* type = nullptr;
  void* member = nullptr;
  std::vector<double> defaults{};
  std::string source{};  // "file:line" that set it last, empty while nothing did

  std::vector<double> get() const;
  void set(const std::vector<double>& values);
};

// The member of a struct that is kept under `section`, with its value as the default.
Parameter parameterOf(const std::string& section, const FieldRow& row, void* member);

// A number as written, with its unit: "12deg", "-3.5 cm/s". The result is in the member's unit and
// in range. Errors start with the parameter's key.
Expected<double> numberWithUnit(const Parameter& parameter, const std::string& text);
// A number written without unit.
Expected<double> bareNumber(const Parameter& parameter, double number);
// "12deg", "[1, 2]cm": for people, in degrees and seconds.
std::string valueText(const Parameter& parameter, const std::vector<double>& values);

}  // namespace kelpie
