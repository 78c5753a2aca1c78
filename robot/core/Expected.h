// SPDX-License-Identifier: Apache-2.0
// The result of loading something: a value, or one line that says what is wrong and where.
// Not for the frame loop, which does not fail.
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace kelpie {

struct Error {
  std::string message;  // "file:line: what is wrong", ready to print
};

template <class T>
class Expected {
 public:
  Expected(T value) : value_(std::move(value)) {}  // NOLINT(google-explicit-constructor)
  Expected(Error error)
      : error_(std::move(error.message)) {}  // NOLINT(google-explicit-constructor)

  explicit operator bool() const { return value_.has_value(); }
  bool ok() const { return value_.has_value(); }
  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return &*value_; }
  const T* operator->() const { return &*value_; }
  const std::string& error() const { return error_; }

 private:
  std::optional<T> value_;
  std::string error_;
};

struct Done {};
using Status = Expected<Done>;

}  // namespace kelpie
