// SPDX-License-Identifier: Apache-2.0
// A reference-counted region of memory that travels between objects without a copy (openr.md 5.2).
// One reference: only the owner has it, it may be overwritten. More: receivers still read it. Lives
// on the heap only, by an operator new of its own, and destroys itself when the last reference
// goes.
#pragma once

#include "Types.h"

using offset_t = unsigned int;

class RCRegion {
 public:
  // The robot has a fourth, UNDEF, for one of nothing, which would shadow the global name.
  enum RegionType { SELF_ALLOCATED, REFERENCE_V20, REFERENCE_V10 };

  RCRegion();  // of nothing, with no reference
  explicit RCRegion(std::size_t size);
  // Wraps memory that stays somebody else's, such as a command vector.
  RCRegion(MemoryRegionID memID, offset_t offset, void* base = nullptr, std::size_t size = 0);
  RCRegion(const RCRegion&) = delete;
  RCRegion& operator=(const RCRegion&) = delete;

  // The robot has a pool for them, hence no placement and no `new (std::nothrow)`.
  static void* operator new(std::size_t size);
  static void operator delete(void* memory);

  void AddReference() { ++references_; }
  void RemoveReference();
  int NumberOfReference() const { return references_; }

  char* Base() const { return base_; }
  std::size_t Size() const { return size_; }
  MemoryRegionID MemID() const { return memID_; }
  offset_t Offset() const { return offset_; }
  RegionType GetType() const { return type_; }
  void SetSize(std::size_t size) { size_ = size; }

 private:
  ~RCRegion();

  int references_;
  RegionType type_;
  MemoryRegionID memID_;
  offset_t offset_;
  char* base_;
  std::size_t size_;
};
