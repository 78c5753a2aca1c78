// SPDX-License-Identifier: Apache-2.0
// A table of what happened in every frame of a trial, as CSV for other programs: one column for
// each field of the row's list (robot/core/fields/Fields.h), whose name ends in its unit. For
// --traces.
#pragma once

#include <fstream>
#include <string>
#include <type_traits>

#include "robot/core/Angle.h"
#include "robot/core/Time.h"
#include "robot/core/fields/Fields.h"

namespace kelpie::experiments {

// Numbers as they are, angles in degrees, times in seconds, enums by number.
template <class T>
void writeCell(const T& value, std::ostream& out) {
  if constexpr (std::is_same_v<T, Angle>) {
    out << value.deg();
  } else if constexpr (std::is_same_v<T, TimeUs>) {
    out << value.seconds();
  } else if constexpr (std::is_enum_v<T>) {
    out << static_cast<int>(value);
  } else {
    out << value;
  }
}

template <class Row>
class Trace {
 public:
  // Without a path it writes nothing.
  explicit Trace(const std::string& path) {
    if (path.empty()) return;
    out_.open(path);
    const char* comma = "";
    forEachFieldOf<Row>([&](const auto& f) {
      out_ << comma << f.name;
      comma = ",";
    });
    out_ << '\n';
  }

  void add(const Row& row) {
    if (!out_.is_open()) return;
    const char* comma = "";
    forEachField(row, [&](const auto&, const auto& cell) {
      out_ << comma;
      writeCell(cell, out_);
      comma = ",";
    });
    out_ << '\n';
  }

 private:
  std::ofstream out_;
};

}  // namespace kelpie::experiments
