/* SPDX-License-Identifier: Apache-2.0
 * The interpreter's own clock where there is no other: it counts a step at each way back in a loop,
 * each call of a function of C, each return from one of Python and each digit of a large product,
 * so that a script that does not end is stopped at the same place in every run. Also the memory
 * that stands for standard error, and what the interpreter has of the system's. They are in
 * toolchain/python-openr (Steps.c, libc/System.c, Heap.c).
 */
#pragma once

#include <stddef.h>
#include <stdint.h>

/* Raises SIGVTALRM after so many steps, and then again after each `again`; 0 ends the counting. */
void kelpieLimitSteps(uint32_t steps, uint32_t again);
uint32_t kelpieStepsTaken(void);    /* since the start, modulo 2^32 */
size_t kelpieHeapUsed(void);        /* bytes that were asked for and not given back */
void kelpieLimitHeap(size_t bytes); /* no more than so many; a larger request gets nothing */
void kelpieTell(const char* text, size_t size);
