// SPDX-License-Identifier: Apache-2.0
// The robot's body for a page that draws it: links, joints and simple shapes, from the lengths of
// robot/body. Only how thick a part looks is said here.
#pragma once

#include <string>

namespace kelpie::studio {

// JSON: {"links": [{"name", "parent", "origin", "axis", "joint", "sign", "shapes": [...]}],
// "camera": {"link", "origin", "opening_rad"}, "ball_radius"}. Lengths in cm. A link stands at
// `origin` of its parent's frame and is turned about `axis` by the angle of that joint (its number
// in Joint; -1: it is fixed). The frame of the torso is robot/body/Legs.h's: x right, y ahead, z
// up; the others' have its directions where all joints are at 0.
std::string bodyJson();

}  // namespace kelpie::studio
