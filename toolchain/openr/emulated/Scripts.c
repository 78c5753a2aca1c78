// SPDX-License-Identifier: Apache-2.0
// Lets tests/toolchain run code of their own in the image's Python, which must have been started by
// the configuration (Probe.cpp). The code comes compiled and marshalled, as all code of the robot.
// References are given back where everything went well; a test's error may keep one.
#include <Python.h>

#include "behaviour/frozen/Steps.h"

enum { kLongest = 64 << 10 };  // of an answer, in a buffer of 512 KB

uint8_t* kelpieBuffer(void);

static PyObject* loaded(uint32_t size) {
  PyObject* const marshal = PyImport_ImportModule("marshal");
  if (marshal == NULL) return NULL;
  const char* const bytes = (const char*)kelpieBuffer();
  PyObject* const code =
      PyObject_CallMethod(marshal, "loads", "N", PyBytes_FromStringAndSize(bytes, (int)size));
  Py_DECREF(marshal);
  return code;
}

// repr() of what the code leaves as `answer`.
static PyObject* answerOf(PyObject* code) {
  PyObject* const names = PyDict_New();
  if (code == NULL || names == NULL) return NULL;
  PyDict_SetItemString(names, "__builtins__", PyEval_GetBuiltins());
  PyObject* const done = PyEval_EvalCode(code, names, names);
  if (done == NULL) return NULL;
  PyObject* const answer = PyObject_CallMethod(names, "get", "s", "answer");
  PyObject* const shown = answer != NULL ? PyObject_Repr(answer) : NULL;
  Py_XDECREF(answer);
  Py_DECREF(done);
  Py_DECREF(names);
  return shown;
}

static PyObject* shownError(void) {
  PyObject *type, *value, *trace;
  PyErr_Fetch(&type, &value, &trace);
  PyErr_NormalizeException(&type, &value, &trace);
  return value != NULL ? PyObject_Repr(value) : NULL;
}

// The code in the buffer; the answer, or the error, is put there again.
uint32_t kelpieRun(uint32_t size) {
  PyObject* const code = loaded(size);
  PyObject* shown = answerOf(code);
  if (shown == NULL) shown = shownError();
  Py_XDECREF(code);
  Py_ssize_t length = 0;
  const char* const text = shown != NULL ? PyUnicode_AsUTF8AndSize(shown, &length) : NULL;
  if (text == NULL) return 0;
  if (length > kLongest) length = kLongest;
  memcpy(kelpieBuffer(), text, (size_t)length);
  Py_DECREF(shown);
  return (uint32_t)length;
}

uint32_t kelpieSteps(void) { return kelpieStepsTaken(); }
