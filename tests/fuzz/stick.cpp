// SPDX-License-Identifier: Apache-2.0
// A stick's STICK.BIN: the bytes as they are, or laid over that of a sound stick, whose checksums
// are made right again or not. A stick that is refused leaves the configuration, but for the faults
// of which the reader says so; one that is taken is in range and gives the same again when it is
// written.
#include <memory>

#include "robot/core/Checksum.h"
#include "robot/core/fields/FieldCheck.h"
#include "robot/stick/FieldListHash.h"
#include "robot/stick/StickReader.h"
#include "tests/fuzz/Input.h"
#include "tools/stick/StickTree.h"
#include "tools/stick/StickWriter.h"

namespace {

using namespace kelpie;
using fuzz::require;

void put(fuzz::Bytes& bytes, std::size_t at, std::uint64_t value, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    if (at + i < bytes.size()) bytes[at + i] = static_cast<std::uint8_t>(value >> (8 * i));
}

std::uint32_t wordAt(const fuzz::Bytes& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::uint32_t{bytes[at + i]} << (8 * i);
  return value;
}

// Every checksum of what the header says; lengths that lead out of the file stay without.
void seal(fuzz::Bytes& bytes) {
  if (bytes.size() < stick::kHeaderBytes + stick::kHashBytes) return;
  put(bytes, 16, stick::fieldListHash<agent::AgentConfig>(), 8);
  std::size_t from = stick::kHeaderBytes;
  for (std::size_t part = 0; part < stick::kParts.size(); ++part) {
    const std::size_t entry = 24 + 8 * part;
    const std::size_t length = wordAt(bytes, entry);
    if (length > bytes.size() - stick::kHashBytes - from) break;
    put(bytes, entry + 4, crc32(bytes.data() + from, length), 4);
    from += length;
  }
  Fnv1a hash;
  hash.add(bytes.data(), bytes.size() - stick::kHashBytes);
  put(bytes, bytes.size() - stick::kHashBytes, hash.value(), stick::kHashBytes);
}

fuzz::Bytes binaryOf(fuzz::Input& input) {
  static const std::string kSound = stick::stickBinary(*std::make_unique<agent::AgentConfig>(), {});
  const unsigned how = input.byte() % 3U;
  if (how == 0) return input.rest();
  fuzz::Bytes bytes(kSound.begin(), kSound.end());
  fuzz::layOver(input, bytes);
  if (how == 1) seal(bytes);
  return bytes;
}

stick::StickVerdict loaded(const std::string& binary, agent::AgentConfig& config) {
  const stick::StickTree tree = {{stick::kStickPath, binary}};
  stick::TreeFiles files(tree);
  return std::make_unique<stick::StickReader>(files)->load(config);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto kBefore = std::make_unique<agent::AgentConfig>();
  fuzz::Input input(data, size);
  const auto config = std::make_unique<agent::AgentConfig>();
  const stick::StickVerdict verdict = loaded(fuzz::textOf(binaryOf(input)), *config);
  require(stick::lineOf(verdict).size() > 0 || verdict.good(), "a refusal has a line");
  std::string why;
  if (!verdict.good()) {
    const bool half = verdict.fault == stick::StickFault::outOfRange ||
                      verdict.fault == stick::StickFault::undecodable;
    require(half || !firstDifference(*config, *kBefore, &why), "what is refused changes: " + why);
    return 0;
  }
  require(verify(*config, &why), "what is taken is in range: " + why);
  const auto back = std::make_unique<agent::AgentConfig>();
  require(loaded(stick::stickBinary(*config, {}), *back).good(), "it can be written again");
  require(!firstDifference(*config, *back, &why), "and says the same: " + why);
  return 0;
}
