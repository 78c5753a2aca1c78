// SPDX-License-Identifier: Apache-2.0
#include "robot/stick/StickReader.h"

#include "robot/stick/FieldListHash.h"

namespace kelpie::stick {
namespace {

constexpr std::uint64_t kFieldLists = fieldListHash<agent::AgentConfig>();

}  // namespace

StickVerdict StickReader::verdict(StickFault fault, const StickPath& file) {
  files_.close();
  return {fault, file};
}

StickVerdict StickReader::check() {
  const StickPath binary{std::string_view(kStickPath)};
  const StickFault whole = checkBinary();
  if (whole != StickFault::none) return verdict(whole, binary);
  const StickFault list = readList();
  if (list != StickFault::none) return verdict(list, binary);
  for (const auto& entry : list_.files) {
    const StickFault fault = checkFile(entry);
    if (fault != StickFault::none) return verdict(fault, entry.path);
  }
  return verdict(StickFault::none, binary);
}

StickVerdict StickReader::load(agent::AgentConfig& config) {
  const StickVerdict checked = check();
  if (!checked.good()) return checked;
  return verdict(readConfig(config), checked.file);
}

bool StickReader::readHeader() { return reader_.open(kStickPath) && reader_.getStruct(header_); }

// What the header says of itself, before anything is done with it.
StickFault StickReader::checkHeader() const {
  if (header_.magic != kMagic) return StickFault::wrongMagic;
  if (header_.version != kVersion) return StickFault::otherVersion;
  if (header_.fieldLists != kFieldLists) return StickFault::otherFieldLists;
  std::uint64_t length = kHeaderBytes + kHashBytes;
  for (const auto& part : header_.parts) length += part.length;
  return length == header_.length ? StickFault::none : StickFault::damagedHeader;
}

StickFault StickReader::checkParts() {
  for (const auto& part : header_.parts) {
    reader_.startPart();
    if (!reader_.skip(part.length)) return reader_.fault();
    if (reader_.crc() != part.crc) return StickFault::damagedPart;
  }
  return StickFault::none;
}

StickFault StickReader::checkBinary() {
  if (!readHeader()) return reader_.fault();
  const StickFault header = checkHeader();
  if (header != StickFault::none) return header;
  const StickFault parts = checkParts();
  if (parts != StickFault::none) return parts;
  const std::uint64_t hash = reader_.hash();
  std::uint64_t written = 0;
  if (!reader_.take(&written, sizeof written)) return reader_.fault();
  if (written != hash) return StickFault::damagedWhole;
  return reader_.atEnd() ? StickFault::none : reader_.fault();
}

StickFault StickReader::readList() {
  if (!readHeader()) return reader_.fault();
  reader_.startPart();
  if (!reader_.getStruct(list_)) return reader_.fault();
  const PartEntry& part = header_.parts[static_cast<std::size_t>(Part::files)];
  const bool same = reader_.partBytes() == part.length && reader_.crc() == part.crc;
  return same ? StickFault::none : StickFault::damagedPart;
}

StickFault StickReader::checkFile(const StickFileEntry& entry) {
  char path[StickPath::kCapacity + 1] = {};
  std::memcpy(path, entry.path.begin(), entry.path.size());
  if (!reader_.open(path) || !reader_.skipAll(entry.length)) return reader_.fault();
  const bool same = reader_.crc() == entry.crc && reader_.hash() == entry.hash;
  return same ? StickFault::none : StickFault::otherContent;
}

// The parts once more, this time into their places; the second reading is checked as the first was.
StickFault StickReader::readConfig(agent::AgentConfig& config) {
  if (!readHeader()) return reader_.fault();
  for (const Part part : kParts) {
    const PartEntry& entry = header_.parts[static_cast<std::size_t>(part)];
    reader_.startPart();
    const bool good = part == Part::files ? reader_.skip(entry.length) : readPart(part, config);
    if (!good) return reader_.fault();
    if (reader_.partBytes() != entry.length || reader_.crc() != entry.crc)
      return StickFault::damagedPart;
  }
  agent::shareField(config);
  return StickFault::none;
}

// The configuration's members of one part, in the order of its field list.
template <std::size_t... I>
bool StickReader::readMembers(Part part, agent::AgentConfig& config,
                              std::index_sequence<I...> /*unused*/) {
  constexpr auto kFields = agent::AgentConfig::fields();
  return ((partOf<decltype(memberType(std::get<I>(kFields)))>() != part ||
           reader_.get(config.*(std::get<I>(kFields).member), std::get<I>(kFields).min,
                       std::get<I>(kFields).max)) &&
          ...);
}

bool StickReader::readPart(Part part, agent::AgentConfig& config) {
  constexpr auto kMembers = std::tuple_size_v<decltype(agent::AgentConfig::fields())>;
  return readMembers(part, config, std::make_index_sequence<kMembers>());
}

}  // namespace kelpie::stick
