// SPDX-License-Identifier: Apache-2.0
// What stands in a robot's program before the name of its player and before the number of its
// frozen behaviours, so that a tool can tell finished programs apart: the linker's names are gone
// there.
#pragma once

namespace kelpie::behaviour {

constexpr char kPlayerMark[] = "kelpie player: ";
// As toolchain/python-openr/Modules.c spells it; eight digits of base 16 follow.
constexpr char kBehavioursMark[] = "kelpie behaviours ";

}  // namespace kelpie::behaviour
