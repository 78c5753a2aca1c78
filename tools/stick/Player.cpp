// SPDX-License-Identifier: Apache-2.0
#include "tools/stick/Player.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include "behaviour/PlayerMark.h"
#include "tools/stick/ElfObject.h"
#include "tools/stick/Programs.h"

namespace kelpie::stick {
namespace {

namespace fs = std::filesystem;

// A robot's whole memory, so that no program is larger, packed or not.
constexpr std::size_t kLargestProgram = 64U << 20U;

// While it lives no program that is started writes a longer file: one that tries is ended.
class FileLimit {
 public:
  explicit FileLimit(std::size_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit = {std::min<rlim_t>(bytes, before_.rlim_cur), before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileLimit(const FileLimit&) = delete;
  FileLimit& operator=(const FileLimit&) = delete;
  ~FileLimit() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_ = {};
};

// The word that ends with a zero behind the mark.
std::string wordAfter(const std::string& program, const std::string& mark) {
  const std::size_t at = program.find(mark);
  if (at == std::string::npos) return "";
  const std::size_t from = at + mark.size();
  const std::size_t end = program.find('\0', from);
  return end == std::string::npos ? "" : program.substr(from, end - from);
}

// By gzip, in a folder of its own, and no more of it than a robot could take.
Expected<std::string> unpacked(const std::string& file) {
  const auto scratch = ScratchFolder::make();
  if (!scratch) return Error{scratch.error()};
  const std::string gzip = findProgram({"gzip"});
  if (gzip.empty()) return Error{file + ": is packed, and gzip is missing"};
  const std::string program = scratch->path() + "/program";
  std::error_code error;
  fs::copy_file(file, program + ".gz", error);
  const FileLimit limit(kLargestProgram);
  if (error || !runProgram({gzip, "-d", program + ".gz"}))
    return Error{file + ": gzip cannot unpack it into a program of 64 MB, a robot's memory"};
  return readWhole(program);
}

}  // namespace

Expected<std::string> playerOfFile(const std::string& file) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  if (!error && size > kLargestProgram) return Error{file + ": is larger than a robot's memory"};
  auto bytes = readWhole(file);
  if (bytes && bytes->rfind("\x1f\x8b", 0) == 0) bytes = unpacked(file);
  if (!bytes) return bytes;
  const Status program = ElfObject::checkProgram(*bytes, file);
  if (!program) return Error{program.error()};
  const std::string player = wordAfter(*bytes, behaviour::kPlayerMark);
  if (player == "simple" || player == "python") return player;
  return Error{file + ": is no agent of Kelpie: it names no player of ours"};
}

std::string playerLine(const std::string& player, const std::string& folder) {
  if (player == "simple")
    return "player: simple, without Python: it walks to the ball, and no more";
  return "player: python; it plays the behaviours of " + folder;
}

}  // namespace kelpie::stick
