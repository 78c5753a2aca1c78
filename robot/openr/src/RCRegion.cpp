// SPDX-License-Identifier: Apache-2.0
#include <OPENR/RCRegion.h>

RCRegion::RCRegion(std::size_t size)
    : owned_(true), memID_(UNDEF), offset_(0), base_(new byte[size]()), size_(size) {}

RCRegion::RCRegion(MemoryRegionID memID, std::size_t offset, void* base, std::size_t size)
    : owned_(false), memID_(memID), offset_(offset), base_(static_cast<byte*>(base)), size_(size) {}

RCRegion::~RCRegion() {
  if (owned_) delete[] base_;
}

void RCRegion::RemoveReference() {
  if (--references_ == 0) delete this;
}
