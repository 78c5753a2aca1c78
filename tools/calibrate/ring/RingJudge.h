// SPDX-License-Identifier: Apache-2.0
// Judges ring tables by the sheets that they are for: how uneven an even surface still looks
// through the table, in grey levels. Also with other tables, so that one that was learnt from too
// few or too busy images is not put in the place of a better one unawares.
#pragma once

#include <array>
#include <vector>

#include "tools/calibrate/ring/Sheets.h"
#include "vision/colour/RingTable.h"

namespace kelpie::calibrate {

using Levels = std::array<double, 3>;  // grey levels of Y, Cr, Cb

// Root mean square over the sheets of their rings' means about the sheet's mean; rings are 12 px
// wide about the image's centre, whose hundreds of pixels leave noise of 0.1 levels.
Levels unevenness(const std::vector<Sheet>& sheets, const vision::RingTable& table);

struct RingVerdict {
  Levels learnt{};
  Levels published{};  // the polynomial of 2006
  Levels none{};       // no correction
};
RingVerdict compareUnevenness(const std::vector<Sheet>& sheets, const vision::RingTable& learnt);
// Less even than another table by more than noise could make it, in this channel.
bool isWorse(const RingVerdict& verdict, std::size_t channel);

}  // namespace kelpie::calibrate
