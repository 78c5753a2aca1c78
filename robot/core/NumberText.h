// SPDX-License-Identifier: Apache-2.0
// A text that is one number and nothing else.
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <system_error>

namespace kelpie {

// Nothing for an empty text, for what does not fit the type, and for anything behind the number.
template <class T>
std::optional<T> numberFrom(const std::string& text) {
  T number{};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end) return std::nullopt;
  return number;
}

}  // namespace kelpie
