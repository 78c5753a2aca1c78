// SPDX-License-Identifier: Apache-2.0
// How far a long task is, on standard error: on a terminal one line that is drawn again, in a pipe
// one line when it begins and one when it ends.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace kelpie::cli {

class Progress {
 public:
  // "film", "frames": "film: 345 of 767 frames". Says nothing for tasks of less than a second.
  Progress(std::string task, std::string unit);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();  // ends the line

  void operator()(std::size_t done, std::size_t all);

 private:
  using Clock = std::chrono::steady_clock;
  void draw(std::size_t done, std::size_t all) const;

  std::string task_;
  std::string unit_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point drawn_ = start_;
  std::size_t done_ = 0;
  std::size_t all_ = 0;
  bool begun_ = false;
};

// One line that is drawn again: on a terminal only. Standard error goes on in its place after
// clear(), below it after finish().
class LiveLine {
 public:
  void operator()(const std::string& text);
  void clear();
  void finish();

 private:
  bool drawn_ = false;
};

}  // namespace kelpie::cli
