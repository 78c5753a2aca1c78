// SPDX-License-Identifier: Apache-2.0
// The checked binary of a stick, STICK.BIN: all that is set before the first frame, and a list of
// the other files with what tells whether they are as they were written. Numbers are little-endian,
// the structs encoded as in a log (robot/core/fields/Encoding.h):
//
//   StickHeader | files: StickFileList | parameters | field | calibration | hash, 64 bits
//
// The three last parts hold the members of agent::AgentConfig in the order of its field list, each
// member in the part that its type says. The hash is FNV-1a over everything before it.
#pragma once

#include <array>

#include "robot/agent/AgentConfig.h"
#include "robot/stick/StickFault.h"

namespace kelpie::stick {

constexpr const char* kStickPath = "OPEN-R/MW/DATA/P/STICK.BIN";
constexpr const char* kScriptsPath = "OPEN-R/MW/DATA/P/PYCODE.ZIP";
constexpr const char* kObjectPath = "OPEN-R/MW/OBJS/AGENT.BIN";

// Beyond that it is none: the reader keeps the whole of it in memory.
constexpr std::uint32_t kLargestBinary = 6 * 65536;

constexpr std::array<std::uint8_t, 8> kMagic = {'K', 'E', 'L', 'P', 'I', 'E', 'M', 'S'};
constexpr std::uint32_t kVersion = 1;

enum class Part : std::uint8_t { files = 0, parameters = 1, field = 2, calibration = 3 };
constexpr std::array<Part, 4> kParts = {Part::files, Part::parameters, Part::field,
                                        Part::calibration};

struct PartEntry {
  std::uint32_t length = 0;  // bytes
  std::uint32_t crc = 0;     // CRC-32

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("length", &PartEntry::length), field("crc", &PartEntry::crc));
  }
};

struct StickHeader {
  std::array<std::uint8_t, 8> magic = kMagic;
  std::uint32_t version = kVersion;
  std::uint32_t length = 0;      // of the whole file
  std::uint64_t fieldLists = 0;  // fieldListHash<agent::AgentConfig>()
  std::array<PartEntry, kParts.size()> parts{};

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("magic", &StickHeader::magic), field("version", &StickHeader::version),
                     field("length", &StickHeader::length),
                     field("fieldLists", &StickHeader::fieldLists),
                     field("parts", &StickHeader::parts));
  }
};
constexpr std::uint32_t kHeaderBytes = 8 + 4 + 4 + 8 + 8 * kParts.size();
constexpr std::uint32_t kHashBytes = 8;

// What another file of the stick must be.
struct StickFileEntry {
  StickPath path;
  std::uint32_t length = 0;
  std::uint32_t crc = 0;
  std::uint64_t hash = 0;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("path", &StickFileEntry::path), field("length", &StickFileEntry::length),
                     field("crc", &StickFileEntry::crc), field("hash", &StickFileEntry::hash));
  }
};

struct StickFileList {
  FixedVector<StickFileEntry, 8> files;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("files", &StickFileList::files));
  }
};

template <class Member>
constexpr Part partOf() {
  if (std::is_same_v<Member, body::FieldDescription>) return Part::field;
  if (std::is_same_v<Member, vision::VisionCalibration>) return Part::calibration;
  return Part::parameters;
}

}  // namespace kelpie::stick
