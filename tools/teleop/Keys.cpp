// SPDX-License-Identifier: Apache-2.0
#include "tools/teleop/Keys.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <sstream>

#include "actuator/MotionList.h"

namespace kelpie::teleop {
namespace {

constexpr double kLongest = 3600.0;  // s
constexpr char kEscape = '\033';
constexpr std::size_t kHelpWidth = 100;

constexpr KeyBinding walkKey(char key, const char* word, int forward, int left, int turn) {
  return {key, word, KeyAct::step, forward, left, turn};
}
constexpr KeyBinding headKey(char key, int pan, int tilt) {
  return {key, "", KeyAct::step, 0, 0, 0, pan, tilt};
}
// A grab is held on to afterwards.
constexpr KeyBinding motionKey(char key, MotionKind motion) {
  const KeyAct act = useOf(motion) == MotionUse::grab ? KeyAct::hold : KeyAct::motion;
  return {key, "", act, 0, 0, 0, 0, 0, motion};
}
constexpr KeyBinding actKey(char key, const char* word, KeyAct act) { return {key, word, act}; }

constexpr KeyBinding kOwnBindings[] = {
    walkKey('w', "up", 1, 0, 0),
    walkKey('s', "down", -1, 0, 0),
    walkKey('a', "left", 0, 0, 1),
    walkKey('d', "right", 0, 0, -1),
    walkKey('q', "", 0, 1, 0),
    walkKey('e', "", 0, -1, 0),
    actKey(' ', "space", KeyAct::stop),
    headKey('i', 0, 1),
    headKey('k', 0, -1),
    headKey('j', 1, 0),
    headKey('l', -1, 0),
    actKey('m', "", KeyAct::lookAhead),
    actKey('o', "", KeyAct::mouth),
    actKey('u', "", KeyAct::getUp),
    actKey('x', "", KeyAct::quit),
};

constexpr std::size_t motionKeys() {
  std::size_t count = 0;
  for (const actuator::ListedMotion& motion : actuator::kMotionList) count += motion.key != 0;
  return count;
}

// Those above, and those of the motions as their files list them.
constexpr auto allBindings() {
  std::array<KeyBinding, std::size(kOwnBindings) + motionKeys()> all{};
  std::size_t count = 0;
  for (const KeyBinding& binding : kOwnBindings) all[count++] = binding;
  for (std::size_t i = 0; i < actuator::kMotionList.size(); ++i)
    if (const char key = actuator::kMotionList[i].key; key != 0)
      all[count++] = motionKey(key, static_cast<MotionKind>(i));
  return all;
}
constexpr auto kBindings = allBindings();

// "A" of the arrow ESC [ A, or of ESC O A as some terminals send it.
char keyOfArrow(char letter) {
  switch (letter) {
    case 'A': return 'w';
    case 'B': return 's';
    case 'C': return 'd';
    case 'D': return 'a';
    default: return 0;
  }
}

bool readTime(const std::string& word, double& seconds) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), seconds);
  return error == std::errc() && end == word.data() + word.size() && seconds >= 0.0 &&
         seconds <= kLongest;
}

// What is wrong with a line's words, or nothing.
std::string readLine(std::istringstream& words, double notBefore, TimedKey& key) {
  std::string time, word, more;
  words >> time >> word >> more;
  if (!readTime(time, key.seconds))
    return "'" + time + "' is not a time of 0 to " + std::to_string(static_cast<int>(kLongest)) +
           " s";
  if (word.empty()) return "wants TIME KEY, but has no key";
  if (!more.empty()) return "wants TIME KEY, but has more words";
  key.key = keyOf(word);
  if (key.key == 0) return "'" + word + "' is not a key; kelpie teleop --help lists them";
  return key.seconds < notBefore ? "'" + time + "' is before the line above" : "";
}

}  // namespace

const KeyBinding* bindingOf(char key) {
  for (const KeyBinding& binding : kBindings)
    if (binding.key == key) return &binding;
  return nullptr;
}

std::vector<std::string> keyHelp() {
  std::vector<std::string> lines{
      "w s ahead back  a d turn  q e aside  space stop  i k j l head  m head ahead  o mouth  u get "
      "up",
      "x quit"};
  for (const actuator::ListedMotion& motion : actuator::kMotionList) {
    if (motion.key == 0) continue;
    const std::string text = fmt::format("{} {}", motion.key, motion.word);
    if (lines.back().size() + 2 + text.size() > kHelpWidth) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : "  ") + text;
  }
  return lines;
}

char keyOf(const std::string& word) {
  for (const KeyBinding& binding : kBindings)
    if (word == binding.word || word == std::string(1, binding.key))
      return word.empty() ? '\0' : binding.key;
  return 0;
}

char takeKey(std::string& typed) {
  while (!typed.empty()) {
    const char first = typed[0];
    const bool sequence =
        first == kEscape && (typed.size() < 2 || typed[1] == '[' || typed[1] == 'O');
    if (sequence && typed.size() < 3) return 0;
    const char key = sequence ? keyOfArrow(typed[2]) : first;
    typed.erase(0, sequence ? 3 : 1);
    if (bindingOf(key) != nullptr) return key;
  }
  return 0;
}

Expected<std::vector<TimedKey>> readKeys(const std::string& text, const std::string& name) {
  std::vector<TimedKey> keys;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    if ((words >> std::ws).eof()) continue;
    TimedKey key{};
    const std::string wrong = readLine(words, keys.empty() ? 0.0 : keys.back().seconds, key);
    if (!wrong.empty()) return Error{fmt::format("{}:{}: {}", name, number, wrong)};
    keys.push_back(key);
  }
  if (keys.empty()) return Error{name + ": holds no keys"};
  return keys;
}

}  // namespace kelpie::teleop
