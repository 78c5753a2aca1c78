// SPDX-License-Identifier: Apache-2.0
// Where Python's modules come from: the guard, `kelpie` and the behaviours. A program links one of
// two: Modules.cpp takes the behaviours from a folder or a zip and notices edits,
// frozen/Modules.cpp has all of them inside the program. Keeps of the files what it needs to notice
// an edit.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "behaviour/PythonRef.h"

namespace kelpie::behaviour {

class Modules {
 public:
  explicit Modules(const std::string& scripts);
  ~Modules();
  Modules(const Modules&) = delete;
  Modules& operator=(const Modules&) = delete;

  const std::string& name() const { return name_; }  // what an error without a place names
  std::vector<std::string> searchPaths() const;      // where the interpreter finds `encodings`

  // Each is null, with a Python error set, on failure.
  PythonRef guard() const;                                  // guard.py, run
  PythonRef kelpie(PyObject* guard) const;                  // the module `kelpie`
  PythonRef load(PyObject* guard, PyObject* kelpie) const;  // a new Version of the guard

  bool edited();                   // whether a file is another than at the last look
  void keep();                     // the version that was loaded last is the one that plays
  std::string loadedLine() const;  // "a.py, b.py: loaded again", of the edit noticed last
  std::string goneLine() const;    // "a.py: gone", of files of the version that plays; or nothing

 private:
  struct Files;

  std::string name_;
  std::unique_ptr<Files> files_;
};

}  // namespace kelpie::behaviour
