// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/SharedData.h"

namespace kelpie::calibrate {

std::string sharedData() { return KELPIE_SOURCE_DIR "/../shared/data/"; }

}  // namespace kelpie::calibrate
