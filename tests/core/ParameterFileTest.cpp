// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "robot/core/parameters/ParameterFile.h"
#include "robot/core/types/Geometry.h"

namespace kelpie {
namespace {

enum class Side : std::uint8_t { left, right };

struct InnerParams {
  Angle tilt = Angle::deg(5.0);
  double turnRate = 0.5;
  double timeout = 2.0;
  TimeUs period{40000};
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("tilt", &InnerParams::tilt, "rad", -20, 20),
                     field("turnRate", &InnerParams::turnRate, "rad/s", 0, 4),
                     field("timeout", &InnerParams::timeout, "s", 0, 10),
                     field("period", &InnerParams::period, "us", 0));
  }
};

struct ToyParams {
  double speed = 10.0;
  std::int32_t samples = 4;
  std::uint8_t margin = 8;
  double share = 0.5;
  bool enabled = true;
  Side side = Side::left;
  std::array<double, 3> gains = {1.0, 2.0, 3.0};
  FixedVector<Angle, 2> looks;
  FixedVector<Point2<Field>, 2> spots;
  InnerParams inner;
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(
        field("speed", &ToyParams::speed, "cm/s", 0, 40),
        field("samples", &ToyParams::samples, "", 1, 100),
        field("margin", &ToyParams::margin, "px"), field("share", &ToyParams::share, "", 0, 1),
        field("enabled", &ToyParams::enabled), field("side", &ToyParams::side, "", 0, 1),
        field("gains", &ToyParams::gains, "", 0, 9),
        field("looks", &ToyParams::looks, "rad", -90, 90), field("spots", &ToyParams::spots),
        field("inner", &ToyParams::inner));
  }
};

class ParameterFile : public testing::Test {
 protected:
  ParameterFile() { set.add("toy", params); }

  std::string file(const std::string& name, const std::string& text) const {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    const std::string path = testing::TempDir() + "kelpie_" + test->name() + "_" + name;
    std::ofstream(path) << text;
    return path;
  }
  void apply(const std::string& text) {
    const Status status = set.overlay(file("a.toml", text));
    ASSERT_TRUE(status) << status.error();
  }
  // The error without the path: ":line: what".
  std::string errorOf(const std::string& text) {
    const std::uint64_t before = set.hash();
    const std::string path = file("bad.toml", text);
    const Status status = set.overlay(path);
    EXPECT_EQ(set.hash(), before) << "nothing of a bad file is applied";
    EXPECT_EQ(status.error().compare(0, path.size(), path), 0) << status.error();
    return status ? "no error" : status.error().substr(path.size());
  }

  ToyParams params;
  ParameterSet set;
};

TEST_F(ParameterFile, EveryKindOfMemberIsSet) {
  apply(
      "[toy]\nspeed = \"25cm/s\"\nsamples = 7\nmargin = \"9 px\"\nshare = 0.25\nenabled = false\n"
      "side = 1\ngains = [3, 2.5, 0]\nlooks = [\"-90deg\"]\n");
  EXPECT_EQ(params.speed, 25.0);
  EXPECT_EQ(params.samples, 7);
  EXPECT_EQ(params.margin, 9);
  EXPECT_EQ(params.share, 0.25);
  EXPECT_FALSE(params.enabled);
  EXPECT_EQ(params.side, Side::right);
  EXPECT_EQ(params.gains, (std::array<double, 3>{3.0, 2.5, 0.0}));
  ASSERT_EQ(params.looks.size(), 1U);
  EXPECT_EQ(params.looks[0], Angle::deg(-90));
}

TEST_F(ParameterFile, AnglesAndTimesTakeTheirOtherUnit) {
  apply(
      "[toy.inner]\ntilt = \"12deg\"\nturnRate = \"90deg/s\"\ntimeout = \"250ms\"\n"
      "period = \"0.1s\"\n");
  EXPECT_EQ(params.inner.tilt, Angle::deg(12));
  EXPECT_NEAR(params.inner.turnRate, 1.5707963267948966, 1e-15);
  EXPECT_EQ(params.inner.timeout, 0.25);
  EXPECT_EQ(params.inner.period.us, 100000);
  apply("[toy.inner]\ntilt = \"-0.2rad\"\nturnRate = \"1.5rad/s\"\nperiod = \"8ms\"\n");
  EXPECT_EQ(params.inner.tilt.rad(), -0.2);
  EXPECT_EQ(params.inner.turnRate, 1.5);
  EXPECT_EQ(params.inner.period.us, 8000);
}

TEST_F(ParameterFile, LaterFilesOverlayByKey) {
  apply("[toy]\nsamples = 7\nshare = 0.25\n");
  const std::string game = file("game.toml", "\n[toy]\nshare = 1\n[toy.inner]\ntilt=\"6deg\"\n");
  ASSERT_TRUE(set.overlay(game));
  const std::vector<ParameterChange> changes = set.changes();
  ASSERT_EQ(changes.size(), 3U);
  EXPECT_EQ(changes[0].key, "toy.samples");
  EXPECT_EQ(changes[1].text(), "toy.share = 1 (default 0.5) from " + game + ":3");
  EXPECT_EQ(changes[2].text(), "toy.inner.tilt = 6deg (default 5deg) from " + game + ":5");
}

