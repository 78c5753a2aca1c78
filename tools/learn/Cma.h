// SPDX-License-Identifier: Apache-2.0
// CMA-ES (covariance matrix adaptation) by Debian's python3-cmaes, in a child process that is asked
// for points and given their gains. The same seed asks for the same points.
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "tools/learn/SearchPlan.h"

namespace kelpie::learn {

class Cma {
 public:
  // Points are in shares, 0 to 1, of each number's range. Error: it is not installed.
  static Expected<Cma> start(const std::vector<double>& mean, const SearchPlan& plan);

  // The points of the next generation.
  Expected<std::vector<std::vector<double>>> ask();
  // Their gains, in the same order.
  void tell(const std::vector<double>& gains);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  using File = std::unique_ptr<std::FILE, Close>;
  // Ends when its input does, and is waited for then.
  struct Child {
    explicit Child(int process) : id(process) {}
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child();
    int id;
  };
  Expected<std::string> line();

  std::unique_ptr<Child> child_;
  File from_;
  File to_;
};

}  // namespace kelpie::learn
