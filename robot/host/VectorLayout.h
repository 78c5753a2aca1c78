// SPDX-License-Identifier: Apache-2.0
// How the parts of a data vector of OPEN-R lie in its memory: header, infos, then the data of each
// (openr.md 5.3).
#pragma once

#include <OPENR/ODataFormats.h>

#include <cstddef>

namespace kelpie::host {

template <class Info>
std::size_t vectorBytes(std::size_t count, std::size_t dataBytes) {
  return sizeof(ODataVectorInfo) + count * (sizeof(Info) + dataBytes);
}

// Fills the header, and where the data of each info are. The memory is zero before.
template <class Info, class Data>
void layOut(ODataVector<Info, Data>& vector, ODataType type, std::size_t count,
            std::size_t dataBytes) {
  ODataVectorInfo& header = vector.vectorInfo;
  header.type = type;
  header.totalSize = static_cast<longword>(vectorBytes<Info>(count, dataBytes));
  header.infoOffset = sizeof(ODataVectorInfo);
  header.infoSize = sizeof(Info);
  header.maxNumData = static_cast<longword>(count);
  const std::size_t dataStart = sizeof(ODataVectorInfo) + count * sizeof(Info);
  for (std::size_t i = 0; i < count; ++i) {
    vector.GetInfo(i)->dataOffset = static_cast<longword>(dataStart + i * dataBytes);
    vector.GetInfo(i)->dataSize = static_cast<longword>(dataBytes);
  }
}

}  // namespace kelpie::host
