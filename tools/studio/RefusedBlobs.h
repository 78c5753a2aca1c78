// SPDX-License-Identifier: Apache-2.0
// Which blobs of an image vision refused, and why. Vision counts its refusals by reason alone; here
// its finders run once more for each blob without that blob, and what is then refused less often
// was refused of it. Approximate where blobs belong together, as the two bands of a beacon do: both
// tell the reason.
#pragma once

#include <string>
#include <vector>

#include "robot/core/types/FrameInput.h"
#include "vision/VisionParams.h"
#include "vision/VisionState.h"
#include "vision/blobs/Blobs.h"

namespace kelpie::studio {

struct RefusedBlob {
  vision::Blob blob;
  std::vector<std::string> reasons;  // names of vision/Refusal.h
};

// `state` is as the step on this image left it, `percepts` what that gave. Blobs of which nothing
// was refused are left out.
std::vector<RefusedBlob> refusedBlobs(const FrameInput& input, const BodyState& body,
                                      const Percepts& percepts, const vision::VisionParams& params,
                                      vision::VisionState& state);

}  // namespace kelpie::studio
