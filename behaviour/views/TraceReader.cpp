// SPDX-License-Identifier: Apache-2.0
#include "behaviour/views/TraceReader.h"

#include <algorithm>
#include <cmath>

#include "robot/core/Maths.h"

namespace kelpie::behaviour {
namespace {

constexpr Py_ssize_t kTexts = 4;  // elements before the numbers: the layer and three texts
constexpr double kMax = 1e6;      // of the field list

std::string kindOf(PyObject* object) { return std::string(" is a ") + Py_TYPE(object)->tp_name; }

bool readLayer(PyObject* object, TraceLayer& layer, std::string& why) {
  if (!PyLong_Check(object)) {
    why = ".layer" + kindOf(object) + ", not a whole number";
    return false;
  }
  int beyond = 0;  // -1 or 1 where it does not even fit a long
  const long number = PyLong_AsLongAndOverflow(object, &beyond);
  const long max = kTraceLayerCount - 1;
  const long nearest = beyond < 0 ? 0 : max;
  layer = static_cast<TraceLayer>(beyond != 0 ? nearest : std::clamp(number, 0L, max));
  return true;
}

template <std::size_t N>
bool readText(PyObject* object, Text<N>& text, const char* name, std::string& why) {
  Py_ssize_t size = 0;
  const char* bytes = PyUnicode_Check(object) ? PyUnicode_AsUTF8AndSize(object, &size) : nullptr;
  if (bytes == nullptr) {
    PyErr_Clear();  // half of a surrogate pair is a str, but no UTF-8
    why = std::string(".") + name + kindOf(object) + ", not a text";
    return false;
  }
  text.assign({bytes, static_cast<std::size_t>(size)});
  return true;
}

bool readNumber(PyObject* object, double& number, std::string& why) {
  if (!PyFloat_Check(object) && !PyLong_Check(object)) {
    why = kindOf(object) + ", not a number";
    return false;
  }
  number = PyFloat_AsDouble(object);
  if (PyErr_Occurred() != nullptr || std::isnan(number)) {
    PyErr_Clear();
    why = " is not a number";
    return false;
  }
  number = maths::clamp(number, -kMax, kMax);
  return true;
}

bool readNumbers(PyObject* tuple, TraceStep& step, std::string& why) {
  step.numbers.resize(static_cast<std::size_t>(PyTuple_GET_SIZE(tuple) - kTexts));
  for (std::size_t i = 0; i < step.numbers.size(); ++i) {
    PyObject* const object = PyTuple_GET_ITEM(tuple, kTexts + static_cast<Py_ssize_t>(i));
    if (readNumber(object, step.numbers[i], why)) continue;
    why.insert(0, ".numbers[" + std::to_string(i) + "]");
    return false;
  }
  return true;
}

bool readStep(PyObject* object, TraceStep& step, std::string& why) {
  if (!PyTuple_Check(object) || PyTuple_GET_SIZE(object) < kTexts) {
    why = (PyTuple_Check(object) ? " is too short" : kindOf(object)) +
          ", not a tuple (layer, module, branch, reason, number...)";
    return false;
  }
  return readLayer(PyTuple_GET_ITEM(object, 0), step.layer, why) &&
         readText(PyTuple_GET_ITEM(object, 1), step.module, "module", why) &&
         readText(PyTuple_GET_ITEM(object, 2), step.branch, "branch", why) &&
         readText(PyTuple_GET_ITEM(object, 3), step.reason, "reason", why) &&
         readNumbers(object, step, why);
}

}  // namespace

bool readTrace(PyObject* object, Trace& trace, std::string& why) {
  if (!PyList_Check(object)) {
    why = kindOf(object) + ", not a list";
    return false;
  }
  trace.resize(static_cast<std::size_t>(PyList_GET_SIZE(object)));
  for (std::size_t i = 0; i < trace.size(); ++i) {
    if (readStep(PyList_GET_ITEM(object, static_cast<Py_ssize_t>(i)), trace[i], why)) continue;
    why.insert(0, "[" + std::to_string(i) + "]");
    return false;
  }
  return true;
}

}  // namespace kelpie::behaviour
