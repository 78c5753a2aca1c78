// SPDX-License-Identifier: Apache-2.0
#include "tools/stick/BootReads.h"

#include <fmt/core.h>

#include <memory>

#include "robot/stick/StickReader.h"

namespace kelpie::stick {
namespace {

// Bytes a second of a Memory Stick of the first kind: 350 KB/s is stated as the average
// (hardwaresecrets.com, Memory Cards Tutorial), 20 MHz on one line allow 2.5 MB/s.
constexpr double kUsual = 350e3;
constexpr double kFastest = 2.5e6;

}  // namespace

BootReads bootReads(const StickTree& tree, bool python) {
  TreeFiles files(tree);
  const auto reader = std::make_unique<StickReader>(files);
  reader->check();
  BootReads reads{reader->progress().reads, reader->progress().bytes};
  const TreeFile* scripts = findFile(tree, kScriptsPath);
  if (!python || scripts == nullptr) return reads;
  reads.bytes += scripts->bytes.size();
  reads.reads +=
      scripts->bytes.size() / kBlockBytes + 1;  // the last is not full, which tells the end
  return reads;
}

std::string bootLine(const BootReads& reads) {
  return fmt::format(
      "boot: {} bytes in {} reads of at most {} KB, {:.1f} s at 2.5 MB/s, {:.1f} s at 350 KB/s",
      reads.bytes, reads.reads, kBlockBytes / 1024, double(reads.bytes) / kFastest,
      double(reads.bytes) / kUsual);
}

}  // namespace kelpie::stick
