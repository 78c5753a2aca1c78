// SPDX-License-Identifier: Apache-2.0
#include "robot/core/parameters/ParameterFile.h"

#include <algorithm>
#include <map>
#include <utility>

#include "robot/core/Checksum.h"
#include "robot/core/fields/Encoding.h"
#include "robot/core/parameters/Toml.h"

namespace kelpie {
namespace {

using Kind = Parameter::Kind;

struct Assignment {
  std::size_t parameter;
  std::vector<double> values;
  std::size_t line;
};

// Takes a parsed file apart. Collects what to assign and what is wrong, by line, as toml++ hands
// out keys by alphabet.
class FileReader {
 public:
  explicit FileReader(const std::vector<Parameter>& parameters) : parameters_(parameters) {}

  void takeTable(const toml::table& table, const std::string& prefix) {
    for (const auto& [key, node] : table) {
      const std::string path = prefix + std::string(key.str());
      if (const std::size_t found = find(path); found < parameters_.size()) {
        takeParameter(found, node);
      } else if (!isSection(path)) {
        const bool section = node.is_table() || node.is_array_of_tables();
        const std::size_t line = section ? node.source().begin.line : key.source().begin.line;
        report(line, section ? "unknown section [" + path + ']' : "unknown key " + path);
      } else if (const toml::table* inner = node.as_table()) {
        takeTable(*inner, path + '.');
      } else {
        report(key.source().begin.line, path + " is a section, not a key");
      }
    }
  }

  const std::vector<Assignment>& assignments() const { return assignments_; }
  const std::map<std::size_t, std::string>& complaints() const { return complaints_; }

 private:
  std::size_t find(const std::string& key) const {
    const auto found = std::find_if(parameters_.begin(), parameters_.end(),
                                    [&](const Parameter& p) { return p.key == key; });
    return static_cast<std::size_t>(found - parameters_.begin());
  }
  bool isSection(const std::string& path) const {
    return std::any_of(parameters_.begin(), parameters_.end(), [&](const Parameter& p) {
      return p.key.compare(0, path.size() + 1, path + '.') == 0;
    });
  }

  void takeParameter(std::size_t index, const toml::node& node) {
    const Parameter& parameter = parameters_[index];
    const std::size_t line = node.source().begin.line;
    if (parameter.kind == Kind::list) {
      return report(line, parameter.key + ": a list that no parameter file can set");
    }
    Assignment assignment{index, {}, line};
    if (!parameter.isSequence) {
      assignment.values.push_back(scalar(parameter, node));
    } else if (!takeArray(parameter, node, assignment.values)) {
      return;
    }
    assignments_.push_back(std::move(assignment));
  }

  bool takeArray(const Parameter& parameter, const toml::node& node, std::vector<double>& values) {
    const toml::array* items = node.as_array();
    const std::size_t line = node.source().begin.line;
    if (items == nullptr) {
      report(line, parameter.key + ": takes an array");
      return false;
    }
    if (items->size() < parameter.minCount || items->size() > parameter.maxCount) {
      const bool fixed = parameter.minCount == parameter.maxCount;
      report(line, parameter.key + ": " + std::to_string(items->size()) + " elements, expected " +
                       (fixed ? "" : "at most ") + std::to_string(parameter.maxCount));
      return false;
    }
    for (const toml::node& item : *items) values.push_back(scalar(parameter, item));
    return true;
  }

  double scalar(const Parameter& parameter, const toml::node& node) {
    const Expected<double> value = scalarOf(parameter, node);
    if (value) return *value;
    report(node.source().begin.line, value.error());
    return 0.0;
  }

  static Expected<double> scalarOf(const Parameter& parameter, const toml::node& node) {
    if (const auto* text = node.as_string()) return numberWithUnit(parameter, text->get());
    if (const auto* number = node.as_floating_point()) return bareNumber(parameter, number->get());
    if (const auto* number = node.as_integer()) {
      return bareNumber(parameter, static_cast<double>(number->get()));
    }
    const auto* truth = node.as_boolean();
    if (truth != nullptr && parameter.kind == Kind::boolean) return truth->get() ? 1.0 : 0.0;
    return Error{parameter.key + ": cannot be " + kindOf(node)};
  }

