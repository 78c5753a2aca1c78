// SPDX-License-Identifier: Apache-2.0
#include "tools/stick/StickWriter.h"

#include <cstring>

#include "robot/core/fields/Encoding.h"
#include "robot/stick/FieldListHash.h"
#include "robot/stick/StickFormat.h"

namespace kelpie::stick {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::uint32_t lengthOf(std::size_t size) { return static_cast<std::uint32_t>(size); }

Bytes encodeList(const StickTree& others) {
  StickFileList list;
  for (const auto& file : others) list.files.push_back(entryOf(file));
  Bytes bytes;
  encode(list, bytes);
  return bytes;
}

Bytes encodePart(const agent::AgentConfig& config, Part part) {
  Bytes bytes;
  forEachField(config, [&](const auto& f, const auto& member) {
    if (partOf<decltype(memberType(f))>() == part) encode(member, bytes);
  });
  return bytes;
}

PartEntry partEntry(const Bytes& part) {
  Crc32 crc;
  crc.add(part.data(), part.size());
  return {lengthOf(part.size()), crc.value()};
}

}  // namespace

StickFileEntry entryOf(const TreeFile& file) {
  StickFileEntry entry;
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(file.bytes.data());
  Crc32 crc;
  Fnv1a hash;
  crc.add(bytes, file.bytes.size());
  hash.add(bytes, file.bytes.size());
  entry.path.assign(file.path);
  entry.length = lengthOf(file.bytes.size());
  entry.crc = crc.value();
  entry.hash = hash.value();
  return entry;
}

std::string stickBinary(const agent::AgentConfig& config, const StickTree& others) {
  StickHeader header;
  header.fieldLists = fieldListHash<agent::AgentConfig>();
  Bytes parts;
  for (const Part part : kParts) {
    const Bytes bytes = part == Part::files ? encodeList(others) : encodePart(config, part);
    header.parts[static_cast<std::size_t>(part)] = partEntry(bytes);
    parts.insert(parts.end(), bytes.begin(), bytes.end());
  }
  header.length = kHeaderBytes + lengthOf(parts.size()) + kHashBytes;
  Bytes whole;
  encode(header, whole);
  whole.insert(whole.end(), parts.begin(), parts.end());
  Fnv1a hash;
  hash.add(whole.data(), whole.size());
  const std::uint64_t value = hash.value();
  const std::size_t end = whole.size();
  whole.resize(end + kHashBytes);
  std::memcpy(whole.data() + end, &value, kHashBytes);
  return {whole.begin(), whole.end()};
}

}  // namespace kelpie::stick
