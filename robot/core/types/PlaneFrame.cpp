// SPDX-License-Identifier: Apache-2.0
#include "robot/core/types/PlaneFrame.h"

#include <algorithm>

namespace kelpie {
namespace {

constexpr std::size_t kShortest = 16;  // pixels of a run with a second byte
constexpr std::size_t kLongest = kShortest + 255;
constexpr unsigned kMore = 15;  // low half of the first byte: a second one follows

void appendRun(unsigned number, std::size_t pixels, PlaneCode& code) {
  if (pixels < kShortest) {
    code.push_back(static_cast<std::uint8_t>(16U * number + pixels - 1U));
    return;
  }
  code.push_back(static_cast<std::uint8_t>(16U * number + kMore));
  code.push_back(static_cast<std::uint8_t>(pixels - kShortest));
}

Error wrong(std::size_t byte, const std::string& what) {
  return {"class plane, byte " + std::to_string(byte) + ": " + what};
}

}  // namespace

void encodePlane(const ClassNumbers& plane, PlaneCode& code) {
  code.clear();
  for (std::size_t first = 0; first < plane.size();) {
    std::size_t end = first + 1;
    while (end < plane.size() && end - first < kLongest && plane[end] == plane[first]) ++end;
    appendRun(plane[first] & 15U, end - first, code);
    first = end;
  }
}

Status decodePlane(const PlaneCode& code, std::uint8_t classes, ClassNumbers& plane) {
  std::size_t done = 0;
  for (std::size_t at = 0; at < code.size(); ++at) {
    const unsigned number = code[at] >> 4U;
    std::size_t pixels = (code[at] & 15U) + 1U;
    if (number >= classes) return wrong(at, "no class has the number " + std::to_string(number));
    if (pixels == kShortest) {
      if (++at == code.size()) return wrong(at, "ends within a run");
      pixels += code[at];
    }
    if (pixels > plane.size() - done) return wrong(at, "goes beyond the image");
    std::fill_n(plane.begin() + static_cast<std::ptrdiff_t>(done), pixels,
                static_cast<std::uint8_t>(number));
    done += pixels;
  }
  if (done == plane.size()) return Done{};
  return wrong(code.size(), "ends after " + std::to_string(done) + " of " +
                                std::to_string(plane.size()) + " pixels");
}

}  // namespace kelpie
