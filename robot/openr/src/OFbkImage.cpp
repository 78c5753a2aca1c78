// SPDX-License-Identifier: Apache-2.0
#include <OPENR/OFbkImage.h>

namespace {

struct Rows {
  int bands;  // per line, each as wide as the image; 0 = the type is unknown
  int place;  // of the wanted band, -1 = the type does not have it
};

int yuvPlace(OFbkImageBand band) { return band <= ofbkimageBAND_Cb ? static_cast<int>(band) : -1; }

// Order of the rows as measured in the original (openr.md 5.3).
Rows rowsOf(ODataType type, OFbkImageBand band) {
  switch (type) {
    case odataFBK_YCrCb: return {3, yuvPlace(band)};
    case odataFBK_YCrCb_HPF: {
      const bool highPass = band >= ofbkimageBAND_Y_LH && band <= ofbkimageBAND_Y_HH;
      return {6, highPass ? static_cast<int>(band) - 1 : yuvPlace(band)};
    }
    case odataFBK_CDT: return {1, band == ofbkimageBAND_CDT ? 0 : -1};
    default: return {0, -1};
  }
}

}  // namespace

OFbkImage::OFbkImage(OFbkImageInfo* info, byte* data, OFbkImageBand band) {
  const Rows rows = rowsOf(info->type, band);
  if (rows.place < 0) return;
  width_ = static_cast<int>(info->width);
  height_ = static_cast<int>(info->height);
  skip_ = (rows.bands - 1) * width_;
  pointer_ = data + rows.place * width_;
}

word OFbkImage::FieldCounter() const { return static_cast<word>(tag()[0] | (tag()[1] << 8)); }

// Channels 4-7 come before channels 0-3 in the tag.
byte OFbkImage::ColorFrequency(OCdtChannel channel) const {
  for (int i = 0; i < 8; ++i) {
    if (channel == OCdtChannel{1} << i) return tag()[i < 4 ? 8 + i : i];
  }
  return 0;
}
