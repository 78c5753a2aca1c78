// SPDX-License-Identifier: Apache-2.0
// A FixedVector for a step's own lists, which live for one call: what lies beyond size() is not
// set. To fill and to reset what nobody reads took 2 % of a camera frame, and put out of the caches
// what is read. Not for what is recorded, replayed or kept: two equal ones may differ in bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>

namespace kelpie {

template <class T, std::size_t Capacity>
class ScratchVector {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  using value_type = T;
  static constexpr std::size_t kCapacity = Capacity;

  bool push_back(const T& value) {
    if (size_ == Capacity) return false;
    new (at(size_++)) T(value);
    return true;
  }
  void clear() { size_ = 0; }
  // Shrinks or grows with default values; clipped to the capacity.
  void resize(std::size_t size) {
    const std::size_t wanted = size < Capacity ? size : Capacity;
    for (std::size_t i = size_; i < wanted; ++i) new (at(i)) T{};
    size_ = static_cast<std::uint32_t>(wanted);
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  bool full() const { return size_ == Capacity; }
  T& operator[](std::size_t i) { return begin()[i]; }
  const T& operator[](std::size_t i) const { return begin()[i]; }
  T& back() { return begin()[size_ - 1]; }
  const T& back() const { return begin()[size_ - 1]; }
  T* begin() { return std::launder(reinterpret_cast<T*>(bytes_.data())); }
  T* end() { return begin() + size_; }
  const T* begin() const { return std::launder(reinterpret_cast<const T*>(bytes_.data())); }
  const T* end() const { return begin() + size_; }

 private:
  void* at(std::size_t i) { return bytes_.data() + i * sizeof(T); }

  alignas(T) std::array<std::byte, sizeof(T) * Capacity> bytes_;
  std::uint32_t size_ = 0;
};

}  // namespace kelpie
