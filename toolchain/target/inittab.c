// SPDX-License-Identifier: Apache-2.0
// The modules built into the target's Python, in place of the table in libpython3.11.a: what the
// interpreter and zipimport need to start, what behaviour/interpreter/guard.py and tracebacks use,
// and math. Leaving out the rest (unicodedata alone is 1.1 MB) is what makes the program fit the
// stick. zlib is not needed: the zip with the behaviours is stored, not deflated.

struct _object;
typedef struct _object* InitFunction(void);

// As in CPython's Include/cpython/import.h; Python.h itself belongs to behaviour/ alone.
struct _inittab {
  const char* name;
  InitFunction* initfunc;
};

extern InitFunction PyInit__abc, PyInit__ast, PyInit__codecs, PyInit__collections;
extern InitFunction PyInit__functools, PyInit__imp, PyInit__io, PyInit__locale, PyInit__operator;
extern InitFunction PyInit__signal, PyInit__sre, PyInit__stat, PyInit__string, PyInit__symtable;
extern InitFunction PyInit__thread, PyInit__tokenize, PyInit__weakref, _PyWarnings_Init;
extern InitFunction PyInit_atexit, PyInit_errno, PyInit_faulthandler, PyInit_gc, PyInit_itertools;
extern InitFunction PyInit_math, PyInit_posix, PyInit_time, PyMarshal_Init;

struct _inittab _PyImport_Inittab[] = {
    {"_abc", PyInit__abc},
    {"_ast", PyInit__ast},
    {"_codecs", PyInit__codecs},
    {"_collections", PyInit__collections},
    {"_functools", PyInit__functools},
    {"_imp", PyInit__imp},
    {"_io", PyInit__io},
    {"_locale", PyInit__locale},
    {"_operator", PyInit__operator},
    {"_signal", PyInit__signal},
    {"_sre", PyInit__sre},
    {"_stat", PyInit__stat},
    {"_string", PyInit__string},
    {"_symtable", PyInit__symtable},
    {"_thread", PyInit__thread},
    {"_tokenize", PyInit__tokenize},
    {"_warnings", _PyWarnings_Init},
    {"_weakref", PyInit__weakref},
    {"atexit", PyInit_atexit},
    {"builtins", 0},  // made by the interpreter itself, as is sys
    {"errno", PyInit_errno},
    {"faulthandler", PyInit_faulthandler},
    {"gc", PyInit_gc},
    {"itertools", PyInit_itertools},
    {"marshal", PyMarshal_Init},
    {"math", PyInit_math},
    {"posix", PyInit_posix},
    {"sys", 0},
    {"time", PyInit_time},
    {0, 0},
};
