// SPDX-License-Identifier: Apache-2.0
#include "robot/core/log/LogOutput.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace kelpie {

Expected<LogOutput> LogOutput::open(const std::string& path) {
  LogOutput output;
  output.path_ = path;
  output.file_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (output.file_ < 0) return Error{path + ": " + std::strerror(errno)};
  return Expected<LogOutput>(std::move(output));
}

LogOutput::LogOutput(LogOutput&& other) noexcept { *this = std::move(other); }

LogOutput& LogOutput::operator=(LogOutput&& other) noexcept {
  if (this == &other) return *this;
  close();
  path_ = std::move(other.path_);
  file_ = std::exchange(other.file_, -1);
  bytes_ = other.bytes_;
  error_ = std::move(other.error_);
  return *this;
}

LogOutput::~LogOutput() { close(); }

Status LogOutput::status() const {
  if (!error_.empty()) return Error{error_};
  return Done{};
}

void LogOutput::fail(const std::string& what) {
  if (error_.empty()) error_ = path_ + ": byte " + std::to_string(bytes_) + ": " + what;
}

void LogOutput::write(const std::vector<std::uint8_t>& records) {
  if (!good()) return;
  std::size_t done = 0;
  while (done < records.size()) {
    const ssize_t count = ::write(file_, records.data() + done, records.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      fail(std::string("cannot write the log: ") + std::strerror(errno));
      if (::ftruncate(file_, static_cast<off_t>(bytes_)) != 0) return;  // the reader copes
      return;
    }
    done += static_cast<std::size_t>(count);
  }
  bytes_ += records.size();
}

void LogOutput::close() {
  if (!isOpen()) return;
  if (::close(file_) != 0) fail(std::strerror(errno));
  file_ = -1;
}

}  // namespace kelpie
