// SPDX-License-Identifier: Apache-2.0
#include <OPENR/ObjcommMessages.h>

OStatus ONotifyMessage::Write(RCRegion* region) {
  if (static_cast<std::size_t>(numOfData) == MAX_NUM_DATA) return oFULL_OF_QUEUE;
  data[numOfData++] = {region, region->MemID(), region->Offset(), region->Size()};
  return oSUCCESS;
}
