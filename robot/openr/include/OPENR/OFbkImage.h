// SPDX-License-Identifier: Apache-2.0
// One band of one layer of a camera image, read in place. Row layout and skip by type, as measured
// (openr.md 5.3). IsValid is false when the type does not have the band.
#pragma once

#include "OPENR/ODataFormats.h"

using OFbkImageBand = longword;
constexpr OFbkImageBand ofbkimageBAND_Y = 0;
constexpr OFbkImageBand ofbkimageBAND_Cr = 1;
constexpr OFbkImageBand ofbkimageBAND_Cb = 2;
constexpr OFbkImageBand ofbkimageBAND_CDT = 3;
constexpr OFbkImageBand ofbkimageBAND_Y_LH = 4;
constexpr OFbkImageBand ofbkimageBAND_Y_HL = 5;
constexpr OFbkImageBand ofbkimageBAND_Y_HH = 6;

// 16 bytes with the robot's 32-bit pointers.
class OFbkImage {
 public:
  OFbkImage(OFbkImageInfo* info, byte* data, OFbkImageBand band);
  ~OFbkImage() {}  // NOLINT(modernize-use-equals-default): the robot's is not trivial

  bool IsValid() const { return pointer_ != nullptr; }
  byte* Pointer() const { return pointer_; }
  int Width() const { return width_; }
  int Height() const { return height_; }
  int Skip() const { return skip_; }  // bytes from the end of a row to the start of the next
  byte Pixel(int x, int y) const { return pointer_[(width_ + skip_) * y + x]; }
  // The field counter of the tag that replaces the last line, for band Y and CDT, which start at
  // the row's start.
  word FieldCounter() const;
  // Of one channel, named by its bit; 0 for none or several.
  byte ColorFrequency(OCdtChannel channel) const;

 private:
  const byte* tag() const { return pointer_ + (width_ + skip_) * (height_ - 1); }

  byte* pointer_ = nullptr;
  int width_ = 0;
  int height_ = 0;
  int skip_ = 0;
};
