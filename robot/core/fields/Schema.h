// SPDX-License-Identifier: Apache-2.0
// The definition of a struct in ROS 1 message text, made from its field list: fields with units and
// ranges as comments, then one "MSG:" section for each struct within. Goes into every log, so that
// any reader can decode it.
#pragma once

#include <string>

#include "robot/core/fields/MemberType.h"

namespace kelpie {

namespace detail {

std::string schemaText(const MemberType& type);

}  // namespace detail

template <class T>
std::string schemaText() {
  return detail::schemaText(memberTypeOf<T>());
}

}  // namespace kelpie
