// SPDX-License-Identifier: Apache-2.0
// Gaussians over places on the field in information form, in which independent sightings add up.
#pragma once

#include "gps/OnField.h"
#include "gps/players/PlayersState.h"

namespace kelpie::gps {

Information informationOf(const Place& place);
Place placeOf(const Information& information);
void add(const Information& more, Information& sum);

}  // namespace kelpie::gps
