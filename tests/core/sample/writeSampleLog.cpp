// SPDX-License-Identifier: Apache-2.0
// write_sample_log PATH: a log for readers that are not ours.
#include <cstdio>

#include "tests/core/SampleLog.h"

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: write_sample_log PATH\n");
    return 2;
  }
  const kelpie::Status status = kelpie::writeSampleLog(arguments[1], 10);
  if (!status) std::fprintf(stderr, "%s\n", status.error().c_str());
  return status ? 0 : 1;
}
