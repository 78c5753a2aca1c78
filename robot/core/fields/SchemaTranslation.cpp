// SPDX-License-Identifier: Apache-2.0
#include "robot/core/fields/SchemaTranslation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <set>
#include <sstream>
#include <utility>

namespace kelpie {
namespace {

// Of structs in structs; text from outside could nest forever.
constexpr std::size_t kMaxDepth = 16;

std::size_t numberWidth(const std::string& type) {
  static const std::map<std::string, std::size_t> kWidths = {
      {"bool", 1},   {"int8", 1},  {"uint8", 1},  {"int16", 2},   {"uint16", 2},  {"int32", 4},
      {"uint32", 4}, {"int64", 8}, {"uint64", 8}, {"float32", 4}, {"float64", 8}, {"string", 1}};
  const auto found = kWidths.find(type);
  return found == kWidths.end() ? 0 : found->second;
}

// Members that have another name in older logs, and mean the same.
struct Renamed {
  const char* before;
  const char* today;
};
constexpr std::array<Renamed, 14> kRenamed{{{"coloursTold", "coloursGiven"},
                                            {"frontAside", "frontLateral"},
                                            {"glanceAside", "glanceLateral"},
                                            {"hindAside", "hindLateral"},
                                            {"least", "min"},
                                            {"leastSd", "minSd"},
                                            {"leastShare", "minShare"},
                                            {"leastSpeed", "minSpeed"},
                                            {"most", "max"},
                                            {"mostShare", "maxShare"},
                                            {"sway", "oscillation"},
                                            {"swaySd", "oscillationSd"},
                                            {"told", "reported"},
                                            {"turnAside", "turnLateral"}}};

const SchemaMember* find(const SchemaStruct& members, const std::string& name) {
  const auto found = std::find_if(members.begin(), members.end(),
                                  [&](const SchemaMember& m) { return m.name == name; });
  return found == members.end() ? nullptr : &*found;
}

void useNamesOfToday(SchemaStruct& members) {
  for (const Renamed& name : kRenamed) {
    if (find(members, name.today) != nullptr) continue;
    for (SchemaMember& m : members)
      if (m.name == name.before) m.name = name.today;
  }
}

// Whether a member recorded as one can be read as the other.
bool areCompatible(const SchemaMember& theirs, const SchemaMember& ours) {
  if ((theirs.type == "string") != (ours.type == "string")) return false;
  return (theirs.width > 0) == (ours.width > 0) && theirs.isArray() == ours.isArray();
}

// "# cm, 1..4": 1; "-4..-1": -1; without a range, or with one that holds it, 0.
double nearestToZero(const std::string& comment) {
  const std::size_t dots = comment.find("..");
  if (dots == std::string::npos) return 0.0;
  const std::size_t start = comment.find_last_of(" ,#", dots) + 1;
  const double min = dots > start ? std::strtod(comment.c_str() + start, nullptr) : 0.0;
  const bool open = dots + 2 >= comment.size() || comment[dots + 2] == ' ';
  const double max = open ? 0.0 : std::strtod(comment.c_str() + dots + 2, nullptr);
  return min > 0.0 ? min : std::fmin(max, 0.0);
}

// Reads one line; false when it is none of a member.
bool parseMember(const std::string& line, SchemaMember& member) {
  std::istringstream words(line);
  std::string comment;
  if (!(words >> member.type >> member.name)) return false;
  std::getline(words, comment);
  const std::size_t bracket = member.type.find('[');
  if (member.type == "string") {
    member.sequence = true;
    member.count = 0;
  }
  if (bracket != std::string::npos) {
    const std::string inside = member.type.substr(bracket + 1);
    member.sequence = inside == "]";
    member.count = std::strtoul(inside.c_str(), nullptr, 10);
    member.type.resize(bracket);
    if (member.type == "string") return false;  // a list of texts: our lists have none
    if (!member.sequence && (member.count == 0 || inside.back() != ']')) return false;
  }
  member.width = numberWidth(member.type);
  member.min = nearestToZero(comment);
  return true;
}

// Every struct that is named must be there with a member, and none may hold itself.
bool isComplete(const SchemaTypes& types, const std::string& name, std::size_t depth,
                std::set<std::string>& known) {
  if (known.count(name) > 0) return true;
  const auto found = types.structs.find(name);
  if (found == types.structs.end() || found->second.empty() || depth > kMaxDepth) return false;
  for (const SchemaMember& m : found->second)
    if (m.width == 0 && !isComplete(types, m.type, depth + 1, known)) return false;
  known.insert(name);
  return true;
}

struct Bytes {
  const std::uint8_t* at = nullptr;
  std::size_t left = 0;

