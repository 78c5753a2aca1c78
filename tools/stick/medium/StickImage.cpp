// SPDX-License-Identifier: Apache-2.0
#include "tools/stick/medium/StickImage.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <cstdio>
#include <filesystem>
#include <set>
#include <vector>

#include "tools/cli/Process.h"
#include "tools/stick/Programs.h"
#include "tools/stick/medium/StickFolder.h"

namespace kelpie::stick {
namespace {

namespace fs = std::filesystem;

// 15360 sectors of 512 bytes, 7.5 MiB, a little less than a stick of 8 MB; 4 KB a cluster make 1900
// clusters, fewer than the 4085 at which FAT16 begins.
const std::vector<std::string> kFormat = {"-C", "-T", "15360", "-h",       "16", "-s",    "32",
                                          "-c", "8",  "-N",    "A1B0E507", "-v", "KELPIE"};
constexpr std::time_t kLongAgo = 946684800;  // 2000-01-01 UTC

// One of mtools' programs at work on the image.
Status mtools(const std::string& program, const std::string& image,
              const std::vector<std::string>& words) {
  if (cli::interrupted()) return Error{"stopped; no image was made"};
  const std::string path = findProgram({program});
  if (path.empty())
    return Error{program + " is missing: an image needs the package mtools; a folder does not"};
  std::vector<std::string> argv = {"/usr/bin/env",
                                   "TZ=UTC",
                                   "SOURCE_DATE_EPOCH=" + std::to_string(kLongAgo),
                                   "MTOOLSRC=/dev/null",
                                   "MTOOLS_SKIP_CHECK=1",
                                   path,
                                   "-i",
                                   image};
  argv.insert(argv.end(), words.begin(), words.end());
  const auto ran = runProgram(argv);
  return ran ? Status(Done{}) : Error{program + ran.error().substr(argv[0].size())};
}

std::vector<std::string> with(std::vector<std::string> words, const std::string& last) {
  words.push_back(last);
  return words;
}

// Every folder before those in it.
std::set<std::string> foldersOf(const StickTree& tree) {
  std::set<std::string> folders;
  for (const auto& file : tree)
    for (fs::path at = fs::path(file.path).parent_path(); !at.empty(); at = at.parent_path())
      folders.insert(at.string());
  return folders;
}

void dateLongAgo(const std::string& path) {
  const timespec times[2] = {{kLongAgo, 0}, {kLongAgo, 0}};
  utimensat(AT_FDCWD, path.c_str(), times, 0);
}

Status copyIn(const StickTree& tree, const std::string& folder, const std::string& image) {
  for (const auto& directory : foldersOf(tree)) {
    const Status made = mtools("mmd", image, {"::" + directory});
    if (!made) return made;
  }
  for (const auto& file : tree) {
    const std::string from = folder + "/" + file.path;
    dateLongAgo(from);
    const Status copied = mtools("mcopy", image, {"-m", "-Q", from, "::" + file.path});
    if (!copied) return copied;
  }
  return Done{};
}

Status readBack(const StickTree& tree, const std::string& folder, const std::string& image) {
  for (const auto& file : tree) {
    const std::string to = folder + "/back";
    const Status copied = mtools("mcopy", image, {"-n", "::" + file.path, to});
    if (!copied) return copied;
    const auto bytes = readWhole(to);
    if (!bytes || *bytes != file.bytes)
      return Error{image + ": " + file.path + " reads back otherwise than written"};
    std::remove(to.c_str());
  }
  return Done{};
}

Status fill(const StickTree& tree, const std::string& folder, const std::string& image) {
  Status status = writeFiles(tree, folder, [](const std::string&) {});
  if (status) status = mtools("mformat", image, with(kFormat, "::"));
  if (status) status = copyIn(tree, folder, image);
  return status ? readBack(tree, folder, image) : status;
}

}  // namespace

Status writeImage(const StickTree& tree, const std::string& image) {
  const auto scratch = ScratchFolder::make();
  if (!scratch) return Error{scratch.error()};
  const std::string part = image + ".part";
  std::remove(part.c_str());
  Status status = fill(tree, scratch->path(), part);
  if (status && std::rename(part.c_str(), image.c_str()) != 0)
    status = Error{image + ": cannot be written"};
  if (!status) std::remove(part.c_str());
  return status;
}

}  // namespace kelpie::stick
