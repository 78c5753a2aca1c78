// SPDX-License-Identifier: Apache-2.0
#include "tools/stick/Player.h"

#include <fmt/core.h>

#include <filesystem>
#include <map>

#include "behaviour/PlayerMark.h"
#include "robot/core/Checksum.h"
#include "tools/stick/ElfObject.h"
#include "tools/stick/Programs.h"

namespace kelpie::stick {
namespace {

namespace fs = std::filesystem;

// The word that ends with a zero behind the mark.
std::string wordAfter(const std::string& program, const std::string& mark) {
  const std::size_t at = program.find(mark);
  if (at == std::string::npos) return "";
  const std::size_t from = at + mark.size();
  const std::size_t end = program.find('\0', from);
  return end == std::string::npos ? "" : program.substr(from, end - from);
}

// By gzip, in a folder of its own.
Expected<std::string> unpacked(const std::string& file) {
  const auto scratch = ScratchFolder::make();
  if (!scratch) return Error{scratch.error()};
  const std::string gzip = findProgram({"gzip"});
  if (gzip.empty()) return Error{file + ": is packed, and gzip is missing"};
  const std::string program = scratch->path() + "/program";
  std::error_code error;
  fs::copy_file(file, program + ".gz", error);
  if (error || !runProgram({gzip, "-d", program + ".gz"}))
    return Error{file + ": gzip cannot unpack it"};
  return readWhole(program);
}

void addText(Crc32& sum, const std::string& text) {
  sum.add(reinterpret_cast<const std::uint8_t*>(text.c_str()), text.size() + 1);
}

}  // namespace

Player playerIn(const std::string& program) {
  const std::string name = wordAfter(program, behaviour::kPlayerMark);
  if (name == "simple") return {name, ""};
  if (name == "python") return {name, wordAfter(program, behaviour::kBehavioursMark)};
  return {};
}

Expected<std::string> programOfFile(const std::string& file) {
  auto bytes = readWhole(file);
  if (bytes && bytes->rfind("\x1f\x8b", 0) == 0) bytes = unpacked(file);
  if (!bytes) return bytes;
  const Status program = ElfObject::checkProgram(*bytes, file);
  return program ? bytes : Error{program.error()};
}

std::string numberOfBehaviours(const std::string& folder) {
  std::map<std::string, fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".py")
      files[entry.path().lexically_relative(folder).generic_string()] = entry.path();
  Crc32 sum;
  for (const auto& [name, path] : files) {
    const auto text = readWhole(path.string());
    addText(sum, name);
    addText(sum, text ? *text : "");
  }
  return fmt::format("{:08x}", sum.value());
}

std::string playerLine(const Player& player, const std::string& folder) {
  if (player.name == "simple")
    return "player: simple, without Python: it walks to the ball, and no more";
  if (player.name.empty()) return "player: the program does not say which";
  if (player.behaviours == numberOfBehaviours(folder))
    return "player: python, with the behaviours of " + folder;
  return "player: python, with OTHER behaviours than those of " + folder +
         "; toolchain/build-object makes the program anew";
}

}  // namespace kelpie::stick
