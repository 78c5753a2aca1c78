// SPDX-License-Identifier: Apache-2.0
#include "behaviour/interpreter/Modules.h"

#include <filesystem>

#include "behaviour/interpreter/Guard.h"
#include "behaviour/interpreter/Sources.h"
#include "behaviour/views/KelpieModule.h"

namespace kelpie::behaviour {
namespace {

std::string absolute(const std::string& path) {
  std::error_code error;
  const auto whole = std::filesystem::absolute(path, error).lexically_normal().string();
  return error ? path : whole;
}

}  // namespace

struct Modules::Files {
  SourceStamps seen;    // at the last look
  SourceStamps loaded;  // of the version that plays
  SourceChanges changes;
};

Modules::Modules(const std::string& scripts)
    : name_(absolute(scripts)), files_(std::make_unique<Files>()) {
  files_->seen = sourceStamps(name_);
}

Modules::~Modules() = default;

std::vector<std::string> Modules::searchPaths() const {
  std::vector<std::string> paths;
  for (const std::string& path :
       {std::string(KELPIE_PYTHON_STDLIB), isZip(name_) ? name_ : std::string()})
    if (!path.empty()) paths.push_back(path);
  return paths;
}

PythonRef Modules::guard() const {
  PythonRef guard(PyModule_New("guard"));
  PyObject* names = guard ? PyModule_GetDict(guard.get()) : nullptr;
  if (names == nullptr) return PythonRef();
  PyDict_SetItemString(names, "__builtins__", PyEval_GetBuiltins());
  const PythonRef code(Py_CompileString(guardText(), "<guard>", Py_file_input));
  const PythonRef ran(code ? PyEval_EvalCode(code.get(), names, names) : nullptr);
  return ran ? std::move(guard) : PythonRef();
}

PythonRef Modules::kelpie(PyObject* guard) const {
  return PythonRef(PyObject_CallMethod(guard, "make_kelpie", "s", kelpieModuleText().c_str()));
}

PythonRef Modules::load(PyObject* guard, PyObject* kelpie) const {
  PyObject* const zip = isZip(name_) ? Py_True : Py_False;
  return PythonRef(PyObject_CallMethod(guard, "load", "sOO", name_.c_str(), zip, kelpie));
}

bool Modules::edited() {
  SourceStamps now = sourceStamps(name_);
  if (now == files_->seen) return false;
  files_->changes = changesBetween(files_->seen, now);
  files_->seen = std::move(now);
  return true;
}

void Modules::keep() { files_->loaded = files_->seen; }

std::string Modules::loadedLine() const {
  const SourceChanges& changes = files_->changes;
  const std::string gone = changes.gone.empty() ? "" : listed(changes.gone) + ": gone; ";
  const std::string what = changes.edited.empty() ? "the rest" : listed(changes.edited);
  return gone + what + ": loaded again";
}

std::string Modules::goneLine() const {
  const auto gone = changesBetween(files_->loaded, files_->seen).gone;
  return gone.empty() ? "" : listed(gone) + ": gone";
}

}  // namespace kelpie::behaviour
