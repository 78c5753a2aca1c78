// SPDX-License-Identifier: Apache-2.0
// A picture of how far sightings lie beside where they should be, with the parameters before and
// after: each a stroke at its place in the image, ten times as long as it is, in the colour of its
// kind. The name must end in .png.
#pragma once

#include <string>

#include "tools/calibrate/BodyEstimate.h"

namespace kelpie::calibrate {

Status writeResidualPicture(const BodyEstimate& estimate, const std::string& path);

}  // namespace kelpie::calibrate
