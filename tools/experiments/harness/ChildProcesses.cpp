// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/harness/ChildProcesses.h"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <thread>

namespace kelpie::experiments {
namespace {

struct Child {
  int number = 0;
  pid_t pid = -1;
  int output = -1;
  std::string text;
};

bool writeAll(int to, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = write(to, text.data() + done, text.size() - done);
    if (count <= 0) return false;
    done += static_cast<std::size_t>(count);
  }
  return true;
}

Json answerOf(const Job& job, int number) {
  try {
    const Expected<Json> answer = job(number);
    return answer ? Json{{"answer", *answer}} : Json{{"error", answer.error()}};
  } catch (const std::exception& error) {
    return Json{{"error", error.what()}};
  }
}

// The child leaves without unwinding: what it copied of its parent is the parent's to close.
Expected<Child> startChild(const Job& job, int number) {
  int ends[2];
  if (pipe(ends) != 0) return Error{"cannot make a pipe"};
  std::fflush(nullptr);
  const pid_t pid = fork();
  if (pid < 0) {
    close(ends[0]);
    close(ends[1]);
    return Error{"cannot start a process"};
  }
  if (pid == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    close(ends[0]);
    const bool reported = writeAll(ends[1], answerOf(job, number).dump());
    _exit(reported ? 0 : 1);
  }
  close(ends[1]);
  return Child{number, pid, ends[0], {}};
}

// Waits for output of any child; true when one has closed its end.
bool listen(std::vector<Child>& children) {
  std::vector<pollfd> waits;
  waits.reserve(children.size());
  for (const Child& child : children) waits.push_back({child.output, POLLIN, 0});
  poll(waits.data(), static_cast<nfds_t>(waits.size()), -1);
  bool closed = false;
  for (std::size_t i = 0; i < waits.size(); ++i) {
    if (waits[i].revents == 0) continue;
    char buffer[65536];
    const ssize_t count = read(children[i].output, buffer, sizeof buffer);
    if (count > 0) {
      children[i].text.append(buffer, static_cast<std::size_t>(count));
    } else {
      close(children[i].output);
      children[i].output = -1;
      closed = true;
    }
  }
  return closed;
}

void finish(const Child& child, std::vector<Json>& answers, std::string& trouble) {
  waitpid(child.pid, nullptr, 0);
  const Json message = Json::parse(child.text, nullptr, false);
  if (message.is_object() && message.contains("answer")) {
    answers[static_cast<std::size_t>(child.number)] = message["answer"];
  } else if (trouble.empty()) {
    trouble =
        message.is_object() ? message.value("error", "nothing said") : "a trial's process died";
  }
}

}  // namespace

Expected<std::vector<Json>> runInChildProcesses(
    int jobs, const Job& job, const std::function<void(int done, int all)>& progress) {
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  std::vector<Json> answers(static_cast<std::size_t>(jobs));
  std::vector<Child> children;
  std::string trouble;
  int next = 0;
  int done = 0;
  while (!children.empty() || (next < jobs && trouble.empty())) {
    while (next < jobs && children.size() < cores && trouble.empty()) {
      auto child = startChild(job, next++);
      if (!child) trouble = child.error();
      if (child) children.push_back(std::move(*child));
    }
    if (children.empty() || !listen(children)) continue;
    for (const Child& child : children) {
      if (child.output >= 0) continue;
      finish(child, answers, trouble);
      if (progress) progress(++done, jobs);
    }
    children.erase(std::remove_if(children.begin(), children.end(),
                                  [](const Child& child) { return child.output < 0; }),
                   children.end());
  }
  if (!trouble.empty()) return Error{trouble};
  return answers;
}

}  // namespace kelpie::experiments
