// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "robot/core/Checksum.h"
#include "tests/core/LogFiles.h"
#include "tests/core/SampleLog.h"

namespace kelpie {
namespace {

class Log : public LogFiles {};

// Two topics, three messages, no chunks; the sizes of what was written after each record.
std::vector<std::size_t> writeSmallLog(const std::string& path) {
  LogWriter log = std::move(*LogWriter::open(path, LogOptions{}));
  std::vector<std::size_t> ends;
  for (int i = 0; i < 3; ++i) {
    WalkRequest walk;
    walk.forward = i;
    if (i == 1) {
      log.write("head", TimeUs{i * 1000}, HeadRequest{});
    } else {
      log.write("walk", TimeUs{i * 1000}, walk);
    }
    ends.push_back(log.bytes());
  }
  EXPECT_TRUE(log.close());
  return ends;
}

TEST_F(Log, GivesBackEveryMessageOfEveryType) {
  const std::string path = pathOf("log");
  ASSERT_TRUE(writeSampleLog(path, 3));
  auto reader = LogReader::open(path);
  ASSERT_TRUE(reader) << reader.error();
  Random random(1);
  LogMessage message;
  int inputs = 0;
  while (reader->next(message)) {
    const auto in = std::make_unique<FrameInput>();
    if (message.topic() != "input") continue;
    EXPECT_EQ(message.time.us, 33333 * inputs++);
    EXPECT_EQ(message.schema().name, "kelpie/FrameInput");
    const Status status = decodeAs(message, *in);
    ASSERT_TRUE(status) << status.error();
    EXPECT_TRUE(verify(*in, nullptr));
  }
  EXPECT_EQ(inputs, 3);
  EXPECT_FALSE(reader->truncated());
  EXPECT_EQ(reader->offset(), contentOf(path).size());
}

TEST_F(Log, KeepsTheValueBitForBit) {
  const std::string path = pathOf("log");
  ASSERT_TRUE(writeSampleLog(path, 1));
  Random random(1);
  const auto expected = std::make_unique<FrameInput>();
  randomise(*expected, random);
  auto reader = LogReader::open(path);
  LogMessage message;
  ASSERT_TRUE(reader->next(message));
  const auto read = std::make_unique<FrameInput>();
  ASSERT_TRUE(decodeAs(message, *read));
  std::string difference;
  EXPECT_FALSE(firstDifference(*expected, *read, &difference)) << difference;
}

TEST_F(Log, KeepsMetadataAndAttachments) {
  const std::string path = pathOf("log");
  ASSERT_TRUE(writeSampleLog(path, 0));
  auto reader = LogReader::open(path);
  LogMessage message;
  EXPECT_FALSE(reader->next(message));
  ASSERT_EQ(reader->metadata().size(), 1U);
  EXPECT_EQ(reader->metadata()[0].entries.at("robot"), "sample");
  ASSERT_EQ(reader->attachments().size(), 1U);
  EXPECT_EQ(reader->attachments()[0].data.size(), 4U);
}

TEST_F(Log, CutAtAnyByteGivesAllWholeMessages) {
  const std::string path = pathOf("log");
  const std::vector<std::size_t> ends = writeSmallLog(path);
  EXPECT_FALSE(readAll(path).truncated);
  for (std::size_t size = std::filesystem::file_size(path) - 1; size >= 8; --size) {
    std::filesystem::resize_file(path, size);
    const Reading reading = readAll(path);
    const auto expected = std::upper_bound(ends.begin(), ends.end(), size) - ends.begin();
    ASSERT_EQ(reading.error, "") << size;
    ASSERT_EQ(reading.messages, expected) << size;
    ASSERT_TRUE(reading.truncated) << size;
    ASSERT_LE(reading.offset, size);
  }
}

TEST_F(Log, ZerosAtTheEndAreACut) {
  const std::string path = pathOf("log");
  const std::vector<std::size_t> ends = writeSmallLog(path);
  const std::string cut = contentOf(path).substr(0, ends[1]) + std::string(4096, '\0');
  const Reading reading = readAll(fileWith("cut", cut));
  EXPECT_EQ(reading.messages, 2);
  EXPECT_TRUE(reading.truncated);
  EXPECT_EQ(reading.offset, ends[1]);
}

TEST_F(Log, AnyByteBrokenNeverCrashes) {
  const std::string path = pathOf("log");
  writeSmallLog(path);
  const std::string whole = contentOf(path);
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  Random random(3);
  for (std::size_t at = 0; at < whole.size(); ++at) {
    const auto place = static_cast<std::streamoff>(at);
    const int broken = whole[at] ^ static_cast<int>(1 + random.index(255));
    file.seekp(place).put(static_cast<char>(broken)).flush();
    EXPECT_LE(readAll(path).messages, 3);
    file.seekp(place).put(whole[at]).flush();
  }
  EXPECT_EQ(readAll(path).messages, 3);
}

TEST_F(Log, ForeignFileIsRefusedByName) {
  const std::string text = fileWith("foreign", "This is not a log, it is a text file.\n");
  EXPECT_EQ(readAll(text).error, text + ": byte 0: not an MCAP log");
  const std::string empty = fileWith("empty", "");
  EXPECT_EQ(readAll(empty).error, empty + ": byte 0: not an MCAP log");
  EXPECT_EQ(readAll("/nowhere/log").error, "/nowhere/log: No such file or directory");
}

TEST_F(Log, AnotherFieldListIsNamedWithTopicAndLine) {
  const std::string path = pathOf("log");
  writeSmallLog(path);
  auto reader = LogReader::open(path);
  LogMessage message;
  ASSERT_TRUE(reader->next(message));
  Odometry odometry;
  const Status status = decodeAs(message, odometry);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error(),
            "topic walk (kelpie/WalkRequest): recorded with another field list; schema line 1 is "
            "\"float64 forward  # cm/s, -45..60\", expected \"float64 forward  # cm, -100..100\"");
}

TEST_F(Log, FullDiskIsReportedOnceAndEndsTheWriting) {
  struct stat info {};
  if (stat("/dev/full", &info) != 0) GTEST_SKIP() << "no /dev/full here";
  auto log = LogWriter::open("/dev/full");
  EXPECT_FALSE(log);
  EXPECT_EQ(log.error(), "/dev/full: byte 0: cannot write the log: No space left on device");
  EXPECT_EQ(LogWriter::open("/nowhere/log").error(), "/nowhere/log: No such file or directory");
}

TEST_F(Log, RecordThatDoesNotFitIsTakenBack) {
  const std::string path = pathOf("log");
  LogWriter log = std::move(*LogWriter::open(path, LogOptions{}));
  withFilesUpTo(1000, [&] {
    for (int i = 0; i < 50; ++i) log.write("walk", TimeUs{i}, WalkRequest{});
    log.close();
  });
  const std::string place = path + ": byte " + std::to_string(log.bytes());
  EXPECT_EQ(log.status().error(), place + ": cannot write the log: File too large");
  EXPECT_EQ(std::filesystem::file_size(path), log.bytes());
  EXPECT_GT(readAll(path).messages, 0);
  EXPECT_EQ(readAll(path).offset, log.bytes());
}

TEST_F(Log, TopicKeepsItsType) {
  LogWriter log = std::move(*LogWriter::open(pathOf("log")));
  log.write("walk", TimeUs{0}, WalkRequest{});
  log.write("walk", TimeUs{1}, HeadRequest{});
  EXPECT_NE(log.close().error().find("topic walk holds kelpie/WalkRequest, not kelpie/HeadRequest"),
            std::string::npos);
  EXPECT_EQ(readAll(pathOf("log")).messages, 1);
}

TEST_F(Log, BytesThatTheCallerEncodedAreKeptWithTheirEncodings) {
  const ReadyType type{"other.Words", "protobuf", std::string("\x0a\x00schema", 8), "protobuf"};
  LogWriter log = std::move(*LogWriter::open(pathOf("log"), defaultLogOptions(), ""));
  log.write("one", TimeUs{1}, type, std::string("\x00\x01", 2));
  log.write("two", TimeUs{2}, type, "last");
  ASSERT_TRUE(log.close());
  auto reader = LogReader::open(pathOf("log"));
  LogMessage message;
  ASSERT_TRUE(reader->next(message));
  EXPECT_EQ(message.channel->messageEncoding, "protobuf");
  EXPECT_EQ(message.schema().name, "other.Words");
  EXPECT_EQ(message.schema().encoding, "protobuf");
  EXPECT_EQ(message.schema().text, type.schema);
  EXPECT_EQ(std::string(message.data, message.data + message.size), std::string("\x00\x01", 2));
  ASSERT_TRUE(reader->next(message));
  EXPECT_EQ(message.topic(), "two");
  EXPECT_EQ(message.channel->schemaId, 1);  // no second copy of the schema
}

TEST_F(Log, TopicKeepsOursOrTheCallersType) {
  const ReadyType type{"other.Words", "protobuf", "schema", "protobuf"};
  LogWriter ours = std::move(*LogWriter::open(pathOf("ours")));
  ours.write("walk", TimeUs{0}, WalkRequest{});
  ours.write("walk", TimeUs{1}, type, "words");
  EXPECT_NE(ours.close().error().find("topic walk holds kelpie/WalkRequest, not other.Words"),
            std::string::npos);
  LogWriter others = std::move(*LogWriter::open(pathOf("others")));
  others.write("walk", TimeUs{0}, type, "words");
  others.write("walk", TimeUs{1}, WalkRequest{});
  EXPECT_NE(others.close().error().find("topic walk holds other.Words, not kelpie/WalkRequest"),
            std::string::npos);
}

TEST_F(Log, ChecksumIsThatOfZip) {
  const std::string text = "123456789";  // check value of CRC-32/ISO-HDLC
  EXPECT_EQ(crc32(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()), 0xcbf43926U);
  const std::string pangram = "The quick brown fox jumps over the lazy dog";  // eight bytes a step
  EXPECT_EQ(crc32(reinterpret_cast<const std::uint8_t*>(pangram.data()), pangram.size()),
            0x414fa339U);
}

}  // namespace
}  // namespace kelpie
