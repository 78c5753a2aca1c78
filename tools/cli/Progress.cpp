// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/Progress.h"

#include <fmt/core.h>

#include <cstdio>
#include <utility>

#include "tools/cli/Terminal.h"

namespace kelpie::cli {
namespace {

constexpr auto kQuiet = std::chrono::seconds(1);
constexpr auto kBetween = std::chrono::milliseconds(200);

double secondsOf(std::chrono::steady_clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

Progress::Progress(std::string task, std::string unit)
    : task_(std::move(task)), unit_(std::move(unit)) {}

Progress::~Progress() {
  if (!begun_) return;
  const double took = secondsOf(Clock::now() - start_);
  if (onTerminal()) fmt::print(stderr, "\r\033[K");
  fmt::print(stderr, "{}: {} of {} {} in {:.0f} s\n", task_, done_, all_, unit_, took);
}

void Progress::draw(std::size_t done, std::size_t all) const {
  const double took = secondsOf(Clock::now() - start_);
  const double left = took * static_cast<double>(all - done) / static_cast<double>(done);
  fmt::print(stderr, "\r\033[K{}: {} of {} {}, {:.0f} s left", task_, done, all, unit_, left);
}

void Progress::operator()(std::size_t done, std::size_t all) {
  done_ = done;
  all_ = all;
  const auto now = Clock::now();
  if (!begun_ && now - start_ < kQuiet) return;
  if (!begun_ && !onTerminal()) fmt::print(stderr, "{}: {} {}\n", task_, all, unit_);
  begun_ = true;
  if (!onTerminal() || done == 0 || now - drawn_ < kBetween) return;
  drawn_ = now;
  draw(done, all);
}

void LiveLine::operator()(const std::string& text) {
  if (!onTerminal()) return;
  drawn_ = true;
  fmt::print(stderr, "\r\033[K{}", text);
}

void LiveLine::clear() {
  if (drawn_) fmt::print(stderr, "\r\033[K");
  drawn_ = false;
}

void LiveLine::finish() {
  if (drawn_) fmt::print(stderr, "\n");
  drawn_ = false;
}

}  // namespace kelpie::cli
