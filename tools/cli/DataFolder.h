// SPDX-License-Identifier: Apache-2.0
// Where programs find what they read beside their own code: behaviours, teams, the studio's page.
// It is share/kelpie beside the folder of the running program, laid out as the source tree: in a
// build folder a link to that tree, in an installation the part of it that programs need. So no
// program knows the machine that built it. A program that was copied away alone finds nothing,
// and whoever opens a file there says which is missing.
#pragma once

#include <string>

namespace kelpie::cli {

// Without links in it, as `kelpie` says it to people; ends in no slash.
std::string dataFolder();

}  // namespace kelpie::cli
