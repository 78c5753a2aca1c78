// SPDX-License-Identifier: Apache-2.0
// A vector with a capacity fixed at compile time and no heap, for frame structs. Trivially copyable
// when T is. Elements beyond size() keep their default value, so that two equal vectors have equal
// bytes. push_back on a full vector returns false and changes nothing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace kelpie {

template <class T, std::size_t Capacity>
class FixedVector {
 public:
  using value_type = T;
  static constexpr std::size_t kCapacity = Capacity;

  bool push_back(const T& value) {
    if (size_ == Capacity) return false;
    items_[size_++] = value;
    return true;
  }
  void clear() { resize(0); }
  // Shrinks (resetting what is cut off) or grows with default values; clipped to the capacity.
  void resize(std::size_t size) {
    const std::size_t wanted = size < Capacity ? size : Capacity;
    for (std::size_t i = wanted; i < size_; ++i) items_[i] = T{};
    size_ = static_cast<std::uint32_t>(wanted);
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  bool full() const { return size_ == Capacity; }
  T& operator[](std::size_t i) { return items_[i]; }
  const T& operator[](std::size_t i) const { return items_[i]; }
  T& back() { return items_[size_ - 1]; }
  const T& back() const { return items_[size_ - 1]; }
  T* begin() { return items_.data(); }
  T* end() { return items_.data() + size_; }
  const T* begin() const { return items_.data(); }
  const T* end() const { return items_.data() + size_; }

 private:
  std::array<T, Capacity> items_{};
  std::uint32_t size_ = 0;
};

}  // namespace kelpie
