// SPDX-License-Identifier: Apache-2.0
// Lets tests/toolchain run code of their own in the image's Python, which must have been started by
// the configuration (Probe.cpp). The code comes compiled and marshalled: the robot has no compiler.
#include "behaviour/PythonRef.h"

// After Python.h, which wants to be first.
#include <algorithm>
#include <cstdint>
#include <cstring>

extern "C" {
#include "behaviour/frozen/Steps.h"
}

namespace {

using kelpie::behaviour::PythonRef;

constexpr std::size_t kLongest = 64U << 10U;  // of an answer, in a buffer of 512 KB

// repr() of what the code leaves as `answer`.
PythonRef answerOf(const std::uint8_t* code, std::uint32_t size) {
  const PythonRef bytes(PyBytes_FromStringAndSize(reinterpret_cast<const char*>(code),
                                                  static_cast<Py_ssize_t>(size)));
  const PythonRef marshal(PyImport_ImportModule("marshal"));
  if (!bytes || !marshal) return PythonRef();
  const PythonRef loaded(PyObject_CallMethod(marshal.get(), "loads", "O", bytes.get()));
  const PythonRef names(PyDict_New());
  if (!loaded || !names) return PythonRef();
  PyDict_SetItemString(names.get(), "__builtins__", PyEval_GetBuiltins());
  const PythonRef done(PyEval_EvalCode(loaded.get(), names.get(), names.get()));
  const PythonRef answer(done ? PyObject_CallMethod(names.get(), "get", "s", "answer") : nullptr);
  return PythonRef(answer ? PyObject_Repr(answer.get()) : nullptr);
}

PythonRef shownError() {
  PyObject* type = nullptr;
  PyObject* value = nullptr;
  PyObject* trace = nullptr;
  PyErr_Fetch(&type, &value, &trace);
  PyErr_NormalizeException(&type, &value, &trace);
  PythonRef shown(value != nullptr ? PyObject_Repr(value) : nullptr);
  Py_XDECREF(type);
  Py_XDECREF(value);
  Py_XDECREF(trace);
  return shown;
}

}  // namespace

extern "C" {

std::uint8_t* kelpieBuffer();

// The code in the buffer; the answer, or the error, is put there again.
std::uint32_t kelpieRun(std::uint32_t size) {
  PythonRef shown = answerOf(kelpieBuffer(), size);
  if (!shown) shown = shownError();
  Py_ssize_t length = 0;
  const char* const text = shown ? PyUnicode_AsUTF8AndSize(shown.get(), &length) : nullptr;
  if (text == nullptr) return 0;
  const std::size_t kept = std::min(static_cast<std::size_t>(length), kLongest);
  std::memcpy(kelpieBuffer(), text, kept);
  return static_cast<std::uint32_t>(kept);
}

std::uint32_t kelpieSteps() { return kelpieStepsTaken(); }
}
