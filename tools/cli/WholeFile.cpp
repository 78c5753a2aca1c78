// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/WholeFile.h"

#include <cstdio>

namespace kelpie::cli {

Status putInPlace(const Status& written, const std::string& part, const std::string& out) {
  if (written && std::rename(part.c_str(), out.c_str()) == 0) return Done{};
  std::remove(part.c_str());
  return written ? Status(Error{out + ": cannot be written"}) : written;
}

}  // namespace kelpie::cli
