// SPDX-License-Identifier: Apache-2.0
// Foreign recordings in a folder: frames/NNNNNN.yuv (planes Y, Cr, Cb of 208 x 160 bytes) or .png
// (RGB), and sensors.csv with one row a frame. recordingHelp() says it all to a user.
#pragma once

#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "robot/core/types/FrameInput.h"

namespace kelpie::cli {

// One row of sensors.csv as a FrameInput without its image.
struct RecordedRow {
  double time = 0.0;  // s
  Angle neckTilt;
  Angle headPan;
  Angle headNod;
  Stance stance;
  Odometry odometry;  // since the row before
};

// What a recording's folder must hold, with an example of sensors.csv that is accepted as it is.
std::string recordingHelp();
// Errors are one line that names the file: all that is wrong with the header, or the first row that
// is wrong and how many more are.
Expected<std::vector<RecordedRow>> readSensorRows(const std::string& path);
// The frame files by number; an error when a number is missing or there twice, a name is not a
// number, or nothing is there.
Expected<std::vector<std::string>> listFrames(const std::string& folder);

struct Recording {
  std::vector<std::string> files;
  std::vector<RecordedRow> rows;  // one a file
};
// Both of a folder; an error as above, or when there are not as many rows as frames.
Expected<Recording> readRecording(const std::string& folder);

// Fills everything but the image; `previous` is null for the first row.
FrameInput frameInput(std::uint32_t frame, const RecordedRow& row, const RecordedRow* previous);

}  // namespace kelpie::cli
