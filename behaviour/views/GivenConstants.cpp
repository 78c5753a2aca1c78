// SPDX-License-Identifier: Apache-2.0
#include "behaviour/views/GivenConstants.h"

#include <type_traits>

#include "behaviour/views/PythonNames.h"

namespace kelpie::behaviour {
namespace {

PythonRef attribute(PyObject* owner, const char* name) {
  return PythonRef(owner != nullptr ? PyObject_GetAttrString(owner, name) : nullptr);
}

template <class T>
PythonRef pythonNumber(T value) {
  if constexpr (std::is_integral_v<T>) return PythonRef(PyLong_FromUnsignedLong(value));
  return PythonRef(PyFloat_FromDouble(static_cast<double>(value)));
}

template <class Group>
bool give(PyObject* object, const Group& group) {
  bool good = object != nullptr;
  forEachField(group, [&](const auto& f, const auto& value) {
    const PythonRef number(pythonNumber(value));
    const std::string name = pythonName<std::decay_t<decltype(value)>>(f.name, f.unit);
    good = good && number && PyObject_SetAttrString(object, name.c_str(), number.get()) == 0;
  });
  return good;
}

}  // namespace

bool giveConstants(PyObject* kelpie, const Constants& constants) {
  const PythonRef all = attribute(kelpie, "constants");
  bool good = static_cast<bool>(all);
  forEachField(constants, [&](const auto& f, const auto& group) {
    good = good && give(attribute(all.get(), snakeCase(f.name).c_str()).get(), group);
  });
  return good;
}

}  // namespace kelpie::behaviour
