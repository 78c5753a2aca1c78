// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/SharedData.h"

#include "tools/cli/DataFolder.h"

namespace kelpie::calibrate {

std::string sharedData() { return cli::dataFolder() + "/../shared/data/"; }

}  // namespace kelpie::calibrate
