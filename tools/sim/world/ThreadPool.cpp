// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/world/ThreadPool.h"

#include <utility>

namespace kelpie::sim {

ThreadPool::ThreadPool(std::size_t threads) {
  for (std::size_t i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
}

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  begun_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void ThreadPool::begin(std::size_t count, Piece piece) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    piece_ = std::move(piece);
    count_ = count;
    next_ = finished_ = 0;
    thrown_ = nullptr;
  }
  begun_.notify_all();
}

void ThreadPool::finish() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (takeOne(lock)) {
  }
  done_.wait(lock, [this] { return finished_ == count_; });
  if (thrown_ != nullptr) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

// Whether there was one. The lock is held before and after, not while it is worked on.
bool ThreadPool::takeOne(std::unique_lock<std::mutex>& lock) {
  if (next_ == count_) return false;
  const std::size_t i = next_++;
  lock.unlock();
  std::exception_ptr thrown;
  try {
    piece_(i);
  } catch (...) {
    thrown = std::current_exception();
  }
  lock.lock();
  if (thrown != nullptr) thrown_ = thrown;
  if (++finished_ == count_) done_.notify_all();
  return true;
}

void ThreadPool::work() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    begun_.wait(lock, [this] { return ends_ || next_ < count_; });
    if (ends_) return;
    (void)takeOne(lock);
  }
}

}  // namespace kelpie::sim
