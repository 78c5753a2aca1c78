// SPDX-License-Identifier: Apache-2.0
// A log of any bytes. What is read are messages that lie in the file, gaps in the order of the file
// and a cut; and what `kelpie recover` writes of it is read again whole.
#include "robot/core/log/LogReader.h"
#include "tests/fuzz/Input.h"
#include "tools/cli/log/Logs.h"

namespace {

using namespace kelpie;
using fuzz::require;

// Touches every byte that is given, so that one that is not there is found.
std::size_t readOn(LogReader& reader, std::size_t size) {
  LogMessage message;
  std::size_t messages = 0;
  unsigned sum = 0;
  for (; reader.next(message); ++messages) {
    require(message.channel != nullptr && message.channel->schema != nullptr,
            "a message is of one");
    require(message.offset < size, "a message lies in the file");
    for (std::size_t i = 0; i < message.size; ++i) sum += message.data[i];
  }
  require(!reader.next(message), "what has ended has ended");
  volatile unsigned kept = sum;
  static_cast<void>(kept);
  return messages;
}

void checkGaps(const LogReader& reader, std::size_t size) {
  std::uint64_t end = 0;
  for (const LogGap& gap : reader.gaps()) {
    require(gap.from >= end && gap.from < gap.to && gap.to <= size, "gaps follow: " + gap.text());
    end = gap.to;
  }
  require(reader.offset() <= size, "the last whole record ends in the file");
}

void checkRecovered(const std::string& log) {
  const std::string out = fuzz::placeOf("-recovered.mcap");
  const auto joined = cli::mergeLogs({log}, out);
  if (!joined) return;
  auto reader = LogReader::open(out);
  require(bool(reader), "what was recovered is a log");
  LogMessage message;
  std::size_t messages = 0;
  while (reader->next(message)) ++messages;
  require(bool(reader->status()) && reader->lacks().empty(), "it is whole: " + reader->lacks());
  require(messages == joined->messages, "it has the messages that were told");
  std::remove(out.c_str());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::File file(fuzz::Bytes(data, data + size));
  auto reader = LogReader::open(file.name());
  if (!reader) {
    fuzz::requireLine(reader.error(), file.name());
    return 0;
  }
  const std::size_t messages = readOn(*reader, size);
  checkGaps(*reader, size);
  static_cast<void>(reader->lacks());
  static_cast<void>(reader->notes());
  reader->seek(TimeUs{1000000});
  readOn(*reader, size);
  if (messages > 0) checkRecovered(file.name());
  return 0;
}
