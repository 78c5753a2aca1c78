/* SPDX-License-Identifier: Apache-2.0
 * What CPython 3.11 may count on where there is no operating system to speak of: o32 MIPS, little
 * endian, C and maths, one thread, and neither files, signals, processes nor locales. Takes the
 * place of the file that CPython's configure makes. What is not defined here is not used.
 * Fails at compile time where a size differs.
 */
#pragma once

#define SIZEOF__BOOL 1
#define SIZEOF_SHORT 2
#define SIZEOF_INT 4
#define SIZEOF_LONG 4
#define SIZEOF_LONG_LONG 8
#define SIZEOF_FLOAT 4
#define SIZEOF_DOUBLE 8
#define SIZEOF_LONG_DOUBLE 8
#define SIZEOF_VOID_P 4
#define SIZEOF_SIZE_T 4
#define SIZEOF_UINTPTR_T 4
#define SIZEOF_WCHAR_T 4
#define SIZEOF_TIME_T 4
#define SIZEOF_OFF_T 4
#define SIZEOF_FPOS_T 4
#define SIZEOF_PID_T 4
#define ALIGNOF_LONG 4
#define ALIGNOF_SIZE_T 4
#define ALIGNOF_MAX_ALIGN_T 8
#define DOUBLE_IS_LITTLE_ENDIAN_IEEE754 1
#define STDC_HEADERS 1
#define HAVE_STDARG_PROTOTYPES 1
#define HAVE_PROTOTYPES 1
#define HAVE_STD_ATOMIC 1
#define HAVE_BUILTIN_ATOMIC 1
#define HAVE_WCHAR_H 1
#define HAVE_ERRNO_H 1
#define HAVE_FCNTL_H 1
#define HAVE_SIGNAL_H 1
#define HAVE_STDINT_H 1
#define HAVE_SYS_STAT_H 1
#define HAVE_SYS_TIME_H 1
#define HAVE_SYS_TYPES_H 1
#define HAVE_UNISTD_H 1
#define TIME_WITH_SYS_TIME 1

/* One thread: CPython's own empty locks (Python/thread_pthread_stubs.h). */
#define HAVE_PTHREAD_STUBS 1

/* The headers are glibc's, which would define the types of threads once more. */
#define __have_pthread_attr_t 1
#define _BITS_SIGTHREAD_H 1

#define HAVE_LANGINFO_H 1 /* only its name CODESET; the answer is ASCII's (System.c) */
#define _PYTHONFRAMEWORK ""

#define HAVE_CLOCK_GETTIME 1
#define HAVE_GETTIMEOFDAY 1
#define HAVE_STRFTIME 1
#define HAVE_ACOSH 1
#define HAVE_ASINH 1
#define HAVE_ATANH 1
#define HAVE_ERF 1
#define HAVE_ERFC 1
#define HAVE_EXPM1 1
#define HAVE_LOG1P 1
#define HAVE_LOG2 1
#define HAVE_COPYSIGN 1
#define HAVE_ROUND 1
#define HAVE_HYPOT 1
#define HAVE_DECL_ISFINITE 1
#define HAVE_DECL_ISINF 1
#define HAVE_DECL_ISNAN 1

#define WITH_PYMALLOC 1
#define RETSIGTYPE void
#define PLATLIBDIR "lib"
#define PLATFORM "aperios"
