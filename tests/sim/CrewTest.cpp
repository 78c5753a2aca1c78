// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

#include "tools/sim/world/Crew.h"

namespace kelpie::sim {
namespace {

TEST(Crew, DoesEachPieceOfABatchOnceBatchAfterBatch) {
  for (const std::size_t threads : {0U, 1U, 3U}) {
    Crew crew(threads);
    for (std::size_t count = 0; count < 40; ++count) {
      std::vector<std::atomic<int>> done(count);
      crew.begin(count, [&done](std::size_t i) { ++done[i]; });
      crew.finish();
      for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1) << threads << " " << count;
    }
  }
}

TEST(Crew, HasNothingToFinishWithoutABatchOrTwice) {
  Crew crew(2);
  crew.finish();
  int pieces = 0;
  crew.begin(1, [&pieces](std::size_t) { ++pieces; });
  crew.finish();
  crew.finish();
  EXPECT_EQ(pieces, 1);
}

TEST(Crew, TellsWhatAPieceThrewWhenTheOthersAreDoneAndGoesOn) {
  Crew crew(2);
  std::atomic<int> done{0};
  crew.begin(8, [&done](std::size_t i) {
    if (i == 3) throw std::runtime_error("broken");
    ++done;
  });
  EXPECT_THROW(crew.finish(), std::runtime_error);
  EXPECT_EQ(done, 7);
  crew.begin(2, [&done](std::size_t) { ++done; });
  EXPECT_NO_THROW(crew.finish());
  EXPECT_EQ(done, 9);
}

TEST(Crew, LeavesWhatNobodyHasBegunWhenItEnds) {
  int done = 0;
  {
    Crew crew(0);
    crew.begin(5, [&done](std::size_t) { ++done; });
  }
  EXPECT_EQ(done, 0);
}

}  // namespace
}  // namespace kelpie::sim
