// SPDX-License-Identifier: Apache-2.0
// All that can be tuned in the use of field lines.
#pragma once

#include "gps/lines/LineMapParams.h"
#include "gps/lines/LineUpdateParams.h"

namespace kelpie::gps {

struct LinesParams {
  LineUpdateParams update;
  LineMapParams map;
  LinePoseSearchParams search;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("update", &LinesParams::update), field("map", &LinesParams::map),
                     field("search", &LinesParams::search));
  }
};

}  // namespace kelpie::gps
