// SPDX-License-Identifier: Apache-2.0
// Files of a test, small logs, and what a log holds, read by our reader or record by record.
#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "robot/core/log/LogReader.h"
#include "robot/core/log/LogWriter.h"
#include "robot/core/types/Command.h"

namespace kelpie {

// Of the running test alone.
inline std::string folderOfTest() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return testing::TempDir() + "kelpie_" + test->test_suite_name() + "_" + test->name();
}

inline std::string pathOf(const std::string& name) { return folderOfTest() + "/" + name; }

// Its files go with the test.
class LogFiles : public testing::Test {
 protected:
  LogFiles() { std::filesystem::create_directories(folderOfTest()); }
  ~LogFiles() override {
    std::error_code ignored;
    std::filesystem::remove_all(folderOfTest(), ignored);
  }
};

inline std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline std::string fileWith(const std::string& name, const std::string& content) {
  const std::string path = pathOf(name);
  std::ofstream(path, std::ios::binary) << content;
  return path;
}

inline LogOptions chunksOf(std::size_t bytes, const std::string& compression = "zstd") {
  LogOptions options;
  options.chunks = true;
  options.compression = compression;
  options.chunkBytes = bytes;
  return options;
}

struct Reading {
  int messages = 0;
  bool truncated = false;
  std::uint64_t offset = 0;
  std::string error;
  std::vector<std::string> contents;  // topic, time and bytes of each message
  std::vector<LogGap> gaps;
};

inline std::string contentOf(const LogMessage& message) {
  return message.topic() + " " + std::to_string(message.time.us) + " " +
         std::string(message.data, message.data + message.size);
}

inline Reading readOn(LogReader& reader) {
  Reading reading;
  LogMessage message;
  while (reader.next(message)) reading.contents.push_back(contentOf(message));
  reading.messages = static_cast<int>(reading.contents.size());
  reading.truncated = reader.truncated();
  reading.offset = reader.offset();
  reading.error = reader.status().error();
  reading.gaps = reader.gaps();
  return reading;
}

inline Reading readAll(const std::string& path) {
  auto reader = LogReader::open(path);
  return reader ? readOn(*reader) : Reading{0, false, 0, reader.error(), {}, {}};
}

// A record of the file itself, not of a chunk.
struct FileRecord {
  mcap::Op op{};
  std::size_t offset = 0;
  std::size_t size = 0;  // with code and length
  std::string content;
};

inline std::vector<FileRecord> recordsOf(const std::string& log) {
  std::vector<FileRecord> records;
  std::size_t at = mcap::kMagic.size();
  while (at + mcap::kRecordHead + mcap::kMagic.size() <= log.size()) {
    std::uint64_t length = 0;
    std::memcpy(&length, log.data() + at + 1, sizeof length);
    const std::size_t size = mcap::kRecordHead + length;
    records.push_back(
        {static_cast<mcap::Op>(log[at]), at, size, log.substr(at + mcap::kRecordHead, length)});
    at += size;
  }
  return records;
}

inline mcap::ContentReader readerOf(const std::string& content) {
  return {reinterpret_cast<const std::uint8_t*>(content.data()), content.size()};
}

// The limit on file size stands for the full disk: it too lets a write end half way.
inline void withFilesUpTo(rlim_t bytes, const std::function<void()>& act) {
  struct rlimit old {};
  getrlimit(RLIMIT_FSIZE, &old);
  struct rlimit tight = old;
  tight.rlim_cur = bytes;
  const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &tight);
  act();
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, oldHandler);
}

}  // namespace kelpie
