// SPDX-License-Identifier: Apache-2.0
// The field of 2006 for tests, and its table of the nearest paint, each built once.
#pragma once

#include <memory>

#include "gps/FieldFeatures.h"

namespace kelpie::gps {

inline const body::FieldDescription& field2006() {
  static const body::FieldDescription field = *body::fieldDescription("2006");
  return field;
}

inline const FieldFeatures& features() {
  static const auto built = [] {
    auto f = std::make_unique<FieldFeatures>();
    f->build(field2006());
    return f;
  }();
  return *built;
}

}  // namespace kelpie::gps
