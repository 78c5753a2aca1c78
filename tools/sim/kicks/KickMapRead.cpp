// SPDX-License-Identifier: Apache-2.0
#include <cctype>
#include <cstdlib>
#include <map>

#include "tools/sim/kicks/KickMap.h"

namespace kelpie::sim {
namespace {

// What the module is made of: numbers, None, tuples, dictionaries.
struct Value {
  bool isNone = false;
  double number = 0.0;
  std::vector<Value> items;
  std::map<std::string, Value> of;
};

// Reads the text that kickMapText() wrote. The first thing that is wrong stays in `wrong`.
class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}

  // The dictionary of that name at the beginning of a line.
  Value dictionary(const std::string& name) {
    const std::size_t found = text_.find("\n" + name + " = {");
    if (found == std::string::npos) {
      complain("there is no " + name);
      return {};
    }
    at_ = text_.find('{', found);
    return value();
  }
  const std::string& wrong() const { return wrong_; }

 private:
  void complain(const std::string& what) {
    if (wrong_.empty()) wrong_ = "kick map: " + what;
  }
  char next() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char letter) {
    if (next() != letter) return false;
    ++at_;
    return true;
  }

  std::string key() {
    const std::size_t end = text_.find(':', at_);
    if (end == std::string::npos) return "";
    std::string name = text_.substr(at_, end - at_);
    at_ = end;
    if (name.front() == '\'') return name.substr(1, name.size() - 2);
    return name;
  }

  Value value() {
    Value read;
    if (take('{')) {
      while (wrong_.empty() && !take('}')) {
        next();
        const std::string name = key();
        if (!take(':')) complain("a key without a value");
        read.of[name] = value();
        take(',');
      }
    } else if (take('(')) {
      while (wrong_.empty() && !take(')')) {
        read.items.push_back(value());
        take(',');
      }
    } else if (text_.compare(at_, 4, "None") == 0) {
      at_ += 4;
      read.isNone = true;
    } else {
      read.number = number();
    }
    return read;
  }

  double number() {
    const char* start = text_.c_str() + at_;
    char* end = nullptr;
    const double read = std::strtod(start, &end);
    if (end == start) complain("something else where a number should be");
    at_ += static_cast<std::size_t>(end - start);
    return read;
  }

  const std::string& text_;
  std::size_t at_ = 0;
  std::string wrong_;
};

constexpr std::size_t kOutcome = 6;

bool isOutcome(const Value& value) { return value.isNone || value.items.size() == kOutcome; }

KickCell cellOf(const Value& value) {
  KickCell cell;
  if (!isOutcome(value) || value.isNone) return cell;
  const auto at = [&](std::size_t i) { return value.items[i].number; };
  cell.runs = 1;
  cell.went = 0.01 * at(0);
  cell.direction = Angle::deg(at(1));
  cell.directionSd = Angle::deg(at(2));
  cell.distance = at(3);
  cell.distanceSd = at(4);
  cell.fell = 0.01 * at(5);
  return cell;
}

std::vector<double> numbersOf(const Value& value) {
  std::vector<double> numbers;
  for (const Value& item : value.items) numbers.push_back(item.number);
  return numbers;
}

Point2<Robot> placeOf(const Value& value) {
  if (value.items.size() != 2) return {};
  return {value.items[0].number, value.items[1].number};
}

MotionKind motionOf(const std::string& key) {
  std::string name = key.substr(key.find('.') + 1);
  for (char& letter : name) letter = static_cast<char>(std::tolower(letter));
  for (std::size_t i = 0; i < kMotionKindCount; ++i)
    if (name == actuator::kMotionNames[i]) return static_cast<MotionKind>(i);
  return MotionKind::none;
}

Status readPlaces(Value& kick, KickGrid& grid) {
  grid.ahead = numbersOf(kick.of["ahead"]);
  grid.lateral = numbersOf(kick.of["aside"]);
  if (kick.of["window"].items.size() == 2) {
    grid.window.min = placeOf(kick.of["window"].items[0]);
    grid.window.max = placeOf(kick.of["window"].items[1]);
  }
  grid.window.best = placeOf(kick.of["best"]);
  for (const Value& row : kick.of["places"].items)
    for (const Value& outcome : row.items) {
      if (!isOutcome(outcome)) return Error{"kick map: an outcome that is none"};
      grid.cells.push_back(cellOf(outcome));
    }
  if (grid.cells.empty() || grid.cells.size() != grid.ahead.size() * grid.lateral.size())
    return Error{"kick map: not as many outcomes as places"};
  return Done{};
}

Expected<KickGrid> gridOf(const std::string& key, Value& kick, KickFrom from) {
  KickGrid grid;
  grid.motion = motionOf(key);
  grid.from = from;
  if (!isKick(grid.motion)) return Error{"kick map: " + key + " is no kick"};
  if (kick.of["whole"].items.size() != kOutcome || kick.of["way"].items.size() != 3)
    return Error{"kick map: " + key + " has no whole or no way"};
  grid.window.whole = cellOf(kick.of["whole"]);
  grid.frames = kick.of["frames"].number;
  const std::vector<double> way = numbersOf(kick.of["way"]);
  grid.way.left = -way[0];
  grid.way.forward = way[1];
  grid.way.turn = Angle::deg(way[2]);
  if (from == KickFrom::hold) {
    grid.ahead = grid.lateral = {0.0};
    grid.cells = {grid.window.whole};
    return grid;
  }
  const Status places = readPlaces(kick, grid);
  if (!places) return Error{places.error()};
  return grid;
}

}  // namespace

Expected<KickMap> readKickMap(const std::string& text) {
  KickMap map;
  Reader reader(text);
  for (std::size_t from = 0; from < kKickFroms; ++from) {
    Value kicks = reader.dictionary(kKickFromNames[from]);
    if (!reader.wrong().empty()) return Error{reader.wrong()};
    for (auto& [key, kick] : kicks.of) {
      auto grid = gridOf(key, kick, static_cast<KickFrom>(from));
      if (!grid) return Error{grid.error()};
      map.push_back(std::move(*grid));
    }
  }
  return map;
}

}  // namespace kelpie::sim
