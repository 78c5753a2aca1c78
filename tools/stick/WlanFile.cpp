// SPDX-License-Identifier: Apache-2.0
#include "tools/stick/WlanFile.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>

#include "tools/cli/DataFolder.h"
#include "tools/stick/Programs.h"

namespace kelpie::stick {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 12> kKeys = {
    "HOSTNAME", "ETHER_IP", "ETHER_NETMASK", "IP_GATEWAY",   "ESSID",        "WEPENABLE",
    "WEPKEY",   "APMODE",   "CHANNEL",       "DNS_SERVER_1", "DNS_DEFDNAME", "USE_DHCP"};

bool isKnown(const std::string& key) {
  return std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end();
}

// A key without a value, as files have of what is off, is as good as none, but for these.
bool isOff(const std::string& key, const std::string& value) {
  constexpr std::array<std::string_view, 4> kNeverEmpty = {"ESSID", "WEPENABLE", "APMODE",
                                                           "USE_DHCP"};
  return value.empty() && isKnown(key) &&
         std::find(kNeverEmpty.begin(), kNeverEmpty.end(), key) == kNeverEmpty.end();
}

// As Sony's are: upper-case words joined by underscores. Anything else is a slip of the pen.
bool isKey(const std::string& key) {
  constexpr const char* kAllowed = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
  return !key.empty() && key.size() <= 32 && key[0] >= 'A' && key[0] <= 'Z' &&
         key.find_first_not_of(kAllowed) == std::string::npos;
}

std::string trimmed(const std::string& line) {
  const auto first = line.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

bool isNumber(const std::string& text, int low, int high) {
  if (text.empty() || text.size() > 3) return false;
  if (text.find_first_not_of("0123456789") != std::string::npos) return false;
  const int number = std::stoi(text);
  return number >= low && number <= high;
}

// Four numbers without leading zeros, which some read as octal.
std::optional<std::uint32_t> addressIn(const std::string& text) {
  std::istringstream parts(text + ".");
  std::string part;
  std::uint32_t address = 0;
  int count = 0;
  while (std::getline(parts, part, '.')) {
    if (!isNumber(part, 0, 255) || (part.size() > 1 && part[0] == '0')) return std::nullopt;
    address = address << 8U | static_cast<std::uint32_t>(std::stoi(part));
    ++count;
  }
  return count == 4 ? std::optional(address) : std::nullopt;
}

bool isAddress(const std::string& text) {
  const auto address = addressIn(text);
  return address && *address != 0 && *address != 0xFFFFFFFFU;
}

// Ones from above, then zeros.
bool isNetmask(const std::string& text) {
  const auto mask = addressIn(text);
  return mask && *mask != 0 && ((~*mask + 1) & ~*mask) == 0;
}

// Letters, digits, hyphens and dots, 63 characters at most.
bool isName(const std::string& text) {
  constexpr const char* kAllowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-.";
  return !text.empty() && text.size() <= 63 &&
         text.find_first_not_of(kAllowed) == std::string::npos;
}

// No control character, and no comment, which the robot would take for a part of the value.
bool isPlain(const std::string& text) {
  const auto control = [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7F || c == '"';
  };
  return std::none_of(text.begin(), text.end(), control) && text.find(" #") == std::string::npos;
}

// 5 or 13 characters, or 0x and 10 or 26 hexadecimal digits.
bool isWepKey(const std::string& text) {
  if (text.rfind("0x", 0) != 0) return text.size() == 5 || text.size() == 13;
  const bool hexadecimal = text.find_first_not_of("0123456789abcdefABCDEF", 2) == std::string::npos;
  return hexadecimal && (text.size() == 12 || text.size() == 28);
}

bool isGood(const std::string& key, const std::string& value) {
  if (!isPlain(value)) return false;
  if (isOff(key, value)) return true;
  if (!isKnown(key)) return true;
  if (key == "WEPENABLE" || key == "USE_DHCP") return value == "0" || value == "1";
  if (key == "APMODE") return value == "0" || value == "1" || value == "2";
  if (key == "CHANNEL") return isNumber(value, 1, 11) && value[0] != '0';
  if (key == "WEPKEY") return isWepKey(value);
  if (key == "ESSID") return !value.empty() && value.size() <= 32;
  if (key == "HOSTNAME" || key == "DNS_DEFDNAME") return isName(value);
  if (key == "ETHER_NETMASK") return isNetmask(value);
  return isAddress(value);
}

Status needs(const std::map<std::string, std::string>& values, const std::string& file) {
  const auto is = [&](const char* key, const char* value) {
    const auto found = values.find(key);
    return found != values.end() && found->second == value;
  };
  const auto lacks = [&](const char* key) { return values.count(key) == 0 || is(key, ""); };
  if (lacks("ESSID")) return Error{file + ": has no ESSID, the network's name"};
  if (is("WEPENABLE", "1") && lacks("WEPKEY"))
    return Error{file + ": has no WEPKEY, which WEPENABLE=1 needs"};
  if (!is("USE_DHCP", "1") && lacks("ETHER_IP"))
    return Error{file + ": has no ETHER_IP, which a robot without USE_DHCP=1 needs"};
  return Done{};
}

bool isInside(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const fs::path relative = fs::relative(file, folder, error);
  return !error && !relative.empty() && *relative.begin() != "..";
}

}  // namespace

Expected<WlanSettings> wlanSettings(const std::string& text, const std::string& file) {
  constexpr const char* kByteOrderMark = "\xEF\xBB\xBF";  // as Notepad writes
  std::istringstream lines(text.rfind(kByteOrderMark, 0) == 0 ? text.substr(3) : text);
  std::string line;
  WlanSettings settings;
  std::map<std::string, std::string> values;
  for (int number = 1; std::getline(lines, line); ++number) {
    line = trimmed(line);
    if (line.empty() || line[0] == '#') continue;
    const auto equals = line.find('=');
    const std::string key = trimmed(line.substr(0, equals));
    if (equals == std::string::npos || !isKey(key))
      return Error{fmt::format("{}:{}: not KEY=VALUE as WLANCONF.TXT has it", file, number)};
    const std::string value = trimmed(line.substr(equals + 1));
    if (!isGood(key, value))
      return Error{fmt::format("{}:{}: {}'s value", file, number, key) +
                   " is not one that the robot takes (docs/flash.md)"};
    if (!values.emplace(key, value).second)
      return Error{fmt::format("{}:{}: {} is there twice", file, number, key)};
    if (!isOff(key, value)) settings.text += fmt::format("{}={}\n", key, value);
    if (!isKnown(key)) settings.unknown.push_back(key);
  }
  const Status complete = needs(values, file);
  if (!complete) return Error{complete.error()};
  return settings;
}

Expected<WlanSettings> readWlanFile(const std::string& file) {
  if (isInside(file, cli::dataFolder()))
    return Error{file + ": lies in the source tree, where keys do not belong"};
  const auto text = readWhole(file);
  if (!text) return Error{text.error()};
  return wlanSettings(*text, file);
}

std::string unknownKeysLine(const WlanSettings& settings, const std::string& file) {
  if (settings.unknown.empty()) return "";
  return fmt::format("{}: not known here and kept as they are: {}", file,
                     fmt::join(settings.unknown, ", "));
}

}  // namespace kelpie::stick
