// SPDX-License-Identifier: Apache-2.0
// The playing field in the frame map, from its description: to draw, and as points for viewers that
// draw no scenes.
#pragma once

#include "foxglove/Frames.pb.h"
#include "foxglove/Scene.pb.h"
#include "robot/body/FieldDescription.h"
#include "robot/core/Time.h"

namespace kelpie::viewer {

// Carpet, lines, border, goals and beacons.
foxglove::SceneUpdate fieldScene(TimeUs time, const body::FieldDescription& field);

// Points on the painted lines and up the beacons and goal posts, each in its colour.
foxglove::PointCloud fieldPoints(TimeUs time, const body::FieldDescription& field);

}  // namespace kelpie::viewer
