// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/motion/MotionFile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>

#include "actuator/MotionList.h"
#include "robot/core/fields/FieldCheck.h"
#include "robot/core/parameters/Toml.h"
#include "tools/learn/motion/MotionSpace.h"
#include "tools/learn/walk/WalkFile.h"

namespace kelpie::learn {
namespace {

using actuator::KeyFrame;
using actuator::KeyLegs;
using actuator::kLegJoints;
using actuator::MotionData;

constexpr std::array<const char*, kLegCount> kLegs{"left_front", "left_hind", "right_front",
                                                   "right_hind"};
constexpr std::array<const char*, 4> kKeyLegs{"angles", "stay", "stance", "walk"};
const Angle kMouthShut = Angle::deg(-3.0);
constexpr std::size_t kSide = kLegJoints / 2;

// Reads one file. The first thing that is wrong stays in `wrong`.
class Reader {
 public:
  explicit Reader(std::string path) : path_(std::move(path)) {}

  Expected<MotionData> read(const toml::table& file) {
    MotionData motion;
    motion.returnTicks = 30;
    known(file, {"about", "motion", "learn", "slew", "at_once", "return_ticks", "hurried_by", "way",
                 "kick", "frame"});
    if (file.contains("about") && !file["about"].is_string()) complain(file, "about: is a text");
    number(file, "slew", motion.slew);
    number(file, "at_once", motion.atOnce);
    number(file, "return_ticks", motion.returnTicks);
    motion.hurriedBy = word(file, "hurried_by", actuator::kMotionNames, motion.hurriedBy);
    if (const toml::table* way = table(file, "way")) {
      known(*way, {"forward", "left", "turn", "forward_sd", "left_sd", "turn_sd"});
      number(*way, "forward", motion.way.forward);
      number(*way, "left", motion.way.left);
      number(*way, "turn", motion.way.turn);
      number(*way, "forward_sd", motion.way.forwardSd);
      number(*way, "left_sd", motion.way.leftSd);
      number(*way, "turn_sd", motion.way.turnSd);
    }
    if (const toml::table* kick = table(file, "kick")) {
      known(*kick, {"ahead", "left", "distance", "distance_sd", "direction", "direction_sd"});
      number(*kick, "ahead", motion.kick.ahead);
      number(*kick, "left", motion.kick.left);
      number(*kick, "distance", motion.kick.distance);
      number(*kick, "distance_sd", motion.kick.distanceSd);
      number(*kick, "direction", motion.kick.direction);
      number(*kick, "direction_sd", motion.kick.directionSd);
    }
    if (const toml::array* frames = file["frame"].as_array())
      for (const toml::node& frame : *frames) addFrame(frame, motion);
    if (motion.frames.empty()) complain(file, "has no [[frame]]");
    std::string why;
    if (wrong_.empty() && !verify(motion, &why)) wrong_ = path_ + ": " + why;
    if (!wrong_.empty()) return inOneLine(wrong_);
    return motion;
  }