  static std::string kindOf(const toml::node& node) {
    if (node.is_boolean()) return "true or false";
    if (node.is_table()) return "a section";
    return node.is_array() ? "an array" : "a date";
  }

  void report(std::size_t line, const std::string& what) { complaints_.emplace(line, what); }

  const std::vector<Parameter>& parameters_;
  std::vector<Assignment> assignments_;
  std::map<std::size_t, std::string> complaints_;  // the first of each line
};

std::string place(const std::string& path, std::size_t line) {
  return path + ':' + std::to_string(line);
}

// The parameters of a struct and of those within.
void list(const std::string& section, const MemberType& type, void* params,
          std::vector<Parameter>& parameters) {
  MemberPlaces at;
  type.places(params, at);
  for (std::size_t i = 0; i < type.rowCount; ++i) {
    const FieldRow& row = type.rows[i];
    void* const value = const_cast<void*>(at[i]);
    if (row.type->kind == MemberKind::structure)
      list(section + '.' + row.name, *row.type, value, parameters);
    else
      parameters.push_back(parameterOf(section, row, value));
  }
}

}  // namespace

void ParameterSet::add(const std::string& section, const MemberType& type, void* params) {
  list(section, type, params, parameters_);
  sections_.push_back({section, &type, params});
}

Status ParameterSet::overlay(const std::string& path) {
  const Expected<toml::table> file = readToml(path);
  if (!file) return Error{file.error()};
  FileReader reader(parameters_);
  reader.takeTable(*file, "");
  if (!reader.complaints().empty()) {
    const auto& [line, what] = *reader.complaints().begin();
    return inOneLine(place(path, line) + ": " + what);
  }
  for (const Assignment& assignment : reader.assignments()) {
    Parameter& parameter = parameters_[assignment.parameter];
    parameter.set(assignment.values);
    parameter.source = place(path, assignment.line);
  }
  return Done{};
}

Expected<Parameter*> ParameterSet::single(const std::string& key) {
  const auto found = std::find_if(parameters_.begin(), parameters_.end(),
                                  [&](const Parameter& p) { return p.key == key; });
  if (found == parameters_.end()) return Error{"unknown key " + key};
  if (found->isSequence || found->kind == Kind::list) return Error{key + ": takes an array"};
  return &*found;
}

Status ParameterSet::assign(const std::string& key, double number) {
  const auto found = single(key);
  if (!found) return Error{found.error()};
  const bool truth = (*found)->kind == Kind::boolean && (number == 0.0 || number == 1.0);
  const Expected<double> value = truth ? Expected<double>(number) : bareNumber(**found, number);
  if (!value) return Error{value.error()};
  (*found)->set({*value});
  return Done{};
}

Status ParameterSet::assign(const std::string& key, const std::string& measure) {
  const auto found = single(key);
  if (!found) return Error{found.error()};
  const Expected<double> value = numberWithUnit(**found, measure);
  if (!value) return Error{value.error()};
  (*found)->set({*value});
  return Done{};
}

std::vector<ParameterChange> ParameterSet::changes() const {
  std::vector<ParameterChange> changes;
  for (const Parameter& parameter : parameters_) {
    if (parameter.kind == Kind::list) continue;
    const std::vector<double> values = parameter.get();
    if (values == parameter.defaults) continue;
    changes.push_back({parameter.key, valueText(parameter, values),
                       valueText(parameter, parameter.defaults),
                       parameter.source.empty() ? "program" : parameter.source});
  }
  return changes;
}

std::uint64_t ParameterSet::hash() const {
  Fnv1a hash;
  for (const Section& section : sections_) {
    std::vector<std::uint8_t> bytes;
    detail::encode(*section.type, section.params, bytes);
    const std::string schema = detail::schemaText(*section.type);
    hash.add(section.name.data(), section.name.size() + 1);
    hash.add(schema.data(), schema.size() + 1);
    hash.add(bytes.data(), bytes.size());
  }
  return hash.value();
}

}  // namespace kelpie
