// SPDX-License-Identifier: Apache-2.0
#include "tools/stick/EmonLog.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>

#include "tools/stick/Programs.h"

namespace kelpie::stick {
namespace {

using Address = std::optional<std::uint32_t>;

constexpr std::size_t kLongestLine = 500;  // characters; the robot's have 80

std::uint32_t hexadecimal(const std::string& text) {
  return static_cast<std::uint32_t>(std::stoul(text, nullptr, 16));
}

// The first number after this name, "epc:$14" or "ra:r31"; a colon and blanks may stand between.
Address registerIn(const std::string& line, const char* name) {
  const auto at = line.find(name);
  if (at == std::string::npos) return std::nullopt;
  static const std::regex kNumber("^[: ]*0x([0-9a-fA-F]{1,8})\\b");
  std::smatch found;
  const std::string rest = line.substr(at + std::char_traits<char>::length(name));
  if (!std::regex_search(rest, found, kNumber)) return std::nullopt;
  return hexadecimal(found[1]);
}

void keepFirst(const Address& found, Address& place) {
  if (found && !place) place = found;
}

void readRegisters(const std::string& line, EmonLog& log) {
  keepFirst(registerIn(line, "epc:$14"), log.counter);
  keepFirst(registerIn(line, "badvaddr: $8"), log.badAddress);
  keepFirst(registerIn(line, "cause:$13"), log.cause);
  keepFirst(registerIn(line, "ra:r31"), log.returnAddress);
  keepFirst(registerIn(line, "gp:r28"), log.globalPointer);
}

void readStack(const std::string& line, EmonLog& log) {
  static const std::regex kLine("^\\s*([0-9a-fA-F]{8}):((?: [0-9a-fA-F]{8}){1,4})(?:\\s|$)");
  std::smatch found;
  if (!std::regex_search(line, found, kLine)) return;
  std::istringstream words(found[2]);
  std::string word;
  for (std::uint32_t at = hexadecimal(found[1]); words >> word; at += 4)
    log.stack.push_back({at, hexadecimal(word)});
}

constexpr std::array<const char*, 16> kCauses = {"interrupt",
                                                 "a write to a page that may only be read",
                                                 "no page at a load or a fetch",
                                                 "no page at a store",
                                                 "address error at a load or a fetch",
                                                 "address error at a store",
                                                 "bus error at a fetch",
                                                 "bus error at a load or a store",
                                                 "system call",
                                                 "breakpoint",
                                                 "an instruction that does not exist",
                                                 "a coprocessor that is not on",
                                                 "overflow",
                                                 "trap (a division by zero, or abort)",
                                                 "",
                                                 "floating point"};

// A return address points behind the call and its delay slot.
void addReturn(const std::string& where, std::uint32_t linked, const ElfObject& object,
               std::vector<CrashPlace>& places) {
  if (object.isCode(linked) && object.followsCall(linked)) places.push_back({where, linked - 8});
}

}  // namespace

Expected<EmonLog> parseEmonLog(const std::string& text, const std::string& file) {
  EmonLog log;
  std::istringstream lines(text);
  std::string line;
  while (std::getline(lines, line)) {
    line.resize(std::min(line.size(), kLongestLine));  // the search recurses with every blank
    readRegisters(line, log);
    readStack(line, log);
  }
  if (!log.counter) return Error{file + ": no line says epc:$14; is it an EMON.LOG?"};
  return log;
}

Expected<std::uint32_t> loadOffset(const EmonLog& log, const ElfObject& object,
                                   std::optional<std::uint32_t> given) {
  if (given) return *given;
  if (log.globalPointer) return *log.globalPointer - object.globalPointer();
  return Error{"the log has no gp:r28, which tells where the object was; give --loaded-at"};
}

Expected<std::vector<CrashPlace>> crashPlaces(const EmonLog& log, const ElfObject& object,
                                              std::uint32_t offset) {
  std::vector<CrashPlace> places;
  const std::uint32_t counter = *log.counter - offset;
  if (object.isCode(counter)) places.push_back({"died in", counter});
  if (log.returnAddress) addReturn("returns to", *log.returnAddress - offset, object, places);
  for (const auto& word : log.stack)
    addReturn(fmt::format("0x{:08x}", word.at), word.value - offset, object, places);
  if (!places.empty()) return places;
  return Error{
      fmt::format("0x{:08x}, where it died, is not in this object, nor is anything on the "
                  "stack",
                  *log.counter)};
}

std::string causeText(std::uint32_t cause) {
  const std::uint32_t code = cause >> 2U & 31U;
  const std::string text = code < kCauses.size() ? kCauses[code] : "";
  return fmt::format("{}: {}", code, text.empty() ? "see the R7000's manual" : text);
}

Expected<std::vector<std::string>> linesOf(const std::vector<CrashPlace>& places,
                                           const std::string& object) {
  const std::string program = findProgram({"mipsel-linux-gnu-addr2line", "addr2line"});
  if (program.empty())
    return Error{"addr2line is missing; it is in the package binutils-mipsel-linux-gnu"};
  std::vector<std::string> argv = {program, "-f", "-C", "-e", object};
  for (const auto& place : places) argv.push_back(fmt::format("0x{:x}", place.address));
  const auto output = runProgram(argv);
  if (!output) return Error{output.error()};
  std::vector<std::string> lines;
  std::istringstream pairs(*output);
  std::string function;
  std::string at;
  while (std::getline(pairs, function) && std::getline(pairs, at))
    lines.push_back(fmt::format("{} ({})", function, at));
  if (lines.size() == places.size()) return lines;
  return Error{program + ": cannot read " + object};
}

}  // namespace kelpie::stick
