// SPDX-License-Identifier: Apache-2.0
// The field of 2004, which has a white border, for tests; and its tables of what is nearest.
#pragma once

#include <memory>

#include "gps/lines/FieldFeatures.h"

namespace kelpie::gps {

inline const body::FieldDescription& field2004() {
  static const body::FieldDescription field = *body::fieldDescription("2004");
  return field;
}

inline const FieldFeatures& features2004() {
  static const auto built = [] {
    auto f = std::make_unique<FieldFeatures>();
    f->build(field2004());
    return f;
  }();
  return *built;
}

}  // namespace kelpie::gps
