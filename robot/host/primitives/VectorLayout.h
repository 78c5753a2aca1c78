// SPDX-License-Identifier: Apache-2.0
// How the parts of a data vector of OPEN-R lie in its memory: header, infos, then the data of each
// (openr.md 5.3).
#pragma once

#include <OPENR/ODataFormats.h>

#include <cstddef>
#include <type_traits>

namespace kelpie::host {

// A multiple of the alignment of all that a block may hold.
template <class Info>
std::size_t dataStart(std::size_t count) {
  return sizeof(ODataVectorInfo) + count * sizeof(Info);
}

template <class Info>
std::size_t vectorBytes(std::size_t count, std::size_t dataBytes) {
  return dataStart<Info>(count) + count * dataBytes;
}

// Fills the header, and where the data of each info are. The memory is zero before.
template <class Vector>
void layOut(Vector& vector, ODataType type, std::size_t count, std::size_t dataBytes) {
  using Info = std::remove_reference_t<decltype(*vector.info)>;
  ODataVectorInfo& header = vector.vectorInfo;
  header.type = type;
  header.totalSize = vectorBytes<Info>(count, dataBytes);
  header.infoOffset = offsetof(Vector, info);
  header.infoSize = sizeof(Info);
  header.maxNumData = count;
  for (std::size_t i = 0; i < count; ++i) {
    Info& info = *vector.GetInfo(static_cast<int>(i));
    info.dataOffset = dataStart<Info>(count) + i * dataBytes;
    info.dataSize = dataBytes;
  }
}

}  // namespace kelpie::host
