// SPDX-License-Identifier: Apache-2.0
#include "behaviour/views/CommandReader.h"

#include <cmath>
#include <string_view>

#include "behaviour/views/PythonNames.h"
#include "behaviour/views/TraceReader.h"

namespace kelpie::behaviour {
namespace {

struct Limits {
  const char* unit;
  double min;
  double max;
};

bool readNumber(PyObject* object, double& value, std::string& why) {
  if (!PyFloat_Check(object) && !PyLong_Check(object)) {
    why = std::string(" is a ") + Py_TYPE(object)->tp_name + ", not a number";
    return false;
  }
  value = PyFloat_AsDouble(object);
  if (PyErr_Occurred() != nullptr || !std::isfinite(value)) {
    PyErr_Clear();
    why = " is not finite";
    return false;
  }
  return true;
}

// The fallback is for the host to set, not for the script.
template <class Member>
constexpr bool kOfScript = !std::is_same_v<Member, Fallback>;

template <class T>
void addNames(const T& sample, std::vector<PythonRef>& names) {
  forEachField(sample, [&](const auto& f, const auto& member) {
    using Member = std::decay_t<decltype(member)>;
    if (!kOfScript<Member>) return;
    const std::string name = pythonName<Member>(f.name, f.unit);
    names.emplace_back(PyUnicode_InternFromString(name.c_str()));
    if constexpr (HasFields<Member>::value) addNames(member, names);
  });
}

// Goes through the names in the order in which addNames() made them; the first failure ends it.
using NextName = std::vector<PythonRef>::const_iterator;

template <class T>
bool read(PyObject* object, T& value, const Limits& limits, NextName& next, std::string& why);

template <class T>
bool readStruct(PyObject* object, T& value, NextName& next, std::string& why) {
  bool good = true;
  forEachField(value, [&](const auto& f, auto& member) {
    using Member = std::decay_t<decltype(member)>;
    if (!good || !kOfScript<Member>) return;
    PyObject* const name = (next++)->get();
    const PythonRef attribute(PyObject_GetAttr(object, name));
    if (attribute) {
      good = read(attribute.get(), member, Limits{f.unit, f.min, f.max}, next, why);
    } else {
      PyErr_Clear();
      good = false;
      why = " is missing";
    }
    if (!good) why = "." + pythonName<Member>(f.name, f.unit) + why;
  });
  return good;
}

template <class T>
bool readInteger(PyObject* object, T& value, const Limits& limits, std::string& why) {
  if (!PyLong_Check(object)) {
    why = std::string(" is a ") + Py_TYPE(object)->tp_name + ", not a whole number";
    return false;
  }
  double number = 0.0;
  if (!readNumber(object, number, why)) return false;
  constexpr double kMax = sizeof(T) == 1 ? 255.0 : 4294967295.0;
  number = maths::clamp(number, std::max(limits.min, 0.0), std::min(limits.max, kMax));
  value = static_cast<T>(static_cast<std::uint32_t>(number));
  return true;
}

template <class T>
bool read(PyObject* object, T& value, const Limits& limits, NextName& next, std::string& why) {
  if constexpr (std::is_same_v<T, Trace>) {
    return readTrace(object, value, why);
  } else if constexpr (HasFields<T>::value) {
    return readStruct(object, value, next, why);
  } else if constexpr (std::is_same_v<T, bool>) {
    const int truth = PyBool_Check(object) ? PyObject_IsTrue(object) : -1;
    if (truth < 0) why = std::string(" is a ") + Py_TYPE(object)->tp_name + ", not a bool";
    value = truth == 1;
    return truth >= 0;
  } else if constexpr (std::is_enum_v<T> || std::is_integral_v<T>) {
    return readInteger(object, value, limits, why);
  } else {
    double number = 0.0;
    if (!readNumber(object, number, why)) return false;
    if constexpr (std::is_same_v<T, Angle>) {
      value = Angle::deg(maths::clamp(number, limits.min, limits.max));
    } else {
      value = maths::clamp(number / shownFactor(limits.unit), limits.min, limits.max);
    }
    return true;
  }
}

}  // namespace

CommandReader::CommandReader() { addNames(Command{}, names_); }

bool CommandReader::read(PyObject* object, Command& command, std::string& why) const {
  NextName next = names_.begin();
  if (readStruct(object, command, next, why)) return true;
  why = "Command" + why;
  return false;
}

}  // namespace kelpie::behaviour
