// SPDX-License-Identifier: Apache-2.0
// Texts in frame structs: a ROS 1 string on the wire, bounded, and cut off at whole characters.
#include <gtest/gtest.h>

#include "robot/core/Random.h"
#include "robot/core/fields/Encoding.h"
#include "robot/core/fields/SchemaTranslation.h"
#include "robot/core/types/Command.h"

namespace kelpie {
namespace {

struct Note {
  std::uint8_t number = 7;
  Text<8> words;
  static constexpr const char* typeName() { return "Note"; }
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("number", &Note::number), field("words", &Note::words));
  }
};

struct OldNote {  // without words, or with bytes in their place
  std::uint8_t number = 0;
  static constexpr const char* typeName() { return "Note"; }
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("number", &OldNote::number));
  }
};

struct ByteNote {
  FixedVector<std::uint8_t, 8> words;
  static constexpr const char* typeName() { return "Note"; }
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("words", &ByteNote::words));
  }
};

struct LongNote {
  double number = 0.0;
  Text<40> words;
  Text<4> colour;
  static constexpr const char* typeName() { return "Note"; }
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("words", &LongNote::words), field("number", &LongNote::number),
                     field("colour", &LongNote::colour));
  }
};

template <class T>
std::vector<std::uint8_t> bytesOf(const T& value) {
  std::vector<std::uint8_t> bytes;
  encode(value, bytes);
  return bytes;
}

template <class Old>
SchemaTranslation toNote() {
  return *SchemaTranslation::make("kelpie/Note", schemaText<Old>(), schemaText<Note>());
}

template <class Old>
Note translated(const Old& old) {
  const auto bytes = bytesOf(old);
  std::vector<std::uint8_t> out;
  Note now;
  EXPECT_TRUE(toNote<Old>().translate(bytes.data(), bytes.size(), bytesOf(Note{}), out));
  EXPECT_TRUE(decode(out.data(), out.size(), now));
  return now;
}

TEST(Text, IsALengthAndItsBytesOnTheWire) {
  Note note;
  note.words.assign("aim");
  const auto bytes = bytesOf(note);
  EXPECT_EQ(bytes, (std::vector<std::uint8_t>{7, 3, 0, 0, 0, 'a', 'i', 'm'}));
  Note back;
  ASSERT_TRUE(decode(bytes.data(), bytes.size(), back));
  EXPECT_EQ(back.words.view(), "aim");
}

TEST(Text, IsAStringInTheSchema) {
  EXPECT_EQ(schemaText<Note>(), "uint8 number\nstring words\n");
  EXPECT_NE(schemaText<Command>().find("kelpie/TraceStep[] trace\n"), std::string::npos);
}

TEST(Text, IsCutOffBeforeTheCharacterThatDoesNotFitWhole) {
  EXPECT_EQ(Text<4>("abcdef").view(), "abcd");
  EXPECT_EQ(Text<4>("abc\u00e9").view(), "abc");  // two bytes, the second one over
  EXPECT_EQ(Text<5>("abc\u00e9").view(), "abc\u00e9");
  EXPECT_EQ(Text<5>("ab\U0001F415").view(), "ab");  // four bytes
  EXPECT_EQ(Text<1>("\u00e9").view(), "");
}

TEST(Text, OfTheSameWordsHasTheSameBytesWhateverItHeldBefore) {
  Text<8> text("longer");
  text.assign("a");
  const Text<8> fresh("a");
  EXPECT_EQ(std::memcmp(&text, &fresh, sizeof text), 0);
}

TEST(Text, LongerThanItsCapacityIsRefusedByDecode) {
  LongNote note;
  note.words.assign("nine char");
  const auto bytes = bytesOf(note);
  std::vector<std::uint8_t> out;
  Note now;
  ASSERT_TRUE(toNote<LongNote>().translate(bytes.data(), bytes.size(), bytesOf(Note{}), out));
  EXPECT_FALSE(decode(out.data(), out.size(), now));
}

TEST(Text, DifferenceShowsBothTexts) {
  TraceStep a, b;
  a.reason.assign("the ball is near");
  b.reason.assign("the ball is far");
  std::string path;
  EXPECT_TRUE(firstDifference(a, b, &path));
  EXPECT_EQ(path, "reason: \"the ball is near\" != \"the ball is far\"");
  b = a;
  EXPECT_FALSE(firstDifference(a, b, &path));
}

TEST(Text, OfAnotherFieldListIsReadByNameOrEmpty) {
  LongNote other;
  other.number = 3.0;
  other.words.assign("aim");
  other.colour.assign("red");
  const Note now = translated(other);
  EXPECT_EQ(now.words.view(), "aim");
  EXPECT_EQ(now.number, 3);
  EXPECT_EQ(toNote<LongNote>().leftOut(), (std::vector<std::string>{"colour"}));
  EXPECT_EQ(translated(OldNote{}).words.view(), "");
  EXPECT_EQ(toNote<OldNote>().defaulted(), (std::vector<std::string>{"words"}));
}

TEST(Text, IsNotReadFromAListOfBytes) {
  ByteNote bytes;
  bytes.words.push_back('x');
  EXPECT_EQ(translated(bytes).words.view(), "");
  EXPECT_EQ(toNote<ByteNote>().defaulted(), (std::vector<std::string>{"number", "words"}));
}

TEST(Text, ListsOfTextsInAForeignSchemaAreRefused) {
  EXPECT_FALSE(SchemaTypes::parse("kelpie/Note", "string[] words\n"));
  EXPECT_FALSE(SchemaTypes::parse("kelpie/Note", "string[3] words\n"));
  EXPECT_TRUE(SchemaTypes::parse("kelpie/Note", "string words\n"));
}

TEST(Text, CutOffBytesAndRandomOnesAreReadOrRefused) {
  LongNote note;
  note.words.assign("aim");
  auto bytes = bytesOf(note);
  const auto translation = toNote<LongNote>();
  std::vector<std::uint8_t> out;
  for (std::size_t n = 0; n < bytes.size(); ++n)
    EXPECT_FALSE(translation.translate(bytes.data(), n, bytesOf(Note{}), out)) << n;
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.index(256));
    static_cast<void>(translation.translate(bytes.data(), bytes.size(), bytesOf(Note{}), out));
  }
}

TEST(Trace, ACommandWithItsTraceSurvivesTheRoundTrip) {
  Command command;
  command.trace.resize(Trace::kCapacity);
  for (auto& step : command.trace) {
    step.layer = TraceLayer::skill;
    step.module.assign("grab_dribble");
    step.branch.assign("aim");
    step.reason.assign("the gap is {} deg to the left");
    step.numbers.push_back(12.5);
  }
  const auto bytes = bytesOf(command);
  Command back;
  ASSERT_TRUE(decode(bytes.data(), bytes.size(), back));
  std::string path;
  EXPECT_FALSE(firstDifference(command, back, &path)) << path;
  EXPECT_TRUE(verify(back, &path)) << path;
}

TEST(Trace, OfACommandRecordedBeforeThereWereTracesIsEmpty) {
  const std::string now = schemaText<Command>();
  std::string before = now;
  const std::string line = "kelpie/TraceStep[] trace\n";
  before.erase(before.find(line), line.size());
  const auto translation = SchemaTranslation::make("kelpie/Command", before, now);
  ASSERT_TRUE(translation) << translation.error();
  EXPECT_EQ(translation->defaulted(), (std::vector<std::string>{"trace"}));
}

}  // namespace
}  // namespace kelpie
