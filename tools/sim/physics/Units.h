// SPDX-License-Identifier: Apache-2.0
// MuJoCo counts in metres, Kelpie in centimetres.
#pragma once

namespace kelpie::sim {

constexpr double kCm = 0.01;  // m

}  // namespace kelpie::sim
