// SPDX-License-Identifier: Apache-2.0
// Messages of older field lists: read by name, with defaults for what they lack.
#include <gtest/gtest.h>

#include "robot/core/Random.h"
#include "robot/core/fields/SchemaTranslation.h"
#include "tests/core/LogFiles.h"

namespace kelpie {
namespace {

enum class Side : std::uint8_t { left = 1, right = 2 };

struct Part {
  float weight = 1.5F;
  Side side = Side::left;
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("weight", &Part::weight, "g"), field("side", &Part::side, "", 1, 2));
  }
};

struct Whole {
  std::int32_t count = 7;
  bool present = true;
  Angle heading = Angle::deg(30);
  std::array<double, 3> sides{1.0, 2.0, 3.0};
  FixedVector<Part, 4> parts;
  Part best;
  static constexpr const char* typeName() { return "Whole"; }
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("count", &Whole::count), field("present", &Whole::present),
                     field("heading", &Whole::heading, "rad"), field("sides", &Whole::sides),
                     field("parts", &Whole::parts), field("best", &Whole::best));
  }
};

// An earlier list: another order, smaller numbers, a shorter array, parts without a side, no count.
struct OldPart {
  double weight = 0.0;
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("weight", &OldPart::weight, "g"));
  }
};

struct OldWhole {
  std::array<float, 2> sides{};
  FixedVector<OldPart, 8> parts;
  OldPart best;
  double colour = 0.0;
  Angle heading;
  static constexpr const char* typeName() { return "Whole"; }
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("sides", &OldWhole::sides), field("parts", &OldWhole::parts),
                     field("best", &OldWhole::best), field("colour", &OldWhole::colour),
                     field("heading", &OldWhole::heading, "rad"));
  }
};

template <class T>
std::vector<std::uint8_t> bytesOf(const T& value) {
  std::vector<std::uint8_t> bytes;
  encode(value, bytes);
  return bytes;
}

SchemaTranslation oldToNew() {
  return *SchemaTranslation::make(schemaName<Whole>(), schemaText<OldWhole>(), schemaText<Whole>());
}

Whole translated(const OldWhole& old) {
  const auto bytes = bytesOf(old);
  std::vector<std::uint8_t> out;
  Whole now;
  EXPECT_TRUE(oldToNew().translate(bytes.data(), bytes.size(), bytesOf(Whole{}), out));
  EXPECT_TRUE(decode(out.data(), out.size(), now));
  return now;
}

TEST(SchemaTranslation, MembersAreFoundByNameAndNumbersConverted) {
  OldWhole old;
  old.sides = {8.0F, 9.0F};
  old.heading = Angle::deg(-45);
  old.best.weight = 0.25;
  const Whole now = translated(old);
  EXPECT_EQ(now.sides[0], 8.0);
  EXPECT_EQ(now.sides[1], 9.0);
  EXPECT_NEAR(now.heading.deg(), -45.0, 1e-12);
  EXPECT_EQ(now.best.weight, 0.25F);
}

TEST(SchemaTranslation, WhatWasNotRecordedHasItsDefault) {
  const Whole now = translated({});
  EXPECT_EQ(now.count, 7);
  EXPECT_TRUE(now.present);
  EXPECT_EQ(now.sides[2], 3.0);
  EXPECT_EQ(now.best.side, Side::left);
}

TEST(SchemaTranslation, NewMembersOfListedStructsAreAsNearToZeroAsTheirRangeAllows) {
  OldWhole old;
  old.parts.push_back({4.0});
  old.parts.push_back({5.0});
  const Whole now = translated(old);
  ASSERT_EQ(now.parts.size(), 2U);
  EXPECT_EQ(now.parts[1].weight, 5.0F);
  EXPECT_EQ(now.parts[1].side, Side::left);  // 1..2
}

struct Stroke {
  double min = -1.0;
  double max = 1.0;
  static constexpr const char* typeName() { return "Stroke"; }
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("min", &Stroke::min), field("max", &Stroke::max));
  }
};

struct OldStroke {
  double most = 0.0;
  double min = 0.0;
  double least = 0.0;  // means something else beside a `min`
  static constexpr const char* typeName() { return "Stroke"; }
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("most", &OldStroke::most), field("min", &OldStroke::min),
                     field("least", &OldStroke::least));
  }
};