 private:
  void complain(const toml::node& at, const std::string& what) {
    if (wrong_.empty()) wrong_ = fmt::format("{}:{}: {}", path_, at.source().begin.line, what);
  }
  void known(const toml::table& table, std::initializer_list<std::string_view> keys) {
    for (const auto& [key, node] : table)
      if (std::find(keys.begin(), keys.end(), key.str()) == keys.end())
        complain(node, std::string(key.str()) + ": there is no such key");
  }
  // None where the key is not.
  const toml::table* table(const toml::table& file, const char* key) {
    const toml::node* node = file.get(key);
    if (node != nullptr && !node->is_table()) complain(*node, std::string(key) + ": is no table");
    return node != nullptr ? node->as_table() : nullptr;
  }
  template <class T>
  void number(const toml::table& table, const char* key, T& value) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return;
    if constexpr (std::is_same_v<T, bool>) {
      const auto truth = node->value<bool>();
      if (!node->is_boolean()) return complain(*node, std::string(key) + ": is true or false");
      value = *truth;
    } else {
      const auto real = node->value<double>();
      if (!node->is_number()) return complain(*node, std::string(key) + ": is a number");
      if constexpr (std::is_same_v<T, Angle>) {
        value = Angle::deg(*real);
      } else if constexpr (std::is_integral_v<T>) {
        if (!(*real >= 0.0 && *real < 1e6 && *real == std::floor(*real)))
          return complain(*node, std::string(key) + ": is no whole number, or too much");
        value = static_cast<T>(*real);
      } else {
        value = *real;
      }
    }
  }
  // Three angles; false where the key is not.
  bool angles(const toml::table& table, const std::string& key, Angle* out) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return false;
    const toml::array* list = node->as_array();
    if (list == nullptr || list->size() != 3) {
      complain(*node, key + ": wants 3 angles in degrees");
      return true;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const auto value = (*list)[i].value<double>();
      const bool angle = value && std::fabs(*value) <= 180.0;
      if (!angle) complain(*node, key + ": wants 3 angles in degrees");
      out[i] = Angle::deg(angle ? *value : 0.0);
    }
    return true;
  }
  void addFrame(const toml::node& node, MotionData& motion) {
    const toml::table* frame = node.as_table();
    if (frame == nullptr) return complain(node, "frame: is not a table");
    known(*frame,
          {"ticks", "interpolate", "gain", "head", "asks_pan", "mouth", "legs", "walk", "forward",
           "left", "turn", "front", "hind", kLegs[0], kLegs[1], kLegs[2], kLegs[3]});
    KeyFrame key;
    key.mouth = kMouthShut;
    if (!frame->contains("ticks")) complain(node, "ticks: is missing");
    number(*frame, "ticks", key.ticks);
    number(*frame, "interpolate", key.interpolate);
    number(*frame, "gain", key.gain);
    key.movesHead = angles(*frame, "head", key.head.data());
    number(*frame, "asks_pan", key.asksPan);
    key.movesMouth = frame->contains("mouth");
    number(*frame, "mouth", key.mouth);
    legs(*frame, key);
    if (!motion.frames.push_back(key)) complain(node, "frame: there are more than 12");
  }
  void legs(const toml::table& frame, KeyFrame& key) {
    std::size_t found = 0;
    for (std::size_t leg = 0; leg < kLegCount; ++leg) {
      Angle* out = key.angles.data() + 3 * leg;
      const std::string name = kLegs[leg];
      const bool own = angles(frame, name, out);
      found += own || angles(frame, name.substr(name.find('_') + 1), out) ? 1 : 0;
    }
    if (found != 0 && found != kLegCount) complain(frame, "a leg has no angles");
    key.legs = found != 0 ? KeyLegs::angles : KeyLegs::stay;
    if (found != 0) return;
    key.legs = word(frame, "legs", kKeyLegs, key.legs);
    if (key.legs == KeyLegs::angles) complain(frame, "legs: stay, stance or walk");
    walk(frame, key.walk);
  }
  void walk(const toml::table& frame, WalkRequest& request) {
    std::array<const char*, kWalkKindCount> kinds{};
    for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] = nameOf(static_cast<WalkKind>(i));
    request.kind = word(frame, "walk", kinds, request.kind);
    number(frame, "forward", request.forward);
    number(frame, "left", request.left);
    Angle turn;
    number(frame, "turn", turn);
    request.turn = turn.rad();
  }
  template <class E, std::size_t N>
  E word(const toml::table& table, const char* key, const std::array<const char*, N>& words,
         E value) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return value;
    const auto text = node->value<std::string>();
    for (std::size_t i = 0; i < N; ++i)
      if (text && *text == words[i]) return static_cast<E>(i);
    complain(*node, std::string(key) + ": there is no such one");
    return value;
  }

  std::string path_;
  std::string wrong_;
};

// Of 0.1, and never -0.0, whose mirror image would be another.
double tenth(double number) { return std::round(10.0 * number) / 10.0 + 0.0; }
Angle tenth(Angle angle) { return Angle::deg(tenth(angle.deg())); }

void round(KeyFrame& key) {
  for (Angle& angle : key.head) angle = tenth(angle);
  for (Angle& angle : key.angles) angle = tenth(angle);
  key.mouth = tenth(key.mouth);
  key.walk.forward = tenth(key.walk.forward);
  key.walk.left = tenth(key.walk.left);
  key.walk.turn = tenth(Angle::rad(key.walk.turn)).rad();
}

// As its file can say it: what is left out as the default, or as left and right alike, is so of the
// numbers that are written, or the motion that is read would be written otherwise.
MotionData rounded(MotionData motion) {
  motion.slew = tenth(motion.slew);
  actuator::MotionWay& way = motion.way;
  for (double* number : {&way.forward, &way.left, &way.forwardSd, &way.leftSd})
    *number = tenth(*number);
  for (Angle* angle : {&way.turn, &way.turnSd}) *angle = tenth(*angle);
  actuator::KickEffect& kick = motion.kick;
  for (double* number : {&kick.ahead, &kick.left}) *number = tenth(*number);
  for (double* number : {&kick.distance, &kick.distanceSd}) *number = std::round(*number);
  for (Angle* angle : {&kick.direction, &kick.directionSd}) *angle = tenth(*angle);
  for (KeyFrame& key : motion.frames) round(key);
  return motion;
}

// Any words between three quotes: TOML takes neither these nor a backslash there as they are, nor
// control characters but the end of a line.
std::string escaped(const std::string& words) {
  std::string out;
  for (const char letter : words) {
    const bool control = (letter >= 0 && letter < ' ' && letter != '\n') || letter == '\x7f';
    if (letter == '"' || letter == '\\') out += '\\';
    out += control ? fmt::format("\\u{:04x}", static_cast<int>(letter)) : std::string(1, letter);
  }
  return out;
}

std::string three(const Angle* angles) {
  return fmt::format("[{:.1f}, {:.1f}, {:.1f}]", angles[0].deg(), angles[1].deg(), angles[2].deg());
}

