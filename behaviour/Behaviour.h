// SPDX-License-Identifier: Apache-2.0
// behaviour: the host of the embedded Python. Calls decide(world) once per camera frame, validates
// and clamps the Command, and answers with a safe one (stand and scan) when the script cannot.
// While somebody drives the robot the Command is the driver's, and the script is not called.
#pragma once

#include <memory>
#include <string>

#include "behaviour/BehaviourIn.h"
#include "behaviour/BehaviourParams.h"
#include "behaviour/RecentReports.h"
#include "behaviour/Rows.h"
#include "robot/core/Expected.h"
#include "robot/core/types/Command.h"

namespace kelpie::behaviour {

class PythonHost;  // the only owner of Python objects

// Holds the loaded script and the interpreter, of which CPython allows one in a process: a second
// state stands beside the first and shares it. Scripts share nothing but that: each state loads
// modules of its own.
class BehaviourState {
 public:
  // `scripts`: folder or zip with the behaviours (pycode/). A script that does not load leaves the
  // state usable: every step answers with the fallback and tries again when the file has changed.
  // `constants`: what kelpie.constants holds, for good: behaviours read it when they are loaded.
  // `beside`: another one of this process, if there is one; both live and are used in one thread.
  explicit BehaviourState(const std::string& scripts, const Constants& constants = {},
                          const BehaviourState* beside = nullptr);
  ~BehaviourState();
  BehaviourState(const BehaviourState&) = delete;
  BehaviourState& operator=(const BehaviourState&) = delete;

  PythonHost& host() { return *host_; }
  // First line of the last script error with file and line, empty if the last call went well.
  const std::string& lastError() const;
  // What went wrong in the scripts, and what they print.
  const RecentReports& reports() const;
  // For tools, not during play: what a function of main.py without parameters answers, a list of
  // texts or of tuples, each cell as text ("True" for a bool). An error has one line.
  Expected<Rows> ask(const std::string& function);

 private:
  std::unique_ptr<PythonHost> host_;
};

Command step(const BehaviourIn& in, const BehaviourParams& params, BehaviourState& state);

// Who decides in a program that links this: "python", or "simple" (robot/object).
const char* playerName();

}  // namespace kelpie::behaviour
