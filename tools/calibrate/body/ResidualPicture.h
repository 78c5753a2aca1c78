// SPDX-License-Identifier: Apache-2.0
// A picture of how far sightings lie beside where they should be, with the parameters before,
// after, and after once more with longer strokes, in which an error that all share shows as a
// pattern. Each is a stroke from its place in the image towards where it should be, in the colour
// of its kind. The name must end in .png.
#pragma once

#include <string>

#include "tools/calibrate/body/BodyEstimate.h"

namespace kelpie::calibrate {

Status writeResidualPicture(const BodyEstimate& estimate, const std::string& path);

}  // namespace kelpie::calibrate
