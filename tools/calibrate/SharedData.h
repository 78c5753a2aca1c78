// SPDX-License-Identifier: Apache-2.0
// Where the data measured on real robots lie, beside the source tree: never part of it, and absent
// on most machines. Experiments then answer null, tests skip.
#pragma once

#include <string>

namespace kelpie::calibrate {

std::string sharedData();  // ends in a slash

}  // namespace kelpie::calibrate
