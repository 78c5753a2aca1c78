// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <pthread.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "robot/body/Lights.h"
#include "robot/core/Random.h"
#include "robot/core/fields/FieldCheck.h"
#include "robot/stick/FieldListHash.h"
#include "robot/stick/StickReader.h"
#include "tests/AllocationCount.h"
#include "tests/core/RandomValue.h"
#include "tests/stick/Sticks.h"
#include "tools/stick/StickWriter.h"

namespace kelpie::stick {
namespace {

TreeFile& fileOf(StickTree& tree, const std::string& path) {
  for (auto& file : tree)
    if (file.path == path) return file;
  ADD_FAILURE() << path;
  return tree.front();
}

StickVerdict loaded(const StickTree& tree, agent::AgentConfig& config) {
  TreeFiles files(tree);
  return std::make_unique<StickReader>(files)->load(config);
}

StickVerdict verdictOf(const StickTree& tree) {
  return loaded(tree, *std::make_unique<agent::AgentConfig>());
}

TEST(StickReader, GivesTheConfigurationBackBitForBit) {
  const auto written = sampleConfig();
  agent::AgentConfig& read = *std::make_unique<agent::AgentConfig>().release();
  const std::unique_ptr<agent::AgentConfig> owner(&read);
  EXPECT_TRUE(loaded(sampleTree(), read).good());
  std::string where;
  EXPECT_FALSE(firstDifference(read, *written, &where)) << where;
  EXPECT_DOUBLE_EQ(read.gps.field.length, written->field.length);
}

// Values that no configuration file would have, in every field at once.
TEST(StickReader, GivesAnyConfigurationInRangeBack) {
  Random random(5);
  for (int i = 0; i < 20; ++i) {
    const auto written = std::make_unique<agent::AgentConfig>();
    randomise(*written, random);
    const StickTree tree = {{kStickPath, stickBinary(*written, {})}};
    const auto read = std::make_unique<agent::AgentConfig>();
    const StickVerdict verdict = loaded(tree, *read);
    ASSERT_TRUE(verdict.good()) << lineOf(verdict).view();
    std::string where;
    ASSERT_FALSE(firstDifference(*read, *written, &where)) << where;
  }
}

TEST(StickReader, TakesItsRoomOnceFromTheHeap) {
  const StickTree tree = sampleTree();
  TreeFiles files(tree);
  const auto reader = std::make_unique<StickReader>(files);
  const auto config = std::make_unique<agent::AgentConfig>();
  // Path comparisons of the test's own files make strings; a path longer than 15 bytes is one.
  startCountingAllocations();
  for (const auto& file : tree) files.open(file.path.c_str());
  const int ofTheFiles = stopCountingAllocations();
  startCountingAllocations();
  const StickVerdict verdict = reader->load(*config);
  const int ofLoading = stopCountingAllocations();
  EXPECT_TRUE(verdict.good());
  EXPECT_EQ(ofLoading, ofTheFiles + 1) << "the files alone: " << ofTheFiles;
}

// Counts by itself what is asked of the files.
class CountedFiles : public TreeFiles {
 public:
  using TreeFiles::TreeFiles;
  bool open(const char* path) override { return ++opened[path], TreeFiles::open(path); }
  std::int32_t read(std::uint8_t* to, std::size_t count) override {
    const std::int32_t got = TreeFiles::read(to, count);
    ++reads;
    bytes += static_cast<std::size_t>(got);
    min = std::min(min, count);
    return got;
  }
  std::map<std::string, int> opened;
  std::size_t reads = 0;
  std::size_t bytes = 0;
  std::size_t min = kBlockBytes;
};

TEST(StickReader, ReadsEachFileOnceInLargeBlocks) {
  StickContents contents = sampleContents();
  contents.object.resize(1834281);  // as many bytes as an AGENT.BIN with Python may have
  const auto tree = makeTree(*sampleConfig(), contents);
  ASSERT_TRUE(tree) << tree.error();
  CountedFiles files(*tree);
  const auto reader = std::make_unique<StickReader>(files);
  EXPECT_TRUE(reader->load(*std::make_unique<agent::AgentConfig>()).good());
  std::size_t blocks = 0;
  for (const auto& file : *tree) {
    EXPECT_EQ(files.opened[file.path], 1) << file.path;
    blocks += file.bytes.size() / kBlockBytes + 1;  // the last is not full, which tells the end
  }
  EXPECT_EQ(files.opened.size(), tree->size());
  EXPECT_EQ(files.min, kBlockBytes);
  EXPECT_EQ(files.reads, blocks);
  EXPECT_LE(files.reads, 45U) << "of 2 MB";
  EXPECT_EQ(files.bytes, bytesOf(*tree));
  EXPECT_EQ(reader->progress().reads, files.reads);
  EXPECT_EQ(reader->progress().bytes, files.bytes);
  EXPECT_EQ(reader->progress().whole, files.bytes);
}

TEST(StickReader, StepByStepReadsOneBlockAndLoadsTheSame) {
  const StickTree tree = sampleTree();
  CountedFiles files(tree);
  const auto reader = std::make_unique<StickReader>(files);
  reader->begin();
  EXPECT_EQ(reader->progress().whole, 0U);
  std::size_t before = 0;
  for (bool more = true; more; before = files.reads) {
    more = reader->step();
    EXPECT_EQ(files.reads, before + 1);
  }
  EXPECT_FALSE(reader->step());
  const auto config = std::make_unique<agent::AgentConfig>();
  EXPECT_TRUE(reader->load(*config).good());
  EXPECT_EQ(files.reads, before) << "load() has read again";
  std::string where;
  EXPECT_FALSE(firstDifference(*config, *sampleConfig(), &where)) << where;
}

// A reader that was used reads again, and tells of what has changed meanwhile.
TEST(StickReader, ReadsAnewEachTimeItIsAsked) {
  StickTree tree = sampleTree();
  TreeFiles files(tree);
  const auto reader = std::make_unique<StickReader>(files);
  EXPECT_TRUE(reader->check().good());
  fileOf(tree, kScriptsPath).bytes[3] ^= 1;
  EXPECT_EQ(reader->check().fault, StickFault::otherContent);
  fileOf(tree, kScriptsPath).bytes[3] ^= 1;
  EXPECT_TRUE(reader->check().good());
}

struct Loading {
  StickReader& reader;
  agent::AgentConfig& config;
  StickVerdict verdict;
};

void* loadOnThread(void* loading) {
  auto& job = *static_cast<Loading*>(loading);
  job.verdict = job.reader.load(job.config);
  return nullptr;
}

// Bytes of a stack of our own that the loading has written to, the thread's own start with them.
std::ptrdiff_t stackOf(Loading& loading) {
  constexpr std::uint8_t kPaint = 0xA5;
  std::vector<std::uint8_t> stack(256 * 1024, kPaint);
  pthread_attr_t attributes;
  pthread_t thread{};
  pthread_attr_init(&attributes);
  pthread_attr_setstack(&attributes, stack.data(), stack.size());
  EXPECT_EQ(pthread_create(&thread, &attributes, loadOnThread, &loading), 0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
  return stack.end() -
         std::find_if(stack.begin(), stack.end(), [](std::uint8_t byte) { return byte != kPaint; });
}

// Through streams it takes 474528 bytes (openr-measured.md section 3); the sanitizers' frames are
// larger than others.
TEST(StickReader, LoadsWithLittleStack) {
  const StickTree tree = sampleTree();
  TreeFiles files(tree);
  const auto reader = std::make_unique<StickReader>(files);
  const auto config = std::make_unique<agent::AgentConfig>();
  Loading loading{*reader, *config, {}};
  const std::ptrdiff_t used = stackOf(loading);
  EXPECT_TRUE(loading.verdict.good());
  EXPECT_LT(used, 32 * 1024);
  RecordProperty("stack_bytes", static_cast<int>(used));
}

TEST(StickReader, RefusesEveryFlippedBitWithANamedReasonAndRedLights) {
  const StickTree tree = sampleTree();
  Random random(20060901);
  std::set<StickFault> reasons;
  const auto before = sampleConfig();
  const auto config = std::make_unique<agent::AgentConfig>(*before);
  for (int i = 0; i < 1000; ++i) {
    StickTree damaged = tree;
    std::string& bytes = damaged[static_cast<std::size_t>(i) % damaged.size()].bytes;
    const auto bit = random.index(static_cast<std::uint32_t>(bytes.size() * 8));
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
    const StickVerdict verdict = loaded(damaged, *config);
    ASSERT_FALSE(verdict.good()) << "flip " << i << " of bit " << bit;
    EXPECT_EQ(verdict.file.view(), damaged[static_cast<std::size_t>(i) % damaged.size()].path);
    const auto number = static_cast<std::uint32_t>(verdict.fault);
    EXPECT_NE(body::faultLights(number, {0}) & body::kLightRed, 0U);
    reasons.insert(verdict.fault);
  }
  EXPECT_GE(reasons.size(), 2U);
  std::string where;
  EXPECT_FALSE(firstDifference(*config, *before, &where)) << "was changed: " << where;
}

TEST(StickReader, RefusesEveryFlippedBitOfTheHeader) {
  const StickTree tree = sampleTree();
  std::set<StickFault> reasons;
  for (std::size_t bit = 0; bit < std::size_t{kHeaderBytes} * 8; ++bit) {
    StickTree damaged = tree;
    std::string& bytes = fileOf(damaged, kStickPath).bytes;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
    const StickVerdict verdict = verdictOf(damaged);
    ASSERT_FALSE(verdict.good()) << "bit " << bit;
    reasons.insert(verdict.fault);
  }
  const std::set<StickFault> expected = {StickFault::wrongMagic, StickFault::otherVersion,
                                         StickFault::otherFieldLists, StickFault::damagedHeader,
                                         StickFault::damagedPart};
  EXPECT_EQ(reasons, expected);
}

TEST(StickReader, RefusesEveryFlippedBitOfTheHash) {
  const std::string whole = stickBinary(*sampleConfig(), {});
  for (std::size_t bit = 0; bit < std::size_t{kHashBytes} * 8; ++bit) {
    StickTree damaged = {{kStickPath, whole}};
    std::string& bytes = damaged.front().bytes;
    char& byte = bytes[bytes.size() - kHashBytes + bit / 8];
    byte = static_cast<char>(byte ^ (1 << bit % 8));
    EXPECT_EQ(verdictOf(damaged).fault, StickFault::damagedWhole) << "bit " << bit;
  }
}

TEST(StickReader, NamesAFileThatIsMissingShortOrLong) {
  for (const auto* path : {kObjectListPath, kScriptsPath, kObjectPath, kStickPath}) {
    StickTree tree = sampleTree();
    std::string& bytes = fileOf(tree, path).bytes;
    bytes.push_back('x');
    EXPECT_EQ(verdictOf(tree).fault, StickFault::tooLong) << path;
    bytes.resize(bytes.size() - 2);
    EXPECT_EQ(verdictOf(tree).fault, StickFault::cutShort) << path;
    fileOf(tree, path).path = "GONE";
    const StickVerdict gone = verdictOf(tree);
    EXPECT_EQ(gone.fault, StickFault::missing);
    EXPECT_EQ(gone.file.view(), path);
  }
}

// As if the medium was read well, but written by a program with a fault of its own.
TEST(StickReader, RefusesANumberBeyondItsRange) {
  const auto config = sampleConfig();
  config->field.length = 5000.0;
  const StickTree tree = {{kStickPath, stickBinary(*config, {})}};
  EXPECT_EQ(verdictOf(tree).fault, StickFault::outOfRange);
}

TEST(StickReader, RefusesAnEnumThatIsNone) {
  const auto config = sampleConfig();
  config->team = static_cast<TeamColour>(7);
  const StickTree tree = {{kStickPath, stickBinary(*config, {})}};
  EXPECT_EQ(verdictOf(tree).fault, StickFault::undecodable);
}

TEST(StickReader, RefusesABinaryThatDoesNotFitItsRoom) {
  StickTree tree = {{kStickPath, stickBinary(*sampleConfig(), {})}};
  for (const std::size_t bytes : {kLargestBinary - 1, kLargestBinary, kLargestBinary + 1}) {
    tree.front().bytes.resize(bytes);
    EXPECT_EQ(verdictOf(tree).fault, StickFault::tooLong) << bytes;
  }
}

// Files whose length is a whole number of blocks end with a block of no bytes.
TEST(StickReader, TakesFilesOfWholeBlocks) {
  for (const std::size_t bytes : {kBlockBytes - 1, kBlockBytes, 2 * kBlockBytes}) {
    StickContents contents = sampleContents();
    contents.object.resize(bytes);
    auto tree = makeTree(*sampleConfig(), contents);
    ASSERT_TRUE(tree) << tree.error();
    fileOf(*tree, kObjectPath).bytes.push_back('x');
    EXPECT_EQ(verdictOf(*tree).fault, StickFault::tooLong) << bytes;
  }
}

class BrokenFiles : public TreeFiles {
 public:
  using TreeFiles::TreeFiles;
  std::int32_t read(std::uint8_t* /*to*/, std::size_t /*count*/) override { return -1; }
};

TEST(StickReader, NamesAMediumThatCannotBeRead) {
  const StickTree tree = sampleTree();
  BrokenFiles files(tree);
  EXPECT_EQ(std::make_unique<StickReader>(files)->check().fault, StickFault::unreadable);
}

TEST(StickFault, EveryReasonHasItsOwnLineAndLights) {
  std::set<std::string_view> texts;
  std::set<std::uint32_t> lights;
  for (std::uint8_t i = 1; i <= kStickFaultCount; ++i) {
    texts.insert(textOf(static_cast<StickFault>(i)));
    lights.insert(body::faultLights(i, {0}));
  }
  EXPECT_EQ(texts.size(), kStickFaultCount);
  EXPECT_EQ(lights.size(), kStickFaultCount);
  StickVerdict verdict{StickFault::damagedPart, StickPath(std::string_view(kStickPath))};
  EXPECT_EQ(lineOf(verdict).view(),
            "OPEN-R/MW/DATA/P/STICK.BIN: the CRC-32 of a part is wrong (fault 7)");
}

struct Small {
  double number = 0.0;
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("number", &Small::number, "cm", 0, 1));
  }
};
struct OtherUnit {
  double number = 0.0;
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("number", &OtherUnit::number, "mm", 0, 1));
  }
};
struct OtherRange {
  double number = 0.0;
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("number", &OtherRange::number, "cm", 0, 2));
  }
};
struct OtherName {
  double other = 0.0;
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("other", &OtherName::other, "cm", 0, 1));
  }
};
struct OtherType {
  float number = 0.0F;
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("number", &OtherType::number, "cm", 0, 1));
  }
};

TEST(FieldListHash, ChangesWithNameUnitRangeAndType) {
  const std::set<std::uint64_t> hashes = {fieldListHash<Small>(), fieldListHash<OtherUnit>(),
                                          fieldListHash<OtherRange>(), fieldListHash<OtherName>(),
                                          fieldListHash<OtherType>()};
  EXPECT_EQ(hashes.size(), 5U);
}

// Of "123456789", as every description of the two gives them.
TEST(Checksum, GivesThePublishedValues) {
  const auto* text = reinterpret_cast<const std::uint8_t*>("123456789");
  Crc32 crc;
  crc.add(text, 9);
  EXPECT_EQ(crc.value(), 0xCBF43926U);
  Fnv1a hash;
  hash.add(text, 9);
  EXPECT_EQ(hash.value(), 0x06d5573923c6cdfcULL);
}

}  // namespace
}  // namespace kelpie::stick
