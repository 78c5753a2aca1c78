// SPDX-License-Identifier: Apache-2.0
// An owned reference to a Python object.
#pragma once

#include <Python.h>

#include <utility>

namespace kelpie::behaviour {

class PythonRef {
 public:
  PythonRef() = default;
  explicit PythonRef(PyObject* owned) : object_(owned) {}
  PythonRef(PythonRef&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  PythonRef& operator=(PythonRef&& other) noexcept {
    std::swap(object_, other.object_);
    return *this;
  }
  PythonRef(const PythonRef&) = delete;
  PythonRef& operator=(const PythonRef&) = delete;
  ~PythonRef() { Py_XDECREF(object_); }

  PyObject* get() const { return object_; }
  explicit operator bool() const { return object_ != nullptr; }
  void reset() { Py_CLEAR(object_); }

 private:
  PyObject* object_ = nullptr;
};

}  // namespace kelpie::behaviour
