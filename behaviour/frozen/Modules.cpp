// SPDX-License-Identifier: Apache-2.0
// The robot's: Python's own modules are inside the program, and so are behaviours, by the names
// that toolchain/python-openr/freeze gives. With a path to a zip, which a memory stick has, that
// one's behaviours play. It is read once; nothing is edited or gone while a robot plays.
#include "behaviour/interpreter/Modules.h"

#include <cstdio>

namespace kelpie::behaviour {
namespace {

constexpr Py_ssize_t kCapacity = 704 << 10;  // bytes; a zip of today takes 600 KB
constexpr std::size_t kBlock = 64 << 10;     // bytes that the C library asks the system for at once

// All of an open file as Python's bytes. Null, with an error set: no memory.
PythonRef bytesOf(std::FILE* file) {
  PyObject* bytes = PyBytes_FromStringAndSize(nullptr, kCapacity);
  Py_ssize_t size = 0;
  while (bytes != nullptr) {
    const auto room = static_cast<std::size_t>(PyBytes_GET_SIZE(bytes) - size);
    const std::size_t got = std::fread(PyBytes_AS_STRING(bytes) + size, 1, room, file);
    size += static_cast<Py_ssize_t>(got);
    if (got == 0) break;
    if (got == room) _PyBytes_Resize(&bytes, size + size / 4);
  }
  if (bytes != nullptr) _PyBytes_Resize(&bytes, size);
  return PythonRef(bytes);
}

// Null, with an error set, when it cannot be read.
PythonRef bytesOf(const std::string& path) {
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) {
    PyErr_Format(PyExc_ImportError, "%s cannot be opened", path.c_str());
    return PythonRef();
  }
  std::setvbuf(file, nullptr, _IOFBF, kBlock);
  PythonRef bytes = bytesOf(file);
  const bool failed = std::ferror(file) != 0;
  std::fclose(file);
  if (!failed) return bytes;
  PyErr_Format(PyExc_ImportError, "%s cannot be read", path.c_str());
  return PythonRef();
}

PythonRef called(const char* module, const char* name, PyObject* argument) {
  const PythonRef owner(PyImport_ImportModule(module));
  const PythonRef function(owner ? PyObject_GetAttrString(owner.get(), name) : nullptr);
  if (!function) return PythonRef();
  return PythonRef(argument != nullptr ? PyObject_CallOneArg(function.get(), argument)
                                       : PyObject_CallNoArgs(function.get()));
}

PythonRef sourceOf(const std::string& scripts) {
  if (scripts.empty()) return called("from_frozen", "Frozen", nullptr);
  const PythonRef bytes = bytesOf(scripts);
  return bytes ? called("from_zip", "Zip", bytes.get()) : PythonRef();
}

}  // namespace

struct Modules::Files {
  std::string scripts;  // nothing: the behaviours inside play
};

Modules::Modules(const std::string& scripts)
    : name_(scripts.empty() ? "behaviours" : scripts), files_(std::make_unique<Files>()) {
  files_->scripts = scripts;
}

Modules::~Modules() = default;

std::vector<std::string> Modules::searchPaths() const { return {}; }

PythonRef Modules::guard() const { return PythonRef(PyImport_ImportModule("guard")); }

PythonRef Modules::kelpie(PyObject* /*guard*/) const {
  return PythonRef(PyImport_ImportModule("kelpie"));
}

PythonRef Modules::load(PyObject* guard, PyObject* kelpie) const {
  const PythonRef source = sourceOf(files_->scripts);
  if (!source) return PythonRef();
  return PythonRef(PyObject_CallMethod(guard, "Version", "OO", source.get(), kelpie));
}

bool Modules::edited() { return false; }

void Modules::keep() {}

std::string Modules::loadedLine() const { return {}; }

std::string Modules::goneLine() const { return {}; }

}  // namespace kelpie::behaviour