  const std::uint8_t* take(std::size_t count) {
    if (at == nullptr || count > left) {
      at = nullptr;
      return nullptr;
    }
    const std::uint8_t* taken = at;
    at += count;
    left -= count;
    return taken;
  }
  bool good() const { return at != nullptr; }
};

template <class T>
double numberAs(const std::uint8_t* bytes) {
  T number;
  std::memcpy(&number, bytes, sizeof number);
  return static_cast<double>(number);
}

double numberOf(const std::string& type, const std::uint8_t* bytes) {
  if (type == "float64") return numberAs<double>(bytes);
  if (type == "float32") return numberAs<float>(bytes);
  if (type == "int64") return numberAs<std::int64_t>(bytes);
  if (type == "uint64") return numberAs<std::uint64_t>(bytes);
  if (type == "int32") return numberAs<std::int32_t>(bytes);
  if (type == "uint32") return numberAs<std::uint32_t>(bytes);
  if (type == "int16") return numberAs<std::int16_t>(bytes);
  if (type == "uint16") return numberAs<std::uint16_t>(bytes);
  return type == "int8" ? numberAs<std::int8_t>(bytes) : numberAs<std::uint8_t>(bytes);
}

template <class T>
void append(double number, std::vector<std::uint8_t>& out) {
  const double low = static_cast<double>(std::numeric_limits<T>::lowest());
  const double high = static_cast<double>(std::numeric_limits<T>::max());
  // A number that the type cannot hold becomes the nearest that it can; 2^63 itself does not fit.
  const bool fits = number > low && number < high;
  const T value = fits                 ? static_cast<T>(number)
                  : std::isnan(number) ? T{}
                  : number <= low      ? std::numeric_limits<T>::lowest()
                                       : std::numeric_limits<T>::max();
  const std::size_t before = out.size();
  out.resize(before + sizeof value);
  std::memcpy(out.data() + before, &value, sizeof value);
}

void appendNumber(const std::string& type, double number, std::vector<std::uint8_t>& out) {
  if (type == "float64") return append<double>(number, out);
  if (type == "float32") return append<float>(number, out);
  if (type == "int64") return append<std::int64_t>(number, out);
  if (type == "uint64") return append<std::uint64_t>(number, out);
  if (type == "int32") return append<std::int32_t>(number, out);
  if (type == "uint32") return append<std::uint32_t>(number, out);
  if (type == "int16") return append<std::int16_t>(number, out);
  if (type == "uint16") return append<std::uint16_t>(number, out);
  if (type == "int8") return append<std::int8_t>(number, out);
  append<std::uint8_t>(type == "bool" ? (number != 0.0 ? 1.0 : 0.0) : number, out);
}

// How many elements a member has at this place of its message.
std::size_t elements(const SchemaMember& member, Bytes& in) {
  if (!member.sequence) return member.count;
  std::uint32_t count = 0;
  const std::uint8_t* bytes = in.take(sizeof count);
  if (bytes != nullptr) std::memcpy(&count, bytes, sizeof count);
  return count;
}

void skip(const SchemaTypes& types, const SchemaMember& member, Bytes& in) {
  const std::size_t count = elements(member, in);
  // An element takes a byte at least. A length from outside can be any.
  if (count > in.left || member.width > 0) {
    in.take(count > in.left ? in.left + 1 : count * member.width);
    return;
  }
  for (std::size_t i = 0; i < count && in.good(); ++i) {
    for (const SchemaMember& inner : types.structs.at(member.type)) skip(types, inner, in);
  }
}

// One message on its way from their list to ours.
class Walk {
 public:
  Walk(const SchemaTypes& theirs, const SchemaTypes& ours, std::vector<std::uint8_t>& out)
      : theirs_(theirs), ours_(ours), out_(out) {}

  // `defaults` may be without bytes: then numbers become 0, or the nearest that their range allows.
  bool structOf(const std::string& theirType, Bytes& in, const std::string& ourType,
                Bytes& defaults) {
    std::map<std::string, std::pair<const SchemaMember*, Bytes>> given;
    for (const SchemaMember& member : theirs_.structs.at(theirType)) {
      given[member.name] = {&member, in};
      skip(theirs_, member, in);
    }
    if (!in.good()) return false;
    for (const SchemaMember& member : ours_.structs.at(ourType)) {
      const auto found = given.find(member.name);
      const bool usable = found != given.end() && areCompatible(*found->second.first, member);
      Bytes ourDefault = defaults;
      if (defaults.good()) skip(ours_, member, defaults);
      if (usable && !memberOf(*found->second.first, found->second.second, member, ourDefault))
        return false;
      if (!usable) defaultOf(member, ourDefault);
    }
    return true;
  }

