// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

#include "robot/agent/log/FrameMessages.h"
#include "robot/core/log/LogReader.h"
#include "tools/cli/Commands.h"

namespace kelpie::cli {
namespace {

struct TopicCount {
  std::string schema;
  std::size_t messages = 0;
  std::size_t bytes = 0;
  TimeUs first;
  TimeUs last;
};

void printTopics(const std::map<std::string, TopicCount>& topics) {
  fmt::print("{:18} {:28} {:>9} {:>10} {:>9} {:>9}\n", "topic", "type", "messages", "KB", "from s",
             "to s");
  for (const auto& [topic, count] : topics)
    fmt::print("{:18} {:28} {:>9} {:>10.1f} {:>9.3f} {:>9.3f}\n", topic, count.schema,
               count.messages, static_cast<double>(count.bytes) / 1024.0, count.first.seconds(),
               count.last.seconds());
}

void printStorage(const LogChunkCounts& counts) {
  if (counts.chunks == 0) {
    fmt::print("without chunks\n");
    return;
  }
  const double held = static_cast<double>(counts.held);
  const double stored = static_cast<double>(counts.stored);
  fmt::print("{} chunks, {}: {:.1f} KB in {:.1f} KB, {:.0f} %\n", counts.chunks,
             counts.compression.empty() ? "not compressed" : counts.compression, held / 1024.0,
             stored / 1024.0, held > 0.0 ? 100.0 * stored / held : 100.0);
}

// The newest frame of the log, copied: a message lives only until the next is read.
struct NewestFrame {
  LogMessage message;
  std::vector<std::uint8_t> bytes;

  void take(const LogMessage& frame) {
    bytes.assign(frame.data, frame.data + frame.size);
    message = frame;
  }
};

// How many images the agent got, and how many the camera took in that time that it did not get.
void printFrames(NewestFrame& newest) {
  if (newest.bytes.empty()) return;
  newest.message.data = newest.bytes.data();
  const auto input = std::make_unique<FrameInput>();
  if (!agent::decodeFrameInput(newest.message, *input)) return;
  fmt::print("{} camera frames, {} more dropped before the agent got them\n", input->frame + 1,
             input->droppedFrames);
}

int info(const std::string& log) {
  auto reader = LogReader::open(log);
  if (!reader) return fail(reader.error(), kExitBadInput);
  std::map<std::string, TopicCount> topics;
  LogMessage message;
  NewestFrame newest;
  while (reader->next(message)) {
    if (agent::isFrameInput(message.topic())) newest.take(message);
    auto& count = topics[message.topic()];
    if (count.messages++ == 0) count.first = count.last = message.time;
    count.schema = message.channel->schemaId == 0 ? "(no schema)" : message.schema().name;
    count.first = std::min(count.first, message.time);
    count.last = std::max(count.last, message.time);
    count.bytes += message.size;
  }
  if (!reader->status()) return fail(reader->status().error(), kExitBadInput);
  printTopics(topics);
  printFrames(newest);
  printStorage(reader->chunkCounts());
  for (const auto& note : reader->notes()) fmt::print("{}\n", note);
  for (const auto& metadata : reader->metadata())
    for (const auto& [key, value] : metadata.entries)
      fmt::print("{}.{} = {}\n", metadata.name, key, value);
  for (const auto& gap : reader->gaps()) fmt::print("damaged: {}\n", gap.text());
  const std::string lacks = reader->lacks();
  return lacks.empty() ? kExitDone : fail(log + ": " + lacks, kExitBadInput);
}

}  // namespace

void addInfo(CommandLine& app, int& code) {
  auto command = app.subcommand("info", "What is in a log: topics, types, counts, times");
  auto log = std::make_shared<std::string>();
  command.option("LOG", *log, "The log").required();
  command.callback([log, &code] { code = info(*log); });
}

}  // namespace kelpie::cli
