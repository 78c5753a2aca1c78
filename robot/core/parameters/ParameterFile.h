// SPDX-License-Identifier: Apache-2.0
// Reads parameter structs from TOML files laid over each other by key: compiled default, field,
// robot, game. Host only (toml++); the robot gets its parameters compiled by `kelpie stick`.
//
//   [vision.ball]              a section, and the nested structs in it
//   minSamples = 6             no unit: a bare number
//   maxDistance = "450cm"      with unit: number and unit in quotes
//   directionError = "2.5deg"  angles in deg or rad, times in s or ms
//
// Strict: an unknown section or key, a wrong type, a missing or wrong unit, a number out of range,
// a key given twice are errors "file:line: key: what is wrong", and nothing of that file is
// applied. Enums are numbers. Lists of structs (a field's lines) cannot be set.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "robot/core/fields/MemberType.h"
#include "robot/core/parameters/Parameter.h"

namespace kelpie {

// A parameter that is not at its default.
struct ParameterChange {
  std::string key;
  std::string value;
  std::string defaultValue;
  std::string source;  // "file:line"; "program" when no file set it

  std::string text() const {
    return key + " = " + value + " (default " + defaultValue + ") from " + source;
  }
};

namespace detail {
constexpr bool holdsText(const MemberType& type) {
  for (std::size_t i = 0; i < type.rowCount; ++i) {
    const MemberType& member = *type.rows[i].type;
    if (member.kind == MemberKind::text || holdsText(member)) return true;
  }
  return false;
}
}  // namespace detail

class ParameterSet {
 public:
  // The values of `params` now are its defaults. It must live as long as the set.
  template <class P>
  void add(const std::string& section, P& params) {
    static_assert(!detail::holdsText(memberTypeOf<P>()),
                  "a parameter is a number: a file could not set a text");
    add(section, memberTypeOf<P>(), &params);
  }

  Status overlay(const std::string& path);
  // Sets one parameter that is a single number or yes or no, from the program.
  Status assign(const std::string& key, double number);
  // The same of a number with its unit: "80cm".
  Status assign(const std::string& key, const std::string& measure);
  std::vector<ParameterChange> changes() const;
  // Hash of all names, units, ranges and values: equal hashes, equal parameters.
  std::uint64_t hash() const;

 private:
  struct Section {
    std::string name;
    const MemberType* type;
    const void* params;
  };

  void add(const std::string& section, const MemberType& type, void* params);
  Expected<Parameter*> single(const std::string& key);

  std::vector<Parameter> parameters_;
  std::vector<Section> sections_;
};

}  // namespace kelpie
