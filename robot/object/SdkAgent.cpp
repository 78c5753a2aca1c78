// SPDX-License-Identifier: Apache-2.0
// The class that the SDK's stub wants, compiled where no SDK is. Nothing of this file is linked.
#include <type_traits>

#include "robot/object/sdk/Agent.h"

static_assert(std::is_default_constructible_v<Agent>);
