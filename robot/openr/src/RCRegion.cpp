// SPDX-License-Identifier: Apache-2.0
#include <OPENR/RCRegion.h>

#include <new>

RCRegion::RCRegion()
    : references_(0), type_(REFERENCE_V20), memID_(UNDEF), offset_(0), base_(nullptr), size_(0) {}

RCRegion::RCRegion(std::size_t size)
    : references_(1),
      type_(SELF_ALLOCATED),
      memID_(UNDEF),
      offset_(0),
      base_(new char[size]()),
      size_(size) {}

RCRegion::RCRegion(MemoryRegionID memID, offset_t offset, void* base, std::size_t size)
    : references_(1),
      type_(REFERENCE_V20),
      memID_(memID),
      offset_(offset),
      base_(static_cast<char*>(base)),
      size_(size) {}

RCRegion::~RCRegion() {
  if (type_ == SELF_ALLOCATED) delete[] base_;
}

void* RCRegion::operator new(std::size_t size) { return ::operator new(size); }
void RCRegion::operator delete(void* memory) { ::operator delete(memory); }

void RCRegion::RemoveReference() {
  if (--references_ == 0) delete this;
}
