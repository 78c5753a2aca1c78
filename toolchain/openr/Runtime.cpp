// SPDX-License-Identifier: Apache-2.0
// What C++17 code wants of its library and the SDK has not: memory from malloc, and an end for what
// cannot go on. Without exceptions that is a break instruction, which the robot writes to EMON.LOG
// with its address.
#include <cstdlib>
#include <new>

namespace {

[[noreturn]] void stop() { __builtin_trap(); }

void* allocate(std::size_t size) {
  void* const memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) stop();
  return memory;
}

}  // namespace

// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming): the library's names
namespace std {

const nothrow_t nothrow{};

void __throw_logic_error(const char* /*what*/) { stop(); }
void __throw_length_error(const char* /*what*/) { stop(); }
void __throw_bad_alloc() { stop(); }
void __throw_bad_array_new_length() { stop(); }
void __throw_out_of_range_fmt(const char* /*what*/, ...) { stop(); }
void __throw_bad_function_call() { stop(); }

}  // namespace std

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void* operator new(std::size_t size, const std::nothrow_t& /*none*/) noexcept {
  return std::malloc(size == 0 ? 1 : size);
}
void* operator new[](std::size_t size, const std::nothrow_t& /*none*/) noexcept {
  return std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*size*/) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t /*size*/) noexcept { std::free(memory); }

extern "C" void __cxa_pure_virtual() { stop(); }
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)
