// SPDX-License-Identifier: Apache-2.0
// Experiments register themselves and say which options they use.
#include <gtest/gtest.h>

#include "tools/experiments/harness/Experiment.h"

namespace kelpie::experiments {
namespace {

Expected<Json> seedTwice(const Request& request) { return Json{{"twice", 2 * request.seed}}; }
Expected<Json> failing(const Request& /*request*/) { return Error{"no field"}; }

const Registration kSecond("zwei", "the second by name", {Option::seed}, 1, seedTwice);
const Registration kFirst("eins", "the first by name", {Option::trials, Option::params}, 3,
                          failing);

TEST(Registry, KnowsEveryExperimentSortedByName) {
  const auto all = sortedByName(Registration::all());
  ASSERT_TRUE(all) << all.error();
  ASSERT_EQ(all->size(), 2U);
  EXPECT_STREQ((*all)[0].name, "eins");
  EXPECT_STREQ((*all)[1].name, "zwei");
  EXPECT_EQ((*all)[0].trials, 3);
}

TEST(Registry, RefusesTwoExperimentsOfOneName) {
  std::vector<Experiment> twice = Registration::all();
  twice.push_back(twice[0]);
  const auto all = sortedByName(twice);
  ASSERT_FALSE(all);
  EXPECT_EQ(all.error(), std::string("two experiments are called '") + twice[0].name + "'");
}

TEST(Registry, NamesTheOptionThatIsNotUsedAndThoseThatAre) {
  const Experiment one{"eins", "", {Option::trials, Option::params}, 1, failing};
  EXPECT_TRUE(checkOptions(one, {Option::trials}));
  EXPECT_TRUE(checkOptions(one, {}));
  EXPECT_EQ(checkOptions(one, {Option::trials, Option::seed}).error(),
            "eins does not use --seed; it knows --trials, --params, --json");
}

TEST(Registry, PutsTheCommonKeysBeforeTheFigures) {
  const Experiment one{"zwei", "", {Option::seed}, 1, seedTwice};
  Request request;
  request.seed = 21;
  const auto figures = measure(one, request);
  ASSERT_TRUE(figures) << figures.error();
  EXPECT_EQ(figures->dump(), R"({"experiment":"zwei","trials":1,"seed":21,"twice":42})");
  EXPECT_EQ(measure({"eins", "", {}, 1, failing}, request).error(), "eins: no field");
}

}  // namespace
}  // namespace kelpie::experiments
