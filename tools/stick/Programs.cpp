// SPDX-License-Identifier: Apache-2.0
#include "tools/stick/Programs.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include "tools/cli/Process.h"

namespace kelpie::stick {
namespace {

namespace fs = std::filesystem;

constexpr int kUntilItEnds = -1;  // as poll takes it

}  // namespace

Expected<std::string> readWhole(const std::string& file) {
  std::error_code error;
  if (!fs::exists(file, error)) return Error{file + ": does not exist"};
  if (fs::is_directory(file, error)) return Error{file + ": is a folder, not a file"};
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad()) return Error{file + ": cannot be read"};
  return bytes;
}

Expected<ScratchFolder> ScratchFolder::make() {
  std::error_code error;
  std::string path = (fs::temp_directory_path(error) / "kelpie-stick-XXXXXX").string();
  if (error || mkdtemp(path.data()) == nullptr) return Error{path + ": cannot be made"};
  return ScratchFolder(path);
}

ScratchFolder::ScratchFolder(ScratchFolder&& other) noexcept
    : path_(std::exchange(other.path_, "")) {}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

std::string findProgram(const std::vector<std::string>& names) {
  const char* search = std::getenv("PATH");
  for (const auto& name : names) {
    std::istringstream folders(search == nullptr ? "" : search);
    std::string folder;
    while (std::getline(folders, folder, ':')) {
      const std::string path = (fs::path(folder) / name).string();
      if (access(path.c_str(), X_OK) == 0) return path;
    }
  }
  return "";
}

Expected<std::string> runProgram(const std::vector<std::string>& argv) {
  auto process = cli::Process::start(argv, true);
  if (!process) return Error{process.error()};
  std::string output;
  std::string line;
  std::string last;
  while (process->readLine(line, kUntilItEnds)) {
    output += line + "\n";
    last = line;
  }
  const int code = process->wait();
  if (code == 0) return output;
  return Error{argv[0] + ": " + (last.empty() ? "exit code " + std::to_string(code) : last)};
}

}  // namespace kelpie::stick
