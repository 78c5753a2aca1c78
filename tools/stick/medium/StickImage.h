// SPDX-License-Identifier: Apache-2.0
// A FAT image with a stick's files, made by mtools (Debian's package) without root or a mount. The
// same tree gives the same bytes: volume serial and all times are fixed (spec cross.md section 5).
// FAT12, which the robot reads faster than FAT16 (spec openr.md section 6). The image holds our
// files alone; a real stick is written by --install and never by copying an image over it, because
// a programming stick has a hidden area that is lost then.
#pragma once

#include <string>

#include "robot/core/Expected.h"
#include "tools/stick/StickTree.h"

namespace kelpie::stick {

// Writes the image whole or not at all, and reads every file back out of it.
Status writeImage(const StickTree& tree, const std::string& image);

}  // namespace kelpie::stick