 private:
  bool memberOf(const SchemaMember& theirs, Bytes in, const SchemaMember& ours, Bytes defaults) {
    const std::size_t given = elements(theirs, in);
    if (defaults.good() && ours.sequence) defaults = {};  // of no length: no element to go by
    const std::size_t wanted = ours.sequence ? given : ours.count;
    if (ours.sequence) append<std::uint32_t>(static_cast<double>(given), out_);
    if (ours.width > 0 && ours.type == theirs.type && given == wanted) {
      const std::uint8_t* bytes = in.take(given * ours.width);
      if (bytes != nullptr) out_.insert(out_.end(), bytes, bytes + given * ours.width);
      return bytes != nullptr;
    }
    for (std::size_t i = 0; i < wanted; ++i) {
      if (!elementOf(theirs, i < given ? &in : nullptr, ours, defaults)) return false;
    }
    return true;
  }

  // `in` is null where their array is shorter than ours.
  bool elementOf(const SchemaMember& theirs, Bytes* in, const SchemaMember& ours, Bytes& defaults) {
    if (in == nullptr) {
      oneDefault(ours, defaults);
      return true;
    }
    if (ours.width == 0) return structOf(theirs.type, *in, ours.type, defaults);
    const std::uint8_t* bytes = in->take(theirs.width);
    if (defaults.good()) defaults.take(ours.width);
    if (bytes == nullptr) return false;
    appendNumber(ours.type, numberOf(theirs.type, bytes), out_);
    return true;
  }

  void defaultOf(const SchemaMember& ours, Bytes defaults) {
    if (!defaults.good()) {
      if (ours.sequence) append<std::uint32_t>(0.0, out_);
      for (std::size_t i = 0; i < ours.count; ++i) oneDefault(ours, defaults);
      return;
    }
    Bytes end = defaults;
    skip(ours_, ours, end);
    if (end.good()) out_.insert(out_.end(), defaults.at, end.at);
  }

  void oneDefault(const SchemaMember& ours, Bytes& defaults) {
    SchemaMember single = ours;
    single.sequence = false;
    single.count = 1;
    if (defaults.good()) {
      const Bytes here = defaults;
      skip(ours_, single, defaults);
      return defaultOf(single, here);
    }
    if (ours.width > 0) return appendNumber(ours.type, ours.min, out_);
    for (const SchemaMember& inner : ours_.structs.at(ours.type)) defaultOf(inner, {});
  }

  const SchemaTypes& theirs_;
  const SchemaTypes& ours_;
  std::vector<std::uint8_t>& out_;
};

}  // namespace

Expected<SchemaTypes> SchemaTypes::parse(const std::string& root, const std::string& text) {
  SchemaTypes types;
  types.root = root;
  SchemaStruct* members = &types.structs[root];
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.empty() || line[0] == '=' || line[0] == '#') continue;
    if (line.compare(0, 5, "MSG: ") == 0) {
      members = &types.structs[line.substr(5)];
      continue;
    }
    SchemaMember member;
    if (!parseMember(line, member))
      return Error{"schema line " + std::to_string(number) + ": \"" + line + "\""};
    members->push_back(std::move(member));
  }
  std::set<std::string> known;
  if (!isComplete(types, root, 0, known)) return Error{"schema: a type is missing or holds itself"};
  return types;
}

Expected<SchemaTranslation> SchemaTranslation::make(const std::string& name,
                                                    const std::string& theirs,
                                                    const std::string& ours) {
  auto recorded = SchemaTypes::parse(name, theirs);
  if (!recorded) return Error{recorded.error()};
  for (auto& one : recorded->structs) useNamesOfToday(one.second);
  auto now = SchemaTypes::parse(name, ours);
  if (!now) return Error{now.error()};
  return SchemaTranslation(std::move(*recorded), std::move(*now));
}

SchemaTranslation::SchemaTranslation(SchemaTypes theirs, SchemaTypes ours)
    : theirs_(std::move(theirs)), ours_(std::move(ours)) {
  compare("", theirs_.root, ours_.root);
}

void SchemaTranslation::compare(const std::string& path, const std::string& theirType,
                                const std::string& ourType) {
  const SchemaStruct& recorded = theirs_.structs.at(theirType);
  const SchemaStruct& now = ours_.structs.at(ourType);
  for (const SchemaMember& m : now) {
    const SchemaMember* given = find(recorded, m.name);
    if (given == nullptr || !areCompatible(*given, m))
      defaulted_.push_back(path + m.name);
    else if (m.width == 0)
      compare(path + m.name + '.', given->type, m.type);
  }
  for (const SchemaMember& m : recorded)
    if (find(now, m.name) == nullptr) leftOut_.push_back(path + m.name);
}

bool SchemaTranslation::translate(const std::uint8_t* data, std::size_t size,
                                  const std::vector<std::uint8_t>& defaults,
                                  std::vector<std::uint8_t>& out) const {
  out.clear();
  Bytes in{data, size};
  Bytes standard{defaults.data(), defaults.size()};
  Walk walk(theirs_, ours_, out);
  return walk.structOf(theirs_.root, in, ours_.root, standard) && in.left == 0;
}

}  // namespace kelpie
