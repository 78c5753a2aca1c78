// SPDX-License-Identifier: Apache-2.0
// A picture of a colour table: eight slices of rising brightness, Cr to the right and Cb upwards,
// each cell in the colour that viewers draw its class in (kColourPalette). The name must end in
// .png.
#pragma once

#include <string>

#include "robot/core/Expected.h"
#include "vision/colour/ColourTable.h"

namespace kelpie::calibrate {

Status writeTablePicture(const vision::ColourTable& table, const std::string& path);

}  // namespace kelpie::calibrate