TEST_F(ParameterFile, HashTellsValuesApart) {
  const std::uint64_t start = set.hash();
  apply("[toy]\nsamples = 5\n");
  EXPECT_NE(set.hash(), start);
  apply("[toy]\nsamples = 4\n");
  EXPECT_EQ(set.hash(), start);
  EXPECT_TRUE(set.changes().empty());
}

TEST_F(ParameterFile, AProgramSetsOneNumberByItsKey) {
  ASSERT_TRUE(set.assign("toy.side", 1));
  ASSERT_TRUE(set.assign("toy.share", 0.25));
  ASSERT_TRUE(set.assign("toy.enabled", 0));
  EXPECT_EQ(params.side, Side::right);
  EXPECT_EQ(params.share, 0.25);
  EXPECT_FALSE(params.enabled);
  EXPECT_EQ(set.changes()[0].source, "program");
}

TEST_F(ParameterFile, AProgramSetsOneMeasureWithItsUnit) {
  ASSERT_TRUE(set.assign("toy.speed", "25cm/s"));
  EXPECT_EQ(params.speed, 25.0);
  EXPECT_FALSE(set.assign("toy.speed", "25"));
  EXPECT_FALSE(set.assign("toy.speed", "25deg"));
  EXPECT_FALSE(set.assign("toy.share", "25cm"));
  EXPECT_EQ(params.speed, 25.0);
}

TEST_F(ParameterFile, WhatAProgramCannotSetIsRefusedAndStaysAsItWas) {
  for (const char* key : {"toy.love", "toy", "toy.gains", "toy.spots", "toy.speed"})
    EXPECT_FALSE(set.assign(key, 1)) << key;
  EXPECT_FALSE(set.assign("toy.side", 2));
  EXPECT_FALSE(set.assign("toy.samples", 1.5));
  EXPECT_FALSE(set.assign("toy.enabled", 0.5));
  EXPECT_FALSE(set.assign("toy.share", std::numeric_limits<double>::quiet_NaN()));
  EXPECT_TRUE(set.changes().empty());
}

TEST_F(ParameterFile, UnknownNamesAreErrors) {
  EXPECT_EQ(errorOf("[toy]\nsamples = 5\nsampels = 5\n"), ":3: unknown key toy.sampels");
  EXPECT_EQ(errorOf("\n[tow]\nsamples = 5\n"), ":2: unknown section [tow]");
  EXPECT_EQ(errorOf("[toy.outer]\n"), ":1: unknown section [toy.outer]");
  EXPECT_EQ(errorOf("samples = 5\n"), ":1: unknown key samples");
  EXPECT_EQ(errorOf("[toy]\ninner = 5\n"), ":2: toy.inner is a section, not a key");
}

TEST_F(ParameterFile, MissingAndWrongUnitsAreErrors) {
  EXPECT_EQ(errorOf("[toy]\nspeed = 25\n"),
            ":2: toy.speed: 25 has no unit, expected cm/s, in quotes");
  EXPECT_EQ(errorOf("[toy]\nspeed = \"25\"\n"), ":2: toy.speed: \"25\" has no unit, expected cm/s");
  EXPECT_EQ(errorOf("[toy]\nspeed = \"25cm\"\n"),
            ":2: toy.speed: \"25cm\" has a wrong unit, expected cm/s");
  EXPECT_EQ(errorOf("[toy.inner]\ntilt = 0.1\n"),
            ":2: toy.inner.tilt: 0.1 has no unit, expected deg or rad, in quotes");
  EXPECT_EQ(errorOf("[toy.inner]\ntimeout = \"1m\"\n"),
            ":2: toy.inner.timeout: \"1m\" has a wrong unit, expected s or ms");
  EXPECT_EQ(errorOf("[toy]\nsamples = \"5px\"\n"),
            ":2: toy.samples: takes a number without quotes and unit");
}

TEST_F(ParameterFile, NumbersOutOfRangeAreErrors) {
  EXPECT_EQ(errorOf("[toy]\nspeed = \"41cm/s\"\n"), ":2: toy.speed: 41cm/s is outside 0..40 cm/s");
  EXPECT_EQ(errorOf("[toy]\nsamples = 0\n"), ":2: toy.samples: 0 is outside 1..100");
  EXPECT_EQ(errorOf("[toy]\nmargin = \"256px\"\n"), ":2: toy.margin: 256px is outside 0..255 px");
  EXPECT_EQ(errorOf("[toy.inner]\ntilt = \"0.4rad\"\n"),
            ":2: toy.inner.tilt: 0.4rad is outside -20..20 deg");
  EXPECT_EQ(errorOf("[toy]\nside = 2\n"), ":2: toy.side: 2 is outside 0..1");
  EXPECT_EQ(errorOf("[toy]\nshare = nan\n"), ":2: toy.share: nan is outside 0..1");
  EXPECT_EQ(errorOf("[toy]\ngains = [\n1,\n10,\n1]\n"), ":4: toy.gains: 10 is outside 0..9");
}