std::string frameText(const KeyFrame& key) {
  std::string out = fmt::format("\n[[frame]]\nticks = {}\n", key.ticks);
  if (key.interpolate) out += "interpolate = true\n";
  if (key.gain != 1.0) out += fmt::format("gain = {}\n", key.gain);
  if (key.movesHead) out += fmt::format("head = {}\n", three(key.head.data()));
  if (key.asksPan) out += "asks_pan = true\n";
  if (key.movesMouth) out += fmt::format("mouth = {:.1f}\n", key.mouth.deg());
  if (key.legs == KeyLegs::angles) {
    const bool both =
        std::equal(key.angles.begin(), key.angles.begin() + kSide, key.angles.begin() + kSide);
    for (std::size_t leg = 0; leg < (both ? 2 : kLegCount); ++leg) {
      const std::string name = kLegs[leg];
      out += fmt::format("{} = {}\n", both ? name.substr(name.find('_') + 1) : name,
                         three(key.angles.data() + 3 * leg));
    }
    return out;
  }
  out += fmt::format("legs = \"{}\"\n", kKeyLegs[static_cast<std::size_t>(key.legs)]);
  if (key.walk.kind != WalkKind::normal)
    out += fmt::format("walk = \"{}\"\n", nameOf(key.walk.kind));
  if (key.walk.forward != 0.0) out += fmt::format("forward = {:.1f}\n", key.walk.forward);
  if (key.walk.left != 0.0) out += fmt::format("left = {:.1f}\n", key.walk.left);
  if (key.walk.turn != 0.0) out += fmt::format("turn = {:.1f}\n", Angle::rad(key.walk.turn).deg());
  return out;
}

}  // namespace

Expected<MotionData> readMotion(const std::string& path) {
  const auto read = readToml(path);
  if (!read) return Error{read.error()};
  const auto other = (*read)["mirror"].value<std::string>();
  if (!other) return Reader(path).read(*read);
  for (const auto& [key, node] : *read)
    if (key != "mirror" && key != "about" && key != "motion")
      return inOneLine(fmt::format("{}:{}: {}: is not beside mirror", path,
                                   node.source().begin.line, key.str()));
  const std::string file = std::filesystem::path(path).parent_path() / (*other + ".toml");
  const auto source = readToml(file);
  if (!source || source->contains("mirror"))
    return inOneLine(path + ": mirror: " + file + " is no motion");
  const auto motion = Reader(file).read(*source);
  if (!motion) return Error{motion.error()};
  return mirrored(*motion);
}

std::string motionText(const MotionData& exact, const std::string& about, MotionKind kind) {
  const MotionData motion = rounded(exact);
  std::string out = "# SPDX-License-Identifier: Apache-2.0\nabout = \"\"\"" + escaped(about) +
                    "\"\"\"\n" + actuator::listed(kind).lines;
  if (tenth(motion.slew.deg()) != 20.0) out += fmt::format("slew = {:.1f}\n", motion.slew.deg());
  if (motion.atOnce) out += "at_once = true\n";
  out += fmt::format("return_ticks = {}\n", motion.returnTicks);
  if (motion.hurriedBy != MotionKind::none)
    out += fmt::format("hurried_by = \"{}\"\n",
                       actuator::kMotionNames[static_cast<std::size_t>(motion.hurriedBy)]);
  const actuator::MotionWay& way = motion.way;
  const std::array<double, 6> numbers{way.forward,   way.left,   way.turn.deg(),
                                      way.forwardSd, way.leftSd, way.turnSd.deg()};
  if (std::any_of(numbers.begin(), numbers.end(), [](double n) { return n != 0.0; }))
    out += fmt::format(
        "way = {{ forward = {:.1f}, left = {:.1f}, turn = {:.1f}, forward_sd = {:.1f}, "
        "left_sd = {:.1f}, turn_sd = {:.1f} }}\n",
        numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5]);
  const actuator::KickEffect& kick = motion.kick;
  if (kick.distance > 0.0)
    out += fmt::format(
        "kick = {{ ahead = {:.1f}, left = {:.1f}, distance = {:.0f}, distance_sd = {:.0f}, "
        "direction = {:.1f}, direction_sd = {:.1f} }}\n",
        kick.ahead, kick.left, kick.distance, kick.distanceSd, kick.direction.deg(),
        kick.directionSd.deg());
  for (const KeyFrame& key : motion.frames) out += frameText(key);
  return out;
}

Expected<MotionKind> motionNamed(const std::string& name) {
  for (std::size_t i = 1; i < kMotionKindCount; ++i)
    if (name == actuator::kMotionNames[i]) return static_cast<MotionKind>(i);
  std::string all;
  for (std::size_t i = 1; i < kMotionKindCount; ++i)
    all += (i == 1 ? "" : ", ") + std::string(actuator::kMotionNames[i]);
  return Error{name + ": no such motion; there are " + all};
}

}  // namespace kelpie::learn
