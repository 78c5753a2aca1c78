// SPDX-License-Identifier: Apache-2.0
#include "behaviour/PythonHost.h"

#include <algorithm>

#include "behaviour/interpreter/Console.h"
#include "behaviour/interpreter/Heap.h"
#include "behaviour/views/GivenConstants.h"
#include "behaviour/watch/HungExit.h"
#include "behaviour/watch/Watchdog.h"

namespace kelpie::behaviour {
namespace {

constexpr std::size_t kMaxReports = 64;  // different errors remembered as already reported
constexpr double kLoadLimit = 3.0;       // CPU seconds; loading compiles every file
constexpr double kMegabyte = 1 << 20;

// The pending Python exception, taken over.
PythonRef pendingError() {
  PyObject* type = nullptr;
  PyObject* value = nullptr;
  PyObject* trace = nullptr;
  PyErr_Fetch(&type, &value, &trace);
  PyErr_NormalizeException(&type, &value, &trace);
  if (value != nullptr && trace != nullptr) PyException_SetTraceback(value, trace);
  Py_XDECREF(type);
  Py_XDECREF(trace);
  return PythonRef(value);
}

std::string textOf(PyObject* object) {
  const char* text = object != nullptr ? PyUnicode_AsUTF8(object) : nullptr;
  if (text == nullptr) PyErr_Clear();
  return text != nullptr ? text : "";
}

std::size_t bytesOf(double megabytes) { return static_cast<std::size_t>(megabytes * kMegabyte); }

// What the guard's `say` is; `self` holds the PythonHost.
PyObject* say(PyObject* self, PyObject* line) {
  auto* const host = static_cast<PythonHost*>(PyCapsule_GetPointer(self, nullptr));
  const PythonRef bytes(PyUnicode_AsEncodedString(line, "utf-8", "backslashreplace"));
  if (host == nullptr || !bytes) return nullptr;
  const auto size = static_cast<std::size_t>(PyBytes_GET_SIZE(bytes.get()));
  host->say({PyBytes_AS_STRING(bytes.get()), size});
  Py_RETURN_NONE;
}

PyMethodDef sayMethod = {"say", say, METH_O, nullptr};

// Of a list of lists of texts, as the guard makes it.
Rows rowsOf(PyObject* list) {
  Rows rows;
  for (Py_ssize_t i = 0; i < PyList_Size(list); ++i) {
    PyObject* const cells = PyList_GET_ITEM(list, i);
    rows.emplace_back();
    for (Py_ssize_t k = 0; k < PyList_Size(cells); ++k)
      rows.back().push_back(textOf(PyList_GET_ITEM(cells, k)));
  }
  return rows;
}

}  // namespace

PythonHost::PythonHost(const std::string& scripts, const Constants& constants,
                       const PythonHost* beside)
    : modules_(scripts),
      interpreter_(beside != nullptr
                       ? beside->interpreter_
                       : SharedInterpreter(std::make_unique<Interpreter>(modules_.searchPaths()))),
      frame_(std::make_unique<WorldFrame>()) {
  if (!interpreter_->error().empty()) {
    report(interpreter_->error(), interpreter_->error());
    return;
  }
  prepare(constants, beside);
  if (!world_) fail(Fallback::notLoaded);
  if (world_ && load()) modules_.keep();
}

PythonHost::~PythonHost() { tellLeftOut(printed_.leftOut()); }

void PythonHost::prepare(const Constants& constants, const PythonHost* beside) {
  guard_ = modules_.guard();
  if (!guard_) return;
  kelpie_ = modules_.kelpie(guard_.get());
  if (!kelpie_ || !giveConstants(kelpie_.get(), constants)) return;
  commandType_ = PythonRef(PyObject_GetAttrString(kelpie_.get(), "Command"));
  if (!listen() || !watch(beside)) return;
  types_ = std::make_unique<ViewTypes>();
  reader_ = std::make_unique<CommandReader>();
  PythonRef world = types_->view(*frame_);
  if (commandType_ && types_->good()) world_ = std::move(world);
}

bool PythonHost::takeFrom(const PythonHost& beside, const char* name) {
  const PythonRef shared(PyObject_GetAttrString(beside.guard_.get(), name));
  return shared && PyObject_SetAttrString(guard_.get(), name, shared.get()) == 0;
}

// The signal is the process's: the first of several hosts hears it for all, by its own exception.
// Compiling takes most of loading: of eight hosts one does it.
bool PythonHost::watch(const PythonHost* beside) {
  if (beside != nullptr) return takeFrom(*beside, "TimeLimit") && takeFrom(*beside, "compiled");
  const PythonRef watched(PyObject_CallMethod(guard_.get(), "watch", nullptr));
  Watchdog::listen();
  return static_cast<bool>(watched);
}

// From now on this hears what scripts print.
bool PythonHost::listen() {
  const PythonRef self(PyCapsule_New(this, nullptr, nullptr));
  const PythonRef say(self ? PyCFunction_New(&sayMethod, self.get()) : nullptr);
  return say && PyObject_SetAttrString(guard_.get(), "say", say.get()) == 0;
}

void PythonHost::say(const std::string& line) {
  if (!printed_.admits()) return;
  const std::string shown = printed_.shown(line);
  reports_.add(shown, false);
  tell(shown);
}

void PythonHost::tellLeftOut(std::uint32_t lines) {
  if (lines == 0) return;
  const std::string line = "print(): " + std::to_string(lines) + " more lines; " +
                           std::to_string(printed_.params().linesPerSecond) + " a second are shown";
  reports_.add(line, false);
  tell(line);
}

// An edit is loaded beside the version before, which may have filled its own room.
std::size_t PythonHost::heapToLoad() {
  return interpreter_->heap().used() + bytesOf(BehaviourParams{}.heapLimit);
}

// Of several hosts together: nobody tells whose a block is.
std::size_t PythonHost::heapToDecide(const BehaviourParams& params) const {
  return interpreter_.users() * bytesOf(params.heapLimit);
}

bool PythonHost::load() {
  PythonRef version;
  {
    const Watchdog watchdog(kLoadLimit, kHungLoadExit);
    const HeapLimit limit(interpreter_->heap(), heapToLoad());
    version = modules_.load(guard_.get(), kelpie_.get());
  }
  PythonRef decide(version ? PyObject_GetAttrString(version.get(), "decide") : nullptr);
  broken_ = !decide;
  if (broken_) {
    failLoading();
    return false;
  }
  lateInARow_ = framesToRest_ = 0;
  version_ = std::move(version);
  decide_ = std::move(decide);
  knownErrors_.clear();
  lastError_.clear();
  return true;
}

void PythonHost::reloadIfEdited(const BehaviourParams& params) {
  if (!params.reload || framesToLook_-- > 0) return;
  framesToLook_ = params.reloadFrames - 1;
  if (!modules_.edited()) return;
  const bool loaded = load();
  PyGC_Collect();  // the version before, or half a one: modules and functions hold one another
  if (!loaded) return;
  modules_.keep();
  tell(modules_.loadedLine());  // whoever edits during a match sees that the edit took effect
}

Fallback PythonHost::decide(const BehaviourIn& in, const BehaviourParams& params,
                            Command& command) {
  if (!world_) return Fallback::notLoaded;
  tellLeftOut(printed_.begin(in.input.time));
  reloadIfEdited(params);
  if (!decide_) return Fallback::notLoaded;
  fill(*frame_, in);
  frame_->task = params.task;
  if (framesToRest_ > 0) {
    --framesToRest_;
    return Fallback::timeLimit;
  }
  const Fallback result = call(params, command);
  restAfter(result);
  return result;
}

// A script that does not end takes all its time of every frame, and a match waits for it: it is
// called ever more seldom, from the third time in a row on.
void PythonHost::restAfter(Fallback last) {
  constexpr std::uint32_t kPatience = 2, kMax = 6;  // of 64 frames
  lateInARow_ = last == Fallback::timeLimit ? std::min(lateInARow_ + 1, kPatience + kMax) : 0;
  framesToRest_ = lateInARow_ > kPatience ? 1U << (lateInARow_ - kPatience) : 0;
}

Fallback PythonHost::call(const BehaviourParams& params, Command& command) {
  PythonRef answer;
  {
    const Watchdog watchdog(params.timeLimit, kHungExit);
    const HeapLimit limit(interpreter_->heap(), heapToDecide(params));
    answer = PythonRef(PyObject_CallOneArg(decide_.get(), world_.get()));
  }
  if (!answer) return fail(Fallback::scriptError);
  return read(answer.get(), command);
}

Fallback PythonHost::read(PyObject* answer, Command& command) {
  std::string why;
  const int isCommand = PyObject_IsInstance(answer, commandType_.get());
  if (isCommand != 1) {
    PyErr_Clear();
    why = std::string("decide returned a ") + Py_TYPE(answer)->tp_name + ", not a kelpie.Command";
  } else if (reader_->read(answer, command, why)) {
    if (!broken_) lastError_.clear();
    return Fallback::none;
  }
  const std::string line = modules_.name() + ": " + why;
  report(line, line);
  return Fallback::badCommand;
}

Expected<Rows> PythonHost::ask(const std::string& function) {
  if (!version_) return Error{lastError_};
  PythonRef answer;
  {
    const Watchdog watchdog(kLoadLimit, kHungLoadExit);
    answer = PythonRef(PyObject_CallMethod(version_.get(), "ask", "s", function.c_str()));
  }
  if (answer) return rowsOf(answer.get());
  std::string line, all;
  const PythonRef error = takeError(line, all);
  return Error{line};
}

Fallback PythonHost::fail(Fallback reason) {
  std::string line, all;
  PythonRef error = takeError(line, all);
  report(line, all);
  const PythonRef limit(PyObject_GetAttrString(guard_.get(), "TimeLimit"));
  const bool late = error && limit && PyObject_IsInstance(error.get(), limit.get()) == 1;
  PyErr_Clear();
  if (error && PyErr_GivenExceptionMatches(error.get(), PyExc_MemoryError) != 0) {
    error.reset();  // with what the script had in hand
    PyGC_Collect();
  }
  return late && reason == Fallback::scriptError ? Fallback::timeLimit : reason;
}

// Where a module is missing because its file is gone, the line names the file.
void PythonHost::failLoading() {
  std::string line, all;
  const PythonRef error = takeError(line, all);
  const std::string gone = modules_.goneLine();
  if (error && !gone.empty() &&
      PyErr_GivenExceptionMatches(error.get(), PyExc_ModuleNotFoundError) != 0)
    line = all = gone;
  if (decide_) all += "; the version before plays on";
  report(line, all);
}

PythonRef PythonHost::takeError(std::string& line, std::string& all) {
  PythonRef error = pendingError();
  const PythonRef calm(PyObject_CallMethod(guard_.get(), "calm", nullptr));
  if (!error || !describe(error.get(), line, all)) line = all = modules_.name() + ": unknown error";
  PyErr_Clear();
  return error;
}

bool PythonHost::describe(PyObject* error, std::string& line, std::string& all) {
  const PythonRef texts(PyObject_CallMethod(guard_.get(), "describe", "O", error));
  if (!texts || !PyTuple_Check(texts.get()) || PyTuple_GET_SIZE(texts.get()) != 2) return false;
  line = textOf(PyTuple_GET_ITEM(texts.get(), 0));
  all = textOf(PyTuple_GET_ITEM(texts.get(), 1));
  return true;
}

// Each different error is reported once per loaded version; the same place and kind of error
// with another message ("main.py:3: ValueError: 17") is the same error.
void PythonHost::report(const std::string& line, const std::string& all) {
  lastError_ = line;
  const std::size_t place = line.find(": ");
  const std::size_t kind = place == std::string::npos ? place : line.find(": ", place + 2);
  const std::string start = line.substr(0, kind);
  const bool known =
      std::find(knownErrors_.begin(), knownErrors_.end(), start) != knownErrors_.end();
  if (known || knownErrors_.size() >= kMaxReports) return;
  knownErrors_.push_back(start);
  reports_.add(line, true);
  tell(all);
}

}  // namespace kelpie::behaviour
