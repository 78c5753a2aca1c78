// SPDX-License-Identifier: Apache-2.0
// What a robot believes of its world beside places, in sentences: for `kelpie why`.
#pragma once

#include <string>

#include "robot/core/types/WorldModel.h"

namespace kelpie::match {

// "The pink/yellow beacon seems to stand 14 cm off its place."
std::string sentenceOf(const MovedLandmark& moved);

}  // namespace kelpie::match
