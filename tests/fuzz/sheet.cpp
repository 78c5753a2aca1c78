// SPDX-License-Identifier: Apache-2.0
// Sheets that people write: sensors.csv of a recording, labelled pixels, labelled boxes, by the
// kind that the first byte says. A refusal is a line that names the file.
#include "robot/core/fields/FieldCheck.h"
#include "tests/fuzz/Input.h"
#include "tools/calibrate/colour/Labels.h"
#include "tools/cli/log/Recording.h"

namespace {

using namespace kelpie;
using fuzz::require;

void checkSensors(const std::string& name) {
  const auto rows = cli::readSensorRows(name);
  if (!rows) return fuzz::requireLine(rows.error(), name);
  const cli::RecordedRow* previous = nullptr;
  for (const cli::RecordedRow& row : *rows) {
    std::string why;
    require(verify(cli::frameInput(1, row, previous), &why), "a row is in range: " + why);
    require(previous == nullptr || previous->time < row.time, "rows follow in time");
    previous = &row;
  }
}

void checkLabels(const Expected<calibrate::LabelledPixels>& pixels, const std::string& name) {
  if (!pixels) return;  // of an image that is not there, the line names the image
  require(!pixels->empty(), name + " has labels");
  for (const calibrate::LabelledPixel& pixel : *pixels)
    require(static_cast<std::size_t>(pixel.colour) < vision::kColourClassCount, "a known class");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const vision::RingTable kRing = vision::buildRingTable({});
  fuzz::Input input(data, size);
  const unsigned kind = input.byte() % 3U;
  const fuzz::File file(input.rest(), ".csv");
  if (kind == 0) checkSensors(file.name());
  if (kind == 1) checkLabels(calibrate::readLabelledCsv(file.name()), file.name());
  if (kind == 2) checkLabels(calibrate::readRegions(file.name(), kRing), file.name());
  return 0;
}
