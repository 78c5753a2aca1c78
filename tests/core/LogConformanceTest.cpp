// SPDX-License-Identifier: Apache-2.0
// Every kind of file that MCAP's public conformance tests name (mcap.dev, tests/conformance: their
// list of inputs and features, in all combinations that make sense), written here record by record
// from the specification, not by our LogWriter.
#include <gtest/gtest.h>

#include <array>

#include "robot/core/Checksum.h"
#include "tests/core/LogFiles.h"

namespace kelpie {
namespace {

using mcap::Op;
using mcap::RecordWriter;
using Bytes = std::vector<std::uint8_t>;

struct Features {
  bool chunks, messageIndex, statistics, repeatedSchemas, repeatedChannels, attachmentIndex,
      metadataIndex, chunkIndex, summaryOffsets, padding;
};
constexpr int kFeatures = 10;
constexpr std::array<std::uint8_t, 3> kBytes = {1, 2, 3};  // of every content

Features featuresOf(unsigned bits) {
  const auto bit = [bits](int n) { return ((bits >> n) & 1U) != 0; };
  return {bit(0), bit(1), bit(2), bit(3), bit(4), bit(5), bit(6), bit(7), bit(8), bit(9)};
}

struct Input {
  const char* name;
  int messages;
  bool schema, attachment, metadata;
};
constexpr std::array<Input, 6> kInputs = {{{"NoData", 0, false, false, false},
                                           {"OneAttachment", 0, false, true, false},
                                           {"OneMetadata", 0, false, false, true},
                                           {"OneMessage", 1, true, false, false},
                                           {"OneSchemalessMessage", 1, false, false, false},
                                           {"TenMessages", 10, true, false, false}}};

bool makesSense(const Input& input, const Features& use) {
  if (input.messages == 0 && (use.chunks || use.repeatedSchemas || use.repeatedChannels))
    return false;
  if (!use.chunks && (use.messageIndex || use.chunkIndex)) return false;
  if (!input.schema && use.repeatedSchemas) return false;
  return (input.attachment || !use.attachmentIndex) && (input.metadata || !use.metadataIndex);
}

class File {
 public:
  File(const Input& input, const Features& use) : input_(input), use_(use) {}

  Bytes bytes() {
    RecordWriter magic(out_);
    magic.bytes(mcap::kMagic.data(), mcap::kMagic.size());
    record(out_, Op::header, [](RecordWriter& to) {
      to.string("");
      to.string("");
    });
    data();
    record(out_, Op::dataEnd, [](RecordWriter& to) { to.number(std::uint32_t{0}); });
    summary();
    magic.bytes(mcap::kMagic.data(), mcap::kMagic.size());
    return out_;
  }

