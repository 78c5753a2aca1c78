// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

#include "tools/sim/world/ThreadPool.h"

namespace kelpie::sim {
namespace {

TEST(ThreadPool, DoesEachPieceOfABatchOnceBatchAfterBatch) {
  for (const std::size_t threads : {0U, 1U, 3U}) {
    ThreadPool pool(threads);
    for (std::size_t count = 0; count < 40; ++count) {
      std::vector<std::atomic<int>> done(count);
      pool.begin(count, [&done](std::size_t i) { ++done[i]; });
      pool.finish();
      for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1) << threads << " " << count;
    }
  }
}

TEST(ThreadPool, HasNothingToFinishWithoutABatchOrTwice) {
  ThreadPool pool(2);
  pool.finish();
  int pieces = 0;
  pool.begin(1, [&pieces](std::size_t) { ++pieces; });
  pool.finish();
  pool.finish();
  EXPECT_EQ(pieces, 1);
}

TEST(ThreadPool, TellsWhatAPieceThrewWhenTheOthersAreDoneAndGoesOn) {
  ThreadPool pool(2);
  std::atomic<int> done{0};
  pool.begin(8, [&done](std::size_t i) {
    if (i == 3) throw std::runtime_error("broken");
    ++done;
  });
  EXPECT_THROW(pool.finish(), std::runtime_error);
  EXPECT_EQ(done, 7);
  pool.begin(2, [&done](std::size_t) { ++done; });
  EXPECT_NO_THROW(pool.finish());
  EXPECT_EQ(done, 9);
}

TEST(ThreadPool, LeavesWhatNobodyHasBegunWhenItEnds) {
  int done = 0;
  {
    ThreadPool pool(0);
    pool.begin(5, [&done](std::size_t) { ++done; });
  }
  EXPECT_EQ(done, 0);
}

}  // namespace
}  // namespace kelpie::sim
