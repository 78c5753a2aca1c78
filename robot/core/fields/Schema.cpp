// SPDX-License-Identifier: Apache-2.0
#include "robot/core/fields/Schema.h"

#include <cmath>
#include <utility>
#include <vector>

namespace kelpie::detail {
namespace {

using Sections = std::vector<std::pair<std::string, std::string>>;  // name, text

// "float64[3] name  # unit, min..max"
std::string schemaLine(const std::string& type, const char* name, const std::string& comment) {
  std::string line = type + ' ' + name;
  if (!comment.empty()) line += "  # " + comment;
  return line + '\n';
}

// Unit and range as a comment; empty when there is neither.
std::string rangeText(const char* unit, bool isAngle, double min, double max) {
  std::string text = unit;
  if (!std::isfinite(min) && !std::isfinite(max)) return text;
  if (!text.empty()) text += ", ";
  if (std::isfinite(min)) text += numberText(min);
  text += "..";
  if (std::isfinite(max)) text += numberText(max);
  if (isAngle) text += " deg";
  return text;
}

std::string joinSections(const Sections& sections) {
  std::string text;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (i > 0) text += std::string(80, '=') + "\nMSG: " + sections[i].first + '\n';
    text += sections[i].second;
  }
  return text;
}

std::string nameOf(const MemberType& type) {
  return type.ownName != nullptr ? std::string("kelpie/") + type.ownName
                                 : rosName(type.compilerName);
}

std::string numberTypeName(const MemberType& type) {
  const char* const family = type.kind == MemberKind::real ? "float"
                             : type.isSigned               ? "int"
                                                           : "uint";
  return family + std::to_string(8 * type.size);
}

void addSection(const MemberType& type, Sections& sections);

std::string wireTypeName(const MemberType& type, Sections& sections);

std::string sequenceTypeName(const MemberType& type, Sections& sections) {
  const std::string item = wireTypeName(*type.item, sections);
  if (type.kind == MemberKind::vector) return item + "[]";
  return item + "[" + std::to_string(type.capacity) + "]";
}

// ROS 1 name of a member's type; structs within get their section.
std::string wireTypeName(const MemberType& type, Sections& sections) {
  switch (type.kind) {
    case MemberKind::boolean: return "bool";
    case MemberKind::angle: return "float64";
    case MemberKind::time: return "int64";
    case MemberKind::text: return "string";
    case MemberKind::array:
    case MemberKind::vector: return sequenceTypeName(type, sections);
    case MemberKind::structure: addSection(type, sections); return nameOf(type);
    default: return numberTypeName(type);
  }
}

void addSection(const MemberType& type, Sections& sections) {
  const std::string name = nameOf(type);
  for (const auto& section : sections) {
    if (section.first == name) return;
  }
  const std::size_t mine = sections.size();
  sections.emplace_back(name, "");
  std::string text;
  for (std::size_t i = 0; i < type.rowCount; ++i) {
    const FieldRow& row = type.rows[i];
    const MemberType& scalar = row.type->isSequence() ? *row.type->item : *row.type;
    const bool isAngle = scalar.kind == MemberKind::angle;
    text += schemaLine(wireTypeName(*row.type, sections), row.name,
                       rangeText(row.unit, isAngle, row.min, row.max));
  }
  sections[mine].second = std::move(text);
}

}  // namespace

std::string schemaText(const MemberType& type) {
  Sections sections;
  addSection(type, sections);
  return joinSections(sections);
}

}  // namespace kelpie::detail
