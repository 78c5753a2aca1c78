// SPDX-License-Identifier: Apache-2.0
// A scene (tools/sim/staging/Scenes.h) as a session: play by the rules from the first moment, until
// a goal or the end of its time. Each robot is told where it stands, as a person who puts it there
// would type it in: some centimetres and degrees off.
#pragma once

#include <string>

#include "robot/core/Expected.h"
#include "tools/session/Teams.h"

namespace kelpie::cli {

// `plan`: the folders; how many play is the scene's to say. The seed and the field are those of the
// session.
Status useScene(const std::string& kind, TeamPlan plan, SessionOptions& options);

}  // namespace kelpie::cli
