// SPDX-License-Identifier: Apache-2.0
// Everything is inside the program, by the names that toolchain/python-openr/freeze gives; there
// are no files, so nothing is ever edited or gone.
#include "behaviour/Modules.h"

extern "C" {
#include "behaviour/frozen/Steps.h"
}

namespace kelpie::behaviour {

struct Modules::Files {};

Modules::Modules(const std::string& /*scripts*/) : name_(kelpieBehaviours()) {}

Modules::~Modules() = default;

std::vector<std::string> Modules::searchPaths() const { return {}; }

PythonRef Modules::guard() const { return PythonRef(PyImport_ImportModule("guard")); }

PythonRef Modules::kelpie(PyObject* /*guard*/) const {
  return PythonRef(PyImport_ImportModule("kelpie"));
}

PythonRef Modules::load(PyObject* guard, PyObject* kelpie) const {
  const PythonRef finder(PyImport_ImportModule("from_frozen"));
  const PythonRef source(finder ? PyObject_CallMethod(finder.get(), "Frozen", nullptr) : nullptr);
  if (!source) return PythonRef();
  return PythonRef(PyObject_CallMethod(guard, "Version", "OO", source.get(), kelpie));
}

bool Modules::edited() { return false; }

void Modules::keep() {}

std::string Modules::loadedLine() const { return {}; }

std::string Modules::goneLine() const { return {}; }

}  // namespace kelpie::behaviour