 private:
  template <class Fill>
  void record(Bytes& to, Op op, Fill&& fill) const {
    RecordWriter writer(to);
    writer.begin(op);
    fill(writer);
    if (use_.padding && op != Op::footer)
      for (const std::uint8_t extra : kBytes) writer.number(extra);
    writer.end();
  }
  void schema(Bytes& to) const {
    if (!input_.schema) return;
    record(to, Op::schema, [](RecordWriter& writer) {
      writer.number(std::uint16_t{1});
      for (const char* text : {"Example", "c", "d"}) writer.string(text);
    });
  }
  void channel(Bytes& to) const {
    record(to, Op::channel, [&](RecordWriter& writer) {
      writer.number(std::uint16_t{1});
      writer.number(static_cast<std::uint16_t>(input_.schema ? 1 : 0));
      writer.string("example");
      writer.string("a");
      writer.map({{"foo", "bar"}});
    });
  }
  void messages(Bytes& to) {
    for (int i = 0; i < input_.messages; ++i) {
      places_.push_back(to.size());
      record(to, Op::message, [&](RecordWriter& writer) {
        writer.number(std::uint16_t{1});
        writer.number(static_cast<std::uint32_t>(10 + i));
        writer.number(static_cast<std::uint64_t>(1000 * (2 + i)));
        writer.number(std::uint64_t{1});
        for (const std::uint8_t byte : kBytes) writer.number(byte);
      });
    }
  }
  void data() {
    if (input_.attachment) attachment();
    if (input_.metadata)
      record(out_, Op::metadata, [](RecordWriter& writer) {
        writer.string("myMetadata");
        writer.map({{"foo", "bar"}});
      });
    if (input_.messages == 0) return;
    Bytes inner;
    Bytes& to = use_.chunks ? inner : out_;
    schema(to);
    channel(to);
    messages(to);
    if (use_.chunks) chunk(inner);
  }
  void chunk(const Bytes& inner) {
    chunkAt_ = out_.size();
    record(out_, Op::chunk, [&](RecordWriter& writer) {
      for (const std::uint64_t value :
           {std::uint64_t{2000},
            std::uint64_t{1000U * (1U + static_cast<unsigned>(input_.messages))},
            static_cast<std::uint64_t>(inner.size())})
        writer.number(value);
      writer.number(crc32(inner.data(), inner.size()));
      writer.string("");
      writer.number(static_cast<std::uint64_t>(inner.size()));
      writer.bytes(inner.data(), inner.size());
    });
    chunkSize_ = out_.size() - chunkAt_;
    if (!use_.messageIndex) return;
    record(out_, Op::messageIndex, [&](RecordWriter& writer) {
      writer.number(std::uint16_t{1});
      writer.number(static_cast<std::uint32_t>(16 * places_.size()));
      for (std::size_t i = 0; i < places_.size(); ++i) {
        writer.number(static_cast<std::uint64_t>(1000 * (2 + i)));
        writer.number(static_cast<std::uint64_t>(places_[i]));
      }
    });
  }
  void attachment() {
    Bytes content;
    RecordWriter writer(content);
    for (const std::uint64_t time : {2U, 1U}) writer.number(time);
    writer.string("myFile");
    writer.string("application/octet-stream");
    writer.number(std::uint64_t{3});
    for (const std::uint8_t byte : kBytes) writer.number(byte);
    record(out_, Op::attachment, [&](RecordWriter& to) {
      to.bytes(content.data(), content.size());
      to.number(crc32(content.data(), content.size()));
    });
  }
  void statistics(Bytes& to) const {
    record(to, Op::statistics, [&](RecordWriter& writer) {
      writer.number(static_cast<std::uint64_t>(input_.messages));
      writer.number(static_cast<std::uint16_t>(input_.schema ? 1 : 0));
      for (const std::uint32_t value : {input_.messages > 0 ? 1U : 0U, input_.attachment ? 1U : 0U,
                                        input_.metadata ? 1U : 0U, use_.chunks ? 1U : 0U})
        writer.number(value);
      for (const std::uint64_t time : {0U, 0U}) writer.number(time);
      writer.number(std::uint32_t{0});
    });
  }
  void indexes(Bytes& to) const {
    if (use_.chunkIndex)
      record(to, Op::chunkIndex, [&](RecordWriter& writer) {
        for (const std::uint64_t value : {std::uint64_t{2000}, std::uint64_t{2000},
                                          std::uint64_t{chunkAt_}, std::uint64_t{chunkSize_}})
          writer.number(value);
        writer.number(std::uint32_t{0});
        writer.number(std::uint64_t{0});
        writer.string("");
        for (const std::uint64_t value : {0U, 0U}) writer.number(value);
      });
    if (use_.attachmentIndex)
      record(to, Op::attachmentIndex, [](RecordWriter& writer) {
        for (const std::uint64_t value : {25U, 60U, 2U, 1U, 3U}) writer.number(value);
        writer.string("myFile");
        writer.string("application/octet-stream");
      });
    if (use_.metadataIndex)
      record(to, Op::metadataIndex, [](RecordWriter& writer) {
        for (const std::uint64_t value : {25U, 41U}) writer.number(value);
        writer.string("myMetadata");
      });
  }
  void summary() {
    const std::uint64_t start = out_.size();
    Bytes records;
    if (use_.repeatedSchemas) schema(records);
    if (use_.repeatedChannels) channel(records);
    if (use_.statistics) statistics(records);
    indexes(records);
    out_.insert(out_.end(), records.begin(), records.end());
    const std::uint64_t offsets = out_.size();
    if (use_.summaryOffsets && !records.empty())
      record(out_, Op::summaryOffset, [&](RecordWriter& writer) {
        writer.number(records.front());
        writer.number(start);
        writer.number(static_cast<std::uint64_t>(records.size()));
      });
    const bool has = !records.empty();
    record(out_, Op::footer, [&](RecordWriter& writer) {
      writer.number(has ? start : std::uint64_t{0});
      writer.number(has && use_.summaryOffsets ? offsets : std::uint64_t{0});
      writer.number(std::uint32_t{0});
    });
  }

  const Input& input_;
  const Features& use_;
  Bytes out_;
  std::vector<std::size_t> places_;  // of messages, in their chunk
  std::size_t chunkAt_ = 0;
  std::size_t chunkSize_ = 0;
};

class LogConformance : public LogFiles {};

void expectDescribed(const Input& input, const std::string& path) {
  auto reader = LogReader::open(path);
  ASSERT_TRUE(reader);
  const Reading reading = readOn(*reader);
  ASSERT_EQ(reading.error, "");
  ASSERT_EQ(reader->lacks(), "");
  ASSERT_EQ(reading.messages, input.messages);
  ASSERT_EQ(reader->attachments().size(), input.attachment ? 1U : 0U);
  ASSERT_EQ(reader->metadata().size(), input.metadata ? 1U : 0U);
  ASSERT_TRUE(reader->notes().empty());
  for (int i = 0; i < input.messages; ++i)
    ASSERT_EQ(reading.contents[static_cast<std::size_t>(i)],
              "example " + std::to_string(2 + i) + " \x01\x02\x03" +
                  (reading.contents[0].size() > 13 ? "\x01\x02\x03" : ""));
}

TEST_F(LogConformance, EveryValidFileIsDescribedWhole) {
  int files = 0;
  for (const Input& input : kInputs)
    for (unsigned bits = 0; bits < (1U << kFeatures); ++bits) {
      const Features use = featuresOf(bits);
      if (!makesSense(input, use)) continue;
      SCOPED_TRACE(std::string(input.name) + " " + std::to_string(bits));
      const Bytes bytes = File(input, use).bytes();
      expectDescribed(input, fileWith("file", {bytes.begin(), bytes.end()}));
      if (HasFatalFailure()) return;
      ++files;
    }
  EXPECT_GE(files, 416);
}

}  // namespace
}  // namespace kelpie
