/* SPDX-License-Identifier: Apache-2.0
 * The configuration as C++ sees it: the C++ library's headers bring the types of threads, so that
 * CPython's own must not come as well. None of them is in what C++ calls.
 */
#pragma once

#include "../pyconfig.h"

#undef HAVE_PTHREAD_STUBS
#define HAVE_PTHREAD_H 1
#undef __have_pthread_attr_t
#undef _BITS_SIGTHREAD_H
