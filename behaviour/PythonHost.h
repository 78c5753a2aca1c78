// SPDX-License-Identifier: Apache-2.0
// Owns the interpreter, the loaded version of the behaviours, the frame that they look at and the
// last error. What no watchdog breaks into, one long C call, ends the process on a PC (Watchdog.h).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "behaviour/BehaviourIn.h"
#include "behaviour/BehaviourParams.h"
#include "behaviour/RecentReports.h"
#include "behaviour/Rows.h"
#include "behaviour/interpreter/Modules.h"
#include "behaviour/interpreter/PrintedLines.h"
#include "behaviour/interpreter/SharedInterpreter.h"
#include "behaviour/views/CommandReader.h"
#include "behaviour/views/ViewTypes.h"
#include "behaviour/views/WorldFrame.h"
#include "robot/core/Expected.h"
#include "robot/core/types/Command.h"

namespace kelpie::behaviour {

class PythonHost {
 public:
  // `beside`: another one, whose interpreter it shares.
  PythonHost(const std::string& scripts, const Constants& constants, const PythonHost* beside);
  ~PythonHost();
  PythonHost(const PythonHost&) = delete;
  PythonHost& operator=(const PythonHost&) = delete;

  // Takes over edited files, calls decide() and reads its answer. The Fallback tells what went
  // wrong; `command` is the script's only with Fallback::none.
  Fallback decide(const BehaviourIn& in, const BehaviourParams& params, Command& command);

  // See BehaviourState::ask.
  Expected<Rows> ask(const std::string& function);

  const std::string& lastError() const { return lastError_; }
  const RecentReports& reports() const { return reports_; }
  void say(const std::string& line);  // a script prints

 private:
  void prepare(const Constants& constants, const PythonHost* beside);
  bool listen();
  bool watch(const PythonHost* beside);
  bool takeFrom(const PythonHost& beside, const char* name);  // of its guard
  void tellLeftOut(std::uint32_t lines);
  std::size_t heapToLoad();
  std::size_t heapToDecide(const BehaviourParams& params) const;
  bool load();
  void reloadIfEdited(const BehaviourParams& params);
  Fallback call(const BehaviourParams& params, Command& command);
  void restAfter(Fallback last);
  Fallback read(PyObject* answer, Command& command);
  Fallback fail(Fallback reason);
  void failLoading();
  PythonRef takeError(std::string& line, std::string& all);
  void report(const std::string& line, const std::string& all);
  bool describe(PyObject* error, std::string& line, std::string& all);

  Modules modules_;
  std::string lastError_;
  RecentReports reports_;
  PrintedLines printed_;
  std::vector<std::string> knownErrors_;  // places and kinds of those that were reported
  std::uint32_t framesToLook_ = 0;
  std::uint32_t lateInARow_ = 0;    // calls that hit the time limit
  std::uint32_t framesToRest_ = 0;  // before the next call
  bool broken_ = false;             // an edit failed to load; an older version may still be running

  SharedInterpreter interpreter_;  // before everything that holds references
  std::unique_ptr<ViewTypes> types_;
  std::unique_ptr<CommandReader> reader_;
  std::unique_ptr<WorldFrame> frame_;
  PythonRef guard_;
  PythonRef kelpie_;
  PythonRef commandType_;
  PythonRef world_;
  PythonRef version_;
  PythonRef decide_;
};

}  // namespace kelpie::behaviour
