// SPDX-License-Identifier: Apache-2.0
// A walk set as a parameter file: what actuator/data/walks holds, and `--params` takes.
#pragma once

#include <string>

#include "actuator/walk/WalkSet.h"

namespace kelpie::learn {

// "normal"; the word of actuator.walks.<word>.
const char* nameOf(WalkKind kind);

// `heading`: comment lines without the #.
std::string walkText(WalkKind kind, const actuator::WalkSet& set, const std::string& heading);

}  // namespace kelpie::learn