TEST_F(ParameterFile, WrongTypesAreErrors) {
  EXPECT_EQ(errorOf("[toy]\nsamples = 5.5\n"), ":2: toy.samples: 5.5 is not a whole number");
  EXPECT_EQ(errorOf("[toy]\nsamples = true\n"), ":2: toy.samples: cannot be true or false");
  EXPECT_EQ(errorOf("[toy]\nenabled = 1\n"), ":2: toy.enabled: takes true or false, not a number");
  EXPECT_EQ(errorOf("[toy]\nspeed = \"fast\"\n"), ":2: toy.speed: \"fast\" is not a number");
  EXPECT_EQ(errorOf("[toy.samples]\n"), ":1: toy.samples: cannot be a section");
  EXPECT_EQ(errorOf("[toy]\nshare = [1]\n"), ":2: toy.share: cannot be an array");
  EXPECT_EQ(errorOf("[toy]\ngains = 1\n"), ":2: toy.gains: takes an array");
  EXPECT_EQ(errorOf("[toy]\ngains = [1, 2]\n"), ":2: toy.gains: 2 elements, expected 3");
  EXPECT_EQ(errorOf("[toy]\nlooks = [\"1deg\", \"1deg\", \"1deg\"]\n"),
            ":2: toy.looks: 3 elements, expected at most 2");
  EXPECT_EQ(errorOf("[toy]\nspots = []\n"), ":2: toy.spots: a list that no parameter file can set");
}

TEST_F(ParameterFile, BadTomlIsNamedWithItsLine) {
  EXPECT_EQ(errorOf("[toy]\nsamples = 5\nsamples = 6\n").substr(0, 4), ":3: ");
  EXPECT_EQ(errorOf("[toy]\n\nsamples\n").substr(0, 2), ":3");
  EXPECT_EQ(errorOf("[toy]\nsamples = 5\n[toy]\n").substr(0, 4), ":3: ");
  EXPECT_EQ(set.overlay("/nowhere/a.toml").error(), "/nowhere/a.toml: No such file or directory");
}

TEST_F(ParameterFile, TheFirstErrorOfTheFileIsTheOneReported) {
  EXPECT_EQ(errorOf("[toy]\nspeed = 1\n\nenabled = 2\n").substr(0, 14), ":2: toy.speed:");
}

TEST_F(ParameterFile, EmptyFileChangesNothing) {
  apply("# nothing\n");
  EXPECT_TRUE(set.changes().empty());
}

// At the first four toml++'s own parser ends the program or leaves the language.
TEST_F(ParameterFile, NoTextIsTooOddToBeRefusedInOneLine) {
  for (const char* text : {"[[[toy]\n", "[toy]\nspeed = 29.\u01e2\n", "\ufcff = 1\n",
                           "10a.\"\"\"a\\\t\u01d0\"\"\" = 1\n", "[toy]\nenabled = tru\n\n",
                           "[\"a\\nb\"]\n", "[toy]\n\"a\\nb\" = 1\n"}) {
    const std::string said = errorOf(text);
    EXPECT_EQ(said[0], ':') << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  }
}

TEST_F(ParameterFile, LettersBeyondAsciiStandInQuotesAndCommentsAlone) {
  const std::string beyond = "\u00e4\ufcff";
  const Status read = set.overlay(
      file("good.toml", "\ufeff# " + beyond + "\n[toy] # \"" + beyond + "\nspeed = \"5cm/s\"\n"));
  EXPECT_TRUE(read) << read.error();
  for (const std::string& text :
       {"'a" + beyond + "'", "\"\\\"" + beyond + "\"", "\"\"\"\n\"" + beyond + "\"\"\"\"\"",
        "'''\n''" + beyond + "''''"}) {
    const std::string toy = "[toy]\nspeed = " + text;
    const std::string said = errorOf(toy + "\n");
    EXPECT_EQ(said.substr(0, 13), ":2: toy.speed") << said;
    const std::string goesOn = errorOf("[toy]\nspeed = \"\"\"\\\\ a\\\n " + beyond + "\"\"\"\n");
    EXPECT_EQ(goesOn.substr(0, 4), ":3: ") << goesOn;
    const std::string stray = errorOf(toy + beyond + "\n");
    EXPECT_NE(stray.find("a letter beyond ASCII stands neither"), std::string::npos) << stray;
  }
}

}  // namespace
}  // namespace kelpie
