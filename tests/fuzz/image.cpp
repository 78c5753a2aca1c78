// SPDX-License-Identifier: Apache-2.0
// An image of any bytes, by the kind that the first of them says. A picture that is taken can be
// written and read again; a code of class planes makes a plane whose code makes the same plane.
#include <memory>

#include "robot/core/types/PlaneFrame.h"
#include "tests/fuzz/Input.h"
#include "tools/calibrate/Images.h"
#include "tools/picture/Jpeg.h"
#include "vision/colour/ColourClass.h"

namespace {

using namespace kelpie;
using fuzz::require;

void checkFile(const fuzz::Bytes& bytes, const char* ending) {
  const fuzz::File file(bytes, ending);
  const auto image = calibrate::readImage(file.name());
  if (!image) return fuzz::requireLine(image.error(), file.name());
  const std::string again = fuzz::placeOf("-again.png");
  require(bool(calibrate::writePicture(*image, again)), "an image can be written");
  require(bool(calibrate::readImage(again)), "and read again");
  std::remove(again.c_str());
}

void checkJpeg(const fuzz::Bytes& bytes) {
  const auto image = std::make_unique<Image>();
  if (!picture::imageOfJpeg(bytes.data(), bytes.size(), *image)) return;
  const auto jpeg = picture::jpegOf(*image, 65);
  require(picture::imageOfJpeg(jpeg.data(), jpeg.size(), *image), "our own JPEG is read again");
}

void checkPlane(const fuzz::Bytes& bytes) {
  const auto code = std::make_unique<PlaneCode>(), again = std::make_unique<PlaneCode>();
  const auto plane = std::make_unique<ClassNumbers>(), back = std::make_unique<ClassNumbers>();
  for (const std::uint8_t byte : bytes) static_cast<void>(code->push_back(byte));
  if (!decodePlane(*code, vision::kColourClassCount, *plane)) return;
  for (const std::uint8_t number : *plane)
    require(number < vision::kColourClassCount, "a class that there is");
  encodePlane(*plane, *again);
  require(again->size() <= code->size(), "our code is the shortest");
  require(bool(decodePlane(*again, vision::kColourClassCount, *back)), "our own code is read");
  require(*back == *plane, "and makes the same plane");
}

// Raw images have one size; the bytes are repeated up to it.
fuzz::Bytes filled(fuzz::Bytes bytes) {
  for (std::size_t i = 0; !bytes.empty() && bytes.size() < 3 * kImagePixels; ++i)
    bytes.push_back(bytes[i]);
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  switch (input.byte() % 6) {
    case 0: checkFile(input.rest(), ".png"); break;
    case 1: checkFile(input.rest(), ".yuv"); break;
    case 2: checkFile(filled(input.rest()), ".yuv"); break;
    case 3: checkFile(filled(input.rest()), ".BIN"); break;
    case 4: checkJpeg(input.rest()); break;
    default: checkPlane(input.rest()); break;
  }
  return 0;
}
