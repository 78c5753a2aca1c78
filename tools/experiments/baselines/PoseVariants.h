// SPDX-License-Identifier: Apache-2.0
// Localisers that differ from the robot's in how the pose is updated: what was tried and not
// chosen, so that it can be measured again. Each is used in the place of gps::step. Those that use
// lines in another way (stepJointly, stepWithSymmetry) have neither a standing robot's map nor a
// search by lines while the pose is known, and no pinks.
#pragma once

#include "gps/Localiser.h"

namespace kelpie::gps {

using Localise = WorldModel (*)(const GpsIn&, const GpsParams&, GpsState&);

// Noise method 1 of thesis 2004 section 2.2.3: a mode refuses an unlikely landmark and grows, by 10
// cm and 5 deg (the thesis leaves open how much).
WorldModel stepRefusing(const GpsIn& in, const GpsParams& params, GpsState& state);
// The same, growing by 2 cm and 1 deg.
WorldModel stepRefusingSlowly(const GpsIn& in, const GpsParams& params, GpsState& state);

// Landmarks and lines in one update (JointUpdate).
WorldModel stepJointly(const GpsIn& in, const GpsParams& params, GpsState& state);

// Weighs a mode that a landmark corrects by sqrt(det C' / det C) too, C' its covariance after it:
// the product of Gaussians as it is (checklist B-2.1.3.2).
WorldModel stepByDeterminant(const GpsIn& in, const GpsParams& params, GpsState& state);

// Ambiguous poses as observation modes of their own (SymmetryUpdate); lines of the frame alone.
WorldModel stepWithSymmetry(const GpsIn& in, const GpsParams& params, GpsState& state);

}  // namespace kelpie::gps
