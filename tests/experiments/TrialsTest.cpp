// SPDX-License-Identifier: Apache-2.0
// Trials in this process and in child processes, and what they leave behind: records and traces.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include "tools/experiments/harness/ChildProcesses.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/harness/Trace.h"
#include "tools/experiments/harness/Trials.h"

namespace kelpie::experiments {
namespace {

struct Part {
  std::string name;
  std::array<double, 2> place{};

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("name", &Part::name), field("place_cm", &Part::place, "cm"));
  }
};

struct Found {
  std::uint64_t seed = 0;
  bool good = false;
  double error = 0.0;
  Values times;
  std::vector<Part> parts;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("seed", &Found::seed), field("good", &Found::good),
                     field("error", &Found::error), field("times_s", &Found::times, "s"),
                     field("parts", &Found::parts));
  }
};

Found someFound(std::uint64_t seed) {
  return {seed, true, 0.1, {1.0 / 3.0, 2.0}, {{"a", {1.5, -2.0}}, {"b", {}}}};
}

Request requestOf(int trials) {
  Request request;
  request.trials = trials;
  request.seed = 40;
  return request;
}

TEST(Trials, HaveSeedsOfTheirOwnAndTellHowFarTheyAre) {
  Request request = requestOf(3);
  std::vector<int> reported;
  request.progress = [&](int done, int all) { reported.push_back(10 * all + done); };
  std::vector<std::uint64_t> seeds;
  eachTrial(request, [&](const Trial& trial) { seeds.push_back(trial.seed); });
  EXPECT_EQ(seeds, (std::vector<std::uint64_t>{40, 41, 42}));
  EXPECT_EQ(reported, (std::vector<int>{31, 32, 33}));
}

TEST(Trials, EndWithTheFirstThatFails) {
  int count = 0;
  const Status done = eachTrial(requestOf(5), [&](const Trial& trial) -> Status {
    ++count;
    if (trial.number == 2) return Error{"no ball"};
    return Done{};
  });
  EXPECT_EQ(done.error(), "no ball");
  EXPECT_EQ(count, 3);
}

TEST(Record, ComesBackFromJsonAsItWas) {
  Found back;
  back.times.assign(9, 7.0);
  fromJson(Json::parse(toJson(someFound(7)).dump()), back);
  EXPECT_EQ(toJson(back).dump(),
            R"({"seed":7,"good":true,"error":0.1,"times_s":[0.3333333333333333,2.0],)"
            R"("parts":[{"name":"a","place_cm":[1.5,-2.0]},{"name":"b","place_cm":[0.0,0.0]}]})");
  EXPECT_EQ(back.times[0], 1.0 / 3.0);
}

TEST(Record, ANumberThatIsNotFiniteComesBackAsNan) {
  Found infinite;
  infinite.error = INFINITY;
  Found back;
  fromJson(Json::parse(toJson(infinite).dump()), back);
  EXPECT_TRUE(std::isnan(back.error));
}

TEST(ChildProcesses, AnswerInTheOrderOfTheTrials) {
  const auto all = trialsInChildProcesses(requestOf(5), [](const Trial& trial) -> Expected<Found> {
    usleep(static_cast<useconds_t>(2000 * (5 - trial.number)));
    return someFound(trial.seed);
  });
  ASSERT_TRUE(all) << all.error();
  ASSERT_EQ(all->size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ((*all)[i].seed, 40 + i);
  EXPECT_EQ((*all)[3].parts[0].name, "a");
}

TEST(ChildProcesses, AFailureNamesTheSeed) {
  const auto all = trialsInChildProcesses(requestOf(3), [](const Trial& trial) -> Expected<Found> {
    if (trial.number == 1) return Error{"the script broke"};
    return someFound(trial.seed);
  });
  ASSERT_FALSE(all);
  EXPECT_EQ(all.error(), "seed 41: the script broke");
}

TEST(ChildProcesses, AChildThatDiesFails) {
  const auto all = trialsInChildProcesses(requestOf(2), [](const Trial& trial) -> Expected<Found> {
    if (trial.number == 1) _exit(3);
    return someFound(trial.seed);
  });
  ASSERT_FALSE(all);
  EXPECT_EQ(all.error(), "a trial's process died");
}

enum class Colour { red, blue };
struct Row {
  TimeUs time;
  std::string who;
  Angle heading;
  Colour colour;
  bool open;
  std::size_t count;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("t_s", &Row::time), field("who", &Row::who),
                     field("heading_deg", &Row::heading), field("colour", &Row::colour),
                     field("open", &Row::open), field("count", &Row::count));
  }
};

TEST(Trace, HasAColumnForEachFieldAndALineForEachRow) {
  const std::string path = testing::TempDir() + "trace.csv";
  {
    Trace<Row> trace(path);
    trace.add({TimeUs{1500000}, "own", Angle::deg(45.0), Colour::blue, true, 3});
    trace.add({TimeUs{2000000}, "other", Angle::deg(-90.0), Colour::red, false, 0});
  }
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  EXPECT_EQ(text.str(),
            "t_s,who,heading_deg,colour,open,count\n1.5,own,45,1,1,3\n2,other,-90,0,0,0\n");
}

TEST(Trace, GoesNowhereUnlessAFolderIsGiven) {
  Request request;
  EXPECT_EQ(request.tracePath("slam-3"), "");
  Trace<Row> none(request.tracePath("slam-3"));
  none.add({});
  request.traces = "out";
  EXPECT_EQ(request.tracePath("slam-3"), "out/slam-3.csv");
}

}  // namespace
}  // namespace kelpie::experiments
