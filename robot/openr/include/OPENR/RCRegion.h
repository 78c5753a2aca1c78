// SPDX-License-Identifier: Apache-2.0
// A reference-counted region of memory that travels between objects without a copy (openr.md 5.2).
// One reference: only the owner has it, it may be overwritten. More: receivers still read it. Lives
// on the heap only and destroys itself when the last reference goes.
#pragma once

#include "Types.h"

class RCRegion {
 public:
  explicit RCRegion(std::size_t size);
  // Wraps memory that stays somebody else's, such as a command vector.
  RCRegion(MemoryRegionID memID, std::size_t offset, void* base, std::size_t size);
  RCRegion(const RCRegion&) = delete;
  RCRegion& operator=(const RCRegion&) = delete;

  void AddReference() { ++references_; }
  void RemoveReference();
  int NumberOfReference() const { return references_; }

  byte* Base() const { return base_; }
  std::size_t Size() const { return size_; }
  MemoryRegionID MemID() const { return memID_; }
  std::size_t Offset() const { return offset_; }

 private:
  ~RCRegion();

  int references_ = 1;
  bool owned_;
  MemoryRegionID memID_;
  std::size_t offset_;
  byte* base_;
  std::size_t size_;
};
