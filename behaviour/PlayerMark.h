// SPDX-License-Identifier: Apache-2.0
// What stands in a robot's program before the name of its player, so that a tool can tell finished
// programs apart: the linker's names are gone there.
#pragma once

namespace kelpie::behaviour {

constexpr char kPlayerMark[] = "kelpie player: ";

}  // namespace kelpie::behaviour