TEST(SchemaTranslation, AMemberThatWasRenamedIsReadByItsFormerName) {
  const auto translation =
      SchemaTranslation::make("kelpie/Stroke", schemaText<OldStroke>(), schemaText<Stroke>());
  ASSERT_TRUE(translation);
  const auto bytes = bytesOf(OldStroke{5.0, -3.0, -2.0});
  std::vector<std::uint8_t> out;
  ASSERT_TRUE(translation->translate(bytes.data(), bytes.size(), bytesOf(Stroke{}), out));
  Stroke now;
  ASSERT_TRUE(decode(out.data(), out.size(), now));
  EXPECT_EQ(now.max, 5.0);
  EXPECT_EQ(now.min, -3.0);
  EXPECT_EQ(translation->leftOut(), (std::vector<std::string>{"least"}));
}

TEST(SchemaTranslation, SaysWhichMembersDiffer) {
  const auto translation = oldToNew();
  EXPECT_EQ(translation.defaulted(),
            (std::vector<std::string>{"count", "present", "parts.side", "best.side"}));
  EXPECT_EQ(translation.leftOut(), (std::vector<std::string>{"colour"}));
}

TEST(SchemaTranslation, ListsThatFitNoMoreAreRefusedByDecode) {
  OldWhole old;
  for (int i = 0; i < 5; ++i) old.parts.push_back({1.0});  // room for four
  const auto bytes = bytesOf(old);
  std::vector<std::uint8_t> out;
  Whole now;
  ASSERT_TRUE(oldToNew().translate(bytes.data(), bytes.size(), bytesOf(Whole{}), out));
  EXPECT_FALSE(decode(out.data(), out.size(), now));
}

TEST(SchemaTranslation, CutOffBytesAreRefusedAtEveryLength) {
  OldWhole old;
  old.parts.push_back({1.0});
  const auto bytes = bytesOf(old);
  const auto translation = oldToNew();
  std::vector<std::uint8_t> out;
  for (std::size_t n = 0; n < bytes.size(); ++n)
    EXPECT_FALSE(translation.translate(bytes.data(), n, bytesOf(Whole{}), out)) << n;
}

TEST(SchemaTranslation, RandomBytesAreReadOrRefused) {
  Random random(5);
  const auto translation = oldToNew();
  std::vector<std::uint8_t> out;
  for (int i = 0; i < 2000; ++i) {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(random.uniform(0.0, 90.0)));
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.uniform(0.0, 256.0));
    static_cast<void>(translation.translate(bytes.data(), bytes.size(), bytesOf(Whole{}), out));
  }
}

TEST(SchemaTranslation, TextThatNamesNoTypeOrNestsForeverIsRefused) {
  const auto refused = [](const std::string& text) {
    return !SchemaTypes::parse("kelpie/Whole", text);
  };
  EXPECT_TRUE(refused(""));
  EXPECT_TRUE(refused("float64\n"));
  EXPECT_TRUE(refused("kelpie/Missing part\n"));
  EXPECT_TRUE(refused("kelpie/Whole part\n"));
  EXPECT_TRUE(refused("float64[x] sides\n"));
  EXPECT_FALSE(refused("float64[3] sides  # cm\n"));
}

class OldLog : public LogFiles {};

TEST_F(OldLog, IsDecodedAndTheDifferenceIsNoted) {
  const std::string path = pathOf("log");
  auto log = LogWriter::open(path);
  ASSERT_TRUE(log);
  OldWhole old;
  old.best.weight = 3.0;
  log->write("things", TimeUs{5}, old);
  ASSERT_TRUE(log->close());
  auto reader = LogReader::open(path);
  LogMessage message;
  ASSERT_TRUE(reader->next(message));
  Whole now;
  const Status read = decodeAs(message, now);
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(now.best.weight, 3.0F);
  EXPECT_EQ(reader->notes(),
            (std::vector<std::string>{
                "kelpie/Whole: recorded with another field list; not recorded, set to the default: "
                "count, present, parts.side, best.side; recorded, no longer known: colour"}));
}

}  // namespace
}  // namespace kelpie
