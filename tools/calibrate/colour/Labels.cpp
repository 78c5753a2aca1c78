// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/colour/Labels.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "tools/calibrate/Csv.h"
#include "tools/calibrate/Images.h"
#include "vision/colour/ColourTable.h"

namespace kelpie::calibrate {
namespace {

namespace fs = std::filesystem;

struct Region {
  std::string image;
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
  vision::ColourClass colour = vision::ColourClass::none;
};

constexpr std::uint8_t kLastIdOf2005 = 12;
constexpr std::uint8_t kNoneOf2005 = 127;

Expected<Region> parseRegion(const std::string& line) {
  std::istringstream in(line);
  Region r;
  std::string name, more;
  if (!(in >> r.image >> r.left >> r.top >> r.right >> r.bottom >> name) || in >> more)
    return Error{"expected: image left top right bottom class"};
  if (r.left < 0 || r.top < 0 || r.right > kImageWidth || r.bottom > kImageHeight ||
      r.left >= r.right || r.top >= r.bottom)
    return Error{"the box must lie in 208 x 160 pixels"};
  const auto colour = colourClassOf(name);
  if (!colour) return Error{colour.error()};
  r.colour = *colour;
  return r;
}

Expected<std::vector<Region>> parseRegions(const std::string& path) {
  std::ifstream file(path);
  if (!file) return Error{path + ": cannot be opened"};
  std::vector<Region> regions;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos || line[0] == '#') continue;
    auto region = parseRegion(line);
    if (!region) return Error{path + ":" + std::to_string(number) + ": " + region.error()};
    regions.push_back(*region);
  }
  if (regions.empty()) return Error{path + ": no labelled boxes"};
  return regions;
}

}  // namespace

std::string colourClassList() {
  std::string list;
  for (const char* name : vision::kColourNames)
    list += (list.empty() ? "" : ", ") + std::string(name);
  return list;
}

Expected<vision::ColourClass> colourClassOf(const std::string& text) {
  const auto& names = vision::kColourNames;
  const auto found = std::find(names.begin(), names.end(), text);
  if (found != names.end()) return static_cast<vision::ColourClass>(found - names.begin());
  std::uint8_t id = 0;
  if (parseByte(text, id) && (id <= kLastIdOf2005 || id == kNoneOf2005))
    return vision::classOf2005(id);
  return Error{"no class '" + text + "', the classes are " + colourClassList() +
               " or a number of 2005 (0 to 12, 127)"};
}

Expected<LabelledPixels> readLabelledCsv(const std::string& path) {
  LabelledPixels pixels;
  const Status read = forEachRow(path, "Y,Cr,Cb,class", [&](const Cells& cells) -> Status {
    LabelledPixel p;
    if (!parseByte(cells[0], p.value.y) || !parseByte(cells[1], p.value.cr) ||
        !parseByte(cells[2], p.value.cb))
      return Error{"expected three numbers in 0..255 and a class"};
    const auto colour = colourClassOf(std::string(cells[3]));
    if (!colour) return Error{colour.error()};
    p.colour = *colour;
    pixels.push_back(p);
    return Done{};
  });
  if (!read) return Error{read.error()};
  if (pixels.empty()) return Error{path + ": no labelled pixels"};
  return pixels;
}

Expected<LabelledPixels> readRegions(const std::string& path, const vision::RingTable& ring) {
  const auto regions = parseRegions(path);
  if (!regions) return Error{regions.error()};
  const vision::RingDistances distances;
  std::map<std::string, Image> images;
  LabelledPixels pixels;
  for (const Region& r : *regions) {
    if (images.count(r.image) == 0) {
      const auto image = readImage((fs::path(path).parent_path() / r.image).string());
      if (!image) return Error{image.error()};
      images.emplace(r.image, *image);
    }
    const Image& image = images.at(r.image);
    for (int py = r.top; py < r.bottom; ++py)
      for (int px = r.left; px < r.right; ++px)
        pixels.push_back({ring(image.pixel(px, py), distances(px, py, ring.centre)), r.colour});
  }
  return pixels;
}

Split splitLabelled(const LabelledPixels& pixels, double heldOutShare, Random& random) {
  LabelledPixels mixed = pixels;
  for (std::size_t i = mixed.size(); i > 1; --i)
    std::swap(mixed[i - 1], mixed[random.index(static_cast<std::uint32_t>(i))]);
  const auto out = static_cast<std::ptrdiff_t>(heldOutShare * static_cast<double>(mixed.size()));
  return {{mixed.begin() + out, mixed.end()}, {mixed.begin(), mixed.begin() + out}};
}

}  // namespace kelpie::calibrate
