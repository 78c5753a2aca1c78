// SPDX-License-Identifier: Apache-2.0
// The door through which the emulator drives the interpreter alone: start it, and run a text that
// is given in a buffer. Answers stand in the same buffer.
#include <Python.h>
#include <stdint.h>

enum { kBufferBytes = 512 << 10 };
static char buffer[kBufferBytes] __attribute__((aligned(8)));

char* kelpieText(void) { return buffer; }

static uint32_t answer(const char* text) {
  const size_t size = strlen(text);
  memcpy(buffer, text, size < kBufferBytes ? size : kBufferBytes);
  return size;
}

static PyStatus start(void) {
  PyPreConfig before;
  PyPreConfig_InitIsolatedConfig(&before);
  before.utf8_mode = 1;
  PyStatus status = Py_PreInitialize(&before);
  if (PyStatus_Exception(status)) return status;
  PyConfig config;
  PyConfig_InitIsolatedConfig(&config);
  config.site_import = 0;
  config.use_hash_seed = 1;
  config.hash_seed = 0;
  config.write_bytecode = 0;
  config.install_signal_handlers = 0;
  config.optimization_level = 2;
  config.module_search_paths_set = 1;
  status = Py_InitializeFromConfig(&config);
  PyConfig_Clear(&config);
  return status;
}

// repr() of the pending error.
static uint32_t answerError(void) {
  PyObject *type, *value, *trace;
  PyErr_Fetch(&type, &value, &trace);
  PyErr_NormalizeException(&type, &value, &trace);
  PyObject* const shown = PyObject_Repr(value);
  return answer(shown != NULL ? PyUnicode_AsUTF8(shown) : "an error that cannot be shown");
}

// What went wrong, or nothing.
uint32_t kelpieStart(uint32_t unused) {
  (void)unused;
  const PyStatus status = start();
  if (!PyStatus_Exception(status)) return 0;
  if (_PyThreadState_UncheckedGet() != NULL && PyErr_Occurred()) return answerError();
  return answer(status.err_msg != NULL ? status.err_msg : "no reason given");
}

// Runs the text in a namespace that stays, and answers repr() of what it leaves as `answer`.
uint32_t kelpieRun(uint32_t size) {
  static PyObject* names;
  if (size >= kBufferBytes) return answer("the text is too long");
  buffer[size] = '\0';
  if (names == NULL) {
    names = PyDict_New();
    PyDict_SetItemString(names, "__builtins__", PyEval_GetBuiltins());
  }
  PyObject* const done = PyRun_String(buffer, Py_file_input, names, names);
  if (done == NULL) return answerError();
  PyObject* const shown = PyObject_Repr(PyDict_GetItemString(names, "answer"));
  return answer(shown != NULL ? PyUnicode_AsUTF8(shown) : "no answer");
}
