// SPDX-License-Identifier: Apache-2.0
// Bytes as text (RFC 4648, section 4).
#pragma once

#include <string>

namespace kelpie::live {

std::string base64(const std::string& bytes);

}  // namespace kelpie::live
