// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/Cma.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <sstream>

namespace kelpie::learn {
namespace {

// Reads "seed population spread" and the mean; then in turn writes the number of points and the
// points, and reads their gains. Numbers are hexadecimal: the same bits on both sides.
constexpr const char* kProgram = R"(
import os
import sys
try:
    import numpy
    from cmaes import CMA
except ImportError as error:
    sys.stdin.readline(), sys.stdin.readline()
    sys.exit(print("missing", error))


def numbers():
    return [float.fromhex(word) for word in sys.stdin.readline().split()]


seed, population, spread = numbers()
mean = numpy.array(numbers())
search = CMA(mean=mean, sigma=spread, bounds=numpy.array([[0.0, 1.0]] * len(mean)), seed=int(seed),
             population_size=int(population) or None)
try:
    while True:
        points = [search.ask() for _ in range(search.population_size)]
        print(len(points))
        for point in points:
            print(*(float(share).hex() for share in point))
        sys.stdout.flush()
        gains = numbers()
        if not gains:
            break
        search.tell([(point, -gain) for point, gain in zip(points, gains)])
except BrokenPipeError:
    os._exit(0)  # nobody asks any more
)";

std::string hexLine(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += fmt::format("{:a} ", number);
  return text + '\n';
}

}  // namespace

Cma::Child::~Child() {
  int status = 0;
  waitpid(id, &status, 0);
}

Expected<Cma> Cma::start(const std::vector<double>& mean, const SearchPlan& plan) {
  std::array<int, 2> down{};
  std::array<int, 2> up{};
  if (pipe2(down.data(), O_CLOEXEC) != 0 || pipe2(up.data(), O_CLOEXEC) != 0)
    return Error{"CMA-ES: no pipe"};
  const pid_t id = fork();
  if (id < 0) return Error{"CMA-ES: cannot be started"};
  if (id == 0) {
    dup2(down[0], STDIN_FILENO);
    dup2(up[1], STDOUT_FILENO);
    execl("/usr/bin/python3", "python3", "-I", "-c", kProgram, static_cast<char*>(nullptr));
    _exit(1);
  }
  close(down[0]);
  close(up[1]);
  Cma cma;
  cma.child_ = std::make_unique<Child>(id);
  cma.from_.reset(fdopen(up[0], "r"));
  cma.to_.reset(fdopen(down[1], "w"));
  cma.tell({static_cast<double>(plan.seed), static_cast<double>(plan.population), plan.spread});
  cma.tell(mean);
  return cma;
}

Expected<std::string> Cma::line() {
  char* text = nullptr;
  std::size_t size = 0;
  const ssize_t length = getline(&text, &size, from_.get());
  const std::string line(length > 0 ? text : "");
  std::free(text);
  if (line.rfind("missing", 0) == 0 || line.empty())
    return Error{"CMA-ES is not there: tools/install learn"};
  return line;
}

Expected<std::vector<std::vector<double>>> Cma::ask() {
  const auto count = line();
  if (!count) return Error{count.error()};
  std::vector<std::vector<double>> points(std::strtoul(count->c_str(), nullptr, 10));
  for (auto& point : points) {
    const auto text = line();
    if (!text) return Error{text.error()};
    std::istringstream words(*text);
    for (std::string word; words >> word;) point.push_back(std::strtod(word.c_str(), nullptr));
  }
  return points;
}

void Cma::tell(const std::vector<double>& gains) {
  std::fputs(hexLine(gains).c_str(), to_.get());
  std::fflush(to_.get());
}

}  // namespace kelpie::learn
