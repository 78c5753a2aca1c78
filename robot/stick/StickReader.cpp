// SPDX-License-Identifier: Apache-2.0
#include "robot/stick/StickReader.h"

#include "robot/stick/FieldListHash.h"
#include "robot/stick/FieldReader.h"

namespace kelpie::stick {
namespace {

constexpr std::uint64_t kFieldLists = fieldListHash<agent::AgentConfig>();

// Encoded a configuration is hardly larger than in memory, and the list and the header are small.
static_assert(sizeof(agent::AgentConfig) + 8192 < kLargestBinary);
static_assert(kLargestBinary % kBlockBytes == 0, "the last block would end beyond the room");

StickPath binaryPath() { return StickPath(std::string_view(kStickPath)); }

}  // namespace

StickVerdict StickReader::check() {
  finish();
  storage_.reset();
  return verdict_;
}

StickVerdict StickReader::load(agent::AgentConfig& config) {
  finish();
  if (verdict_.good()) verdict_.fault = readConfig(config);
  storage_.reset();
  return verdict_;
}

void StickReader::finish() {
  if (stage_ == Stage::notBegun) begin();
  while (step()) {
  }
  stage_ = Stage::notBegun;
}

void StickReader::begin() {
  storage_ = std::make_unique<Storage>();
  progress_ = {};
  binaryBytes_ = 0;
  stage_ = Stage::binary;
  if (!files_.open(kStickPath)) end(StickFault::missing, binaryPath());
}

bool StickReader::step() {
  if (stage_ == Stage::binary) {
    readBinary();
  } else if (stage_ == Stage::others) {
    readOther();
  }
  return stage_ == Stage::binary || stage_ == Stage::others;
}

void StickReader::end(StickFault fault, const StickPath& file) {
  files_.close();
  verdict_ = {fault, file};
  stage_ = Stage::ended;
}

std::int32_t StickReader::readBlock(std::uint8_t* to) {
  const std::int32_t got = files_.read(to, kBlockBytes);
  ++progress_.reads;
  if (got > 0) progress_.bytes += static_cast<std::uint32_t>(got);
  return got;
}

// STICK.BIN stays in memory, because it is checked as a whole before anything is taken from it.
void StickReader::readBinary() {
  const std::int32_t got = readBlock(storage_->binary.data() + binaryBytes_);
  if (got < 0) return end(StickFault::unreadable, binaryPath());
  binaryBytes_ += static_cast<std::uint32_t>(got);
  if (got == kBlockBytes && binaryBytes_ < kLargestBinary) return;
  StickFault fault = checkBinary();
  if (fault == StickFault::none) fault = readList();
  if (fault != StickFault::none) return end(fault, binaryPath());
  measure();
  stage_ = Stage::others;
  other_ = 0;
  openNext();
}

void StickReader::measure() {
  progress_.whole = binaryBytes_;
  for (const auto& entry : list_.files) progress_.whole += entry.length;
}

void StickReader::openNext() {
  if (other_ == list_.files.size()) return end(StickFault::none, binaryPath());
  const StickPath& name = list_.files[other_].path;
  char path[StickPath::kCapacity + 1] = {};
  std::memcpy(path, name.begin(), name.size());
  otherBytes_ = 0;
  crc_ = {};
  hash_ = {};
  if (!files_.open(path)) end(StickFault::missing, name);
}

void StickReader::readOther() {
  const StickFileEntry& entry = list_.files[other_];
  const std::int32_t got = readBlock(storage_->block.data());
  if (got < 0) return end(StickFault::unreadable, entry.path);
  const auto count = static_cast<std::uint32_t>(got);
  crc_.add(storage_->block.data(), count);
  hash_.add(storage_->block.data(), count);
  otherBytes_ += count;
  const bool more = count == kBlockBytes && otherBytes_ <= entry.length;
  if (more) return;
  const StickFault fault = checkOther(entry);
  if (fault != StickFault::none) return end(fault, entry.path);
  ++other_;
  openNext();
}

StickFault StickReader::checkOther(const StickFileEntry& entry) const {
  if (otherBytes_ > entry.length) return StickFault::tooLong;
  if (otherBytes_ < entry.length) return StickFault::cutShort;
  const bool same = crc_.value() == entry.crc && hash_.value() == entry.hash;
  return same ? StickFault::none : StickFault::otherContent;
}

StickFault StickReader::checkBinary() {
  FieldReader reader(storage_->binary.data(), binaryBytes_);
  if (!reader.getStruct(header_)) return reader.fault();
  StickFault fault = checkHeader();
  if (fault == StickFault::none && binaryBytes_ < header_.length) fault = StickFault::cutShort;
  if (fault == StickFault::none) fault = checkParts();
  if (fault == StickFault::none) fault = checkHash();
  if (fault == StickFault::none && binaryBytes_ > header_.length) fault = StickFault::tooLong;
  return fault;
}

// What the header says of itself, before anything is done with it.
StickFault StickReader::checkHeader() const {
  if (header_.magic != kMagic) return StickFault::wrongMagic;
  if (header_.version != kVersion) return StickFault::otherVersion;
  if (header_.fieldLists != kFieldLists) return StickFault::otherFieldLists;
  std::uint64_t length = kHeaderBytes + kHashBytes;
  for (const auto& part : header_.parts) length += part.length;
  return length == header_.length ? StickFault::none : StickFault::damagedHeader;
}

std::uint32_t StickReader::lengthOf(Part part) const {
  return header_.parts[static_cast<std::size_t>(part)].length;
}

const std::uint8_t* StickReader::startOf(Part part) const {
  const std::uint8_t* start = storage_->binary.data() + kHeaderBytes;
  for (const Part before : kParts)
    if (before < part) start += lengthOf(before);
  return start;
}

StickFault StickReader::checkParts() const {
  for (const Part part : kParts) {
    Crc32 crc;
    crc.add(startOf(part), lengthOf(part));
    if (crc.value() != header_.parts[static_cast<std::size_t>(part)].crc)
      return StickFault::damagedPart;
  }
  return StickFault::none;
}

StickFault StickReader::checkHash() const {
  const std::uint32_t before = header_.length - kHashBytes;
  Fnv1a hash;
  hash.add(storage_->binary.data(), before);
  std::uint64_t written = 0;
  std::memcpy(&written, storage_->binary.data() + before, sizeof written);
  return written == hash.value() ? StickFault::none : StickFault::damagedWhole;
}

StickFault StickReader::readList() {
  FieldReader reader(startOf(Part::files), lengthOf(Part::files));
  if (!reader.getStruct(list_)) return reader.fault();
  return reader.atEnd() ? StickFault::none : StickFault::damagedPart;
}

StickFault StickReader::readConfig(agent::AgentConfig& config) const {
  for (const Part part : kParts) {
    const StickFault fault = part == Part::files ? StickFault::none : readPart(part, config);
    if (fault != StickFault::none) return fault;
  }
  agent::shareField(config);
  return StickFault::none;
}

// The configuration's members of one part, in the order of its field list.
template <std::size_t... I>
StickFault StickReader::readMembers(Part part, agent::AgentConfig& config,
                                    std::index_sequence<I...> /*unused*/) const {
  constexpr auto kFields = agent::AgentConfig::fields();
  FieldReader reader(startOf(part), lengthOf(part));
  const bool good = ((partOf<decltype(memberType(kFields.get<I>()))>() != part ||
                      reader.get(config.*(kFields.get<I>().member), kFields.get<I>().min,
                                 kFields.get<I>().max)) &&
                     ...);
  if (!good) return reader.fault();
  return reader.atEnd() ? StickFault::none : StickFault::damagedPart;
}

StickFault StickReader::readPart(Part part, agent::AgentConfig& config) const {
  constexpr auto kMembers = decltype(agent::AgentConfig::fields())::kCount;
  return readMembers(part, config, std::make_index_sequence<kMembers>());
}

}  // namespace kelpie::stick
