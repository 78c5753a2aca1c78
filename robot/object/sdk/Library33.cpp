// SPDX-License-Identifier: Apache-2.0
// What the SDK's archives want of its own C++ library of 2003 (openr.md 3.5), so that this library
// need not be linked beside ours: streams that print nothing, its allocator by malloc, and the
// tables of run-time types, which nobody looks at. Only for the final link.
#include <cstdlib>

extern "C" {

extern void* const kelpieCout[64] __asm__("_ZSt4cout");
void* const kelpieCout[64] = {};
extern void* const kelpieCerr[64] __asm__("_ZSt4cerr");
void* const kelpieCerr[64] = {};
extern void* const kelpieClassType[16] __asm__("_ZTVN10__cxxabiv117__class_type_infoE");
void* const kelpieClassType[16] = {};
extern void* const kelpieDerivedType[16] __asm__("_ZTVN10__cxxabiv120__si_class_type_infoE");
void* const kelpieDerivedType[16] = {};

void* kelpiePrintText(void* stream, const char* text) __asm__(
    "_ZStlsISt11char_traitsIcEERSt13basic_ostreamIcT_ES5_PKc");
void* kelpiePrintText(void* stream, const char* /*text*/) { return stream; }
void* kelpiePrintLong(void* stream, long value) __asm__("_ZNSolsEl");
void* kelpiePrintLong(void* stream, long /*value*/) { return stream; }
void* kelpiePrintUnsigned(void* stream, unsigned long value) __asm__("_ZNSolsEm");
void* kelpiePrintUnsigned(void* stream, unsigned long /*value*/) { return stream; }
void* kelpiePrintAddress(void* stream, const void* value) __asm__("_ZNSolsEPKv");
void* kelpiePrintAddress(void* stream, const void* /*value*/) { return stream; }
void* kelpieManipulate(void* stream, void* (*change)(void*)) __asm__("_ZNSolsEPFRSoS_E");
void* kelpieManipulate(void* stream, void* (* /*change*/)(void*)) { return stream; }
void* kelpieEndLine(void* stream) __asm__(
    "_ZSt4endlIcSt11char_traitsIcEERSt13basic_ostreamIT_T0_ES6_");
void* kelpieEndLine(void* stream) { return stream; }
void kelpieStreamsBegin(void* self) __asm__("_ZNSt8ios_base4InitC1Ev");
void kelpieStreamsBegin(void* /*self*/) {}
void kelpieStreamsEnd(void* self) __asm__("_ZNSt8ios_base4InitD1Ev");
void kelpieStreamsEnd(void* /*self*/) {}

void* kelpieAllocate(unsigned size) __asm__("_ZNSt24__default_alloc_templateILb1ELi0EE8allocateEj");
void* kelpieAllocate(unsigned size) { return std::malloc(size); }
void kelpieDeallocate(void* memory, unsigned size) __asm__(
    "_ZNSt24__default_alloc_templateILb1ELi0EE10deallocateEPvj");
void kelpieDeallocate(void* memory, unsigned /*size*/) { std::free(memory); }

// No exception is ever thrown.
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming): libgcc's name
void __gxx_personality_v0() { __builtin_trap(); }
}
