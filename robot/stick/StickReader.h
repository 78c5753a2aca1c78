// SPDX-License-Identifier: Apache-2.0
// The robot's own reader of a stick: checks every file that STICK.BIN lists and STICK.BIN itself,
// and fills the agent's configuration from it in place. Each file is read once, from front to back
// in blocks of 64 KB, because a stick is slow and each call costs. A stick that is refused leaves
// the configuration as it was, but for a value that cannot be although all checksums are right:
// then it is half filled, of no use, and the fault is `undecodable` or `outOfRange`. While it reads
// it has 448 KB of the heap.
//
// A caller that has lights to renew meanwhile goes block by block:
//
//   reader.begin();
//   while (reader.step()) show(reader.progress());
//   verdict = reader.load(config);
#pragma once

#include <memory>

#include "robot/core/Checksum.h"
#include "robot/stick/StickFiles.h"
#include "robot/stick/StickFormat.h"

namespace kelpie::stick {

struct ReadProgress {
  std::uint32_t reads = 0;  // of StickFiles
  std::uint32_t bytes = 0;  // that they gave
  std::uint32_t whole = 0;  // bytes of all files together; 0 until STICK.BIN has said it
};

class StickReader {
 public:
  explicit StickReader(StickFiles& files) : files_(files) {}

  // Reads every byte of every file that the robot uses, or what begin() and step() left of them.
  StickVerdict check();
  // check(), and only when that went well the configuration.
  StickVerdict load(agent::AgentConfig& config);

  // From the first file on.
  void begin();
  // Reads one block. False: nothing is left to read.
  bool step();
  // Since begin(); check() and load() leave it.
  ReadProgress progress() const { return progress_; }

  // Of the last check() that went well.
  const StickFileList& list() const { return list_; }

 private:
  enum class Stage : std::uint8_t { notBegun, binary, others, ended };
  struct Storage {
    std::array<std::uint8_t, kLargestBinary> binary;
    std::array<std::uint8_t, kBlockBytes> block;
  };

  std::int32_t readBlock(std::uint8_t* to);
  void readBinary();
  void readOther();
  void openNext();
  void end(StickFault fault, const StickPath& file);
  void finish();

  StickFault checkBinary();
  StickFault checkHeader() const;
  StickFault checkParts() const;
  StickFault checkHash() const;
  StickFault checkOther(const StickFileEntry& entry) const;
  const std::uint8_t* startOf(Part part) const;
  std::uint32_t lengthOf(Part part) const;
  void measure();
  StickFault readList();
  StickFault readConfig(agent::AgentConfig& config) const;
  template <std::size_t... I>
  StickFault readMembers(Part part, agent::AgentConfig& config,
                         std::index_sequence<I...> indices) const;
  StickFault readPart(Part part, agent::AgentConfig& config) const;

  StickFiles& files_;
  std::unique_ptr<Storage> storage_;
  Stage stage_ = Stage::notBegun;
  std::uint32_t binaryBytes_ = 0;
  std::size_t other_ = 0;  // which of the list
  std::uint32_t otherBytes_ = 0;
  Crc32 crc_;
  Fnv1a hash_;
  ReadProgress progress_;
  StickVerdict verdict_;
  StickHeader header_;
  StickFileList list_;
};

}  // namespace kelpie::stick
