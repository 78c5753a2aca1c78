// SPDX-License-Identifier: Apache-2.0
// How lines of the agent process begin, so that who started it can tell them apart.
#pragma once

#include <string_view>

namespace kelpie::cli {

constexpr std::string_view kStatusMark = "status ";  // what the robot believes
// In a line that says that a log cannot be written any more; the process goes on.
constexpr std::string_view kLogEndsMark = "; the log ends at ";
constexpr std::string_view kComplaintMark = "kelpie-agent: ";  // why it ends

}  // namespace kelpie::cli
