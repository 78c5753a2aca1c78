// SPDX-License-Identifier: Apache-2.0
#include "behaviour/interpreter/Interpreter.h"

#include <Python.h>

namespace kelpie::behaviour {
namespace {

// An absolute place that does not exist. Where these are empty or relative, CPython's getpath looks
// for a Python on the machine (cross.md section 2).
constexpr const char* kNowhere = "/aibo";
// Calls within each other. Loading the behaviours takes 26 and deciding 18; the robot's stack has
// room for 80 of the dearest kind (toolchain/openr/calls.txt), and a PC shall play no deeper.
constexpr int kDeepestCalls = 80;

PyStatus setPaths(PyConfig& config, const std::vector<std::string>& searchPaths) {
  wchar_t** const places[] = {
      &config.program_name,     &config.executable,  &config.base_executable,
      &config.prefix,           &config.exec_prefix, &config.base_prefix,
      &config.base_exec_prefix, &config.platlibdir,  &config.home};
  for (wchar_t** place : places) {
    const PyStatus status = PyConfig_SetBytesString(&config, place, kNowhere);
    if (PyStatus_Exception(status)) return status;
  }
  config.module_search_paths_set = 1;
  for (const std::string& path : searchPaths) {
    wchar_t* const wide = Py_DecodeLocale(path.c_str(), nullptr);
    if (wide == nullptr) return PyStatus_Error("a path cannot be decoded");
    const PyStatus status = PyWideStringList_Append(&config.module_search_paths, wide);
    PyMem_RawFree(wide);
    if (PyStatus_Exception(status)) return status;
  }
  return PyStatus_Ok();
}

}  // namespace

Interpreter::Interpreter(const std::vector<std::string>& searchPaths) {
  // Paths are UTF-8 whatever the locale says.
  PyPreConfig before;
  PyPreConfig_InitIsolatedConfig(&before);
  before.utf8_mode = 1;
  Py_PreInitialize(&before);
  heap_.count();
  PyConfig config;
  PyConfig_InitIsolatedConfig(&config);
  config.site_import = 0;
  config.use_hash_seed = 1;
  config.hash_seed = 0;
  config.write_bytecode = 0;
  config.install_signal_handlers = 0;
  config.optimization_level = 2;
  config.pathconfig_warnings = 0;
  PyStatus status = setPaths(config, searchPaths);
  if (!PyStatus_Exception(status)) status = Py_InitializeFromConfig(&config);
  PyConfig_Clear(&config);
  if (!PyStatus_Exception(status)) {
    Py_SetRecursionLimit(kDeepestCalls);
    return;
  }
  error_ = "Python did not start: ";
  error_ += status.err_msg != nullptr ? status.err_msg : "no reason given";
}

Interpreter::~Interpreter() {
  if (error_.empty()) Py_FinalizeEx();
}

}  // namespace kelpie::behaviour
