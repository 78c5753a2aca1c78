// SPDX-License-Identifier: Apache-2.0
// What carpet, lines and landmarks of one image look like, over what they are expected to. The
// carpet is told by its place below the horizon and the direction of its chroma, not by its class,
// which the light may have taken away; lines and landmarks are those that were found. Fails where
// something else that is green fills the image below the horizon.
#pragma once

#include "robot/core/types/Percepts.h"
#include "vision/Scene.h"
#include "vision/light/LightEstimate.h"

namespace kelpie::vision {

SeenLight seenLight(const Scene& scene, const Percepts& percepts, const LightParams& params);

}  // namespace kelpie::vision
