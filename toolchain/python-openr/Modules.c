// SPDX-License-Identifier: Apache-2.0
// What takes the place of the files of CPython that this build leaves out: the tables of built-in
// and of frozen modules, the search for paths (there are none: everything is frozen), the module
// posix (files and processes, which the robot's Python does not have), and the fault handler.
#include <Python.h>

#include "behaviour/frozen/Steps.h"
#include "frozen.h"
#include "pycore_fileutils.h"
#include "pycore_import.h"
#include "pycore_initconfig.h"
#include "pycore_pathconfig.h"
#include "pycore_pylifecycle.h"

extern PyObject* PyInit__abc(void);
extern PyObject* PyInit__ast(void);
extern PyObject* PyInit__codecs(void);
extern PyObject* PyInit__imp(void);
extern PyObject* PyInit__io(void);
extern PyObject* PyInit__signal(void);
extern PyObject* PyInit__string(void);
extern PyObject* PyInit__thread(void);
extern PyObject* PyInit__tokenize(void);
extern PyObject* PyInit__weakref(void);
extern PyObject* _PyWarnings_Init(void);
extern PyObject* PyInit_gc(void);
extern PyObject* PyInit_math(void);
extern PyObject* PyMarshal_Init(void);
static PyObject* initPosix(void);

struct _inittab _PyImport_Inittab[] = {
    {"_abc", PyInit__abc},
    {"_ast", PyInit__ast},
    {"_codecs", PyInit__codecs},
    {"_imp", PyInit__imp},
    {"_io", PyInit__io},
    {"_signal", PyInit__signal},
    {"_string", PyInit__string},
    {"_thread", PyInit__thread},
    {"_tokenize", PyInit__tokenize},
    {"_weakref", PyInit__weakref},
    {"_warnings", _PyWarnings_Init},
    {"builtins", NULL},  // made by the interpreter itself, as is sys
    {"gc", PyInit_gc},
    {"marshal", PyMarshal_Init},
    {"math", PyInit_math},
    {"posix", initPosix},
    {"sys", NULL},
    {NULL, NULL},
};

static const struct _frozen modules[] = {FROZEN_MODULES};
static const struct _frozen none[] = {{NULL, NULL, 0, 0, NULL}};
static const struct _module_alias aliases[] = {
    {"_frozen_importlib", "importlib._bootstrap"},
    {"_frozen_importlib_external", "importlib._bootstrap_external"},
    {NULL, NULL},
};
const struct _frozen* _PyImport_FrozenBootstrap = modules;
const struct _frozen* _PyImport_FrozenStdlib = none;
const struct _frozen* _PyImport_FrozenTest = none;
const struct _frozen* PyImport_FrozenModules = NULL;
const struct _module_alias* _PyImport_FrozenAliases = aliases;

int _Py_Deepfreeze_Init(void) { return 0; }
void _Py_Deepfreeze_Fini(void) {}

// Paths are those that the embedding program gave; nothing is looked for.
PyStatus _PyConfig_InitPathConfig(PyConfig* config, int compute) {
  (void)compute;
  config->module_search_paths_set = 1;
  return _PyStatus_OK();
}

PyStatus _PyFaulthandler_Init(int enable) {
  (void)enable;
  return _PyStatus_OK();
}
void _PyFaulthandler_Fini(void) {}

// importlib wants the module's name, and of its functions only those that look for files.
static PyObject* initPosix(void) {
  static struct PyModuleDef definition = {
      PyModuleDef_HEAD_INIT, "posix", NULL, -1, NULL, NULL, NULL, NULL, NULL};
  PyObject* const module = PyModule_Create(&definition);
  if (module == NULL) return NULL;
  PyObject* const environment = PyDict_New();
  if (environment == NULL || PyModule_AddObject(module, "environ", environment) < 0) return NULL;
  return module;
}

// A path is a text or bytes: no objects stand for paths here.
PyObject* PyOS_FSPath(PyObject* path) {
  if (PyUnicode_Check(path) || PyBytes_Check(path)) return Py_NewRef(path);
  return PyErr_Format(PyExc_TypeError, "a path is a str or bytes, not %.200s",
                      Py_TYPE(path)->tp_name);
}
