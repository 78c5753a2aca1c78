// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/Recording.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "robot/core/FieldCheck.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHeader =
    "t_s,neck_tilt_deg,head_pan_deg,head_nod_deg,body_tilt_deg,shoulder_height_mm,"
    "odo_forward_cm,odo_left_cm,odo_turn_deg";
constexpr std::size_t kColumns = 9;
constexpr double kLongest = 1e6;     // s, of a recording
constexpr double kLeastStep = 1e-3;  // s between frames; a thirtieth of a real one
constexpr double kTurn = 360.0;      // deg; a joint or a step that says more is a slip of units

void dropCarriageReturn(std::string& line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
}

bool isAngle(std::size_t column) { return (column >= 1 && column <= 4) || column == 8; }

// The nine numbers of a row; nothing when there are fewer, more, or one is not a finite number or
// no angle.
bool parseNumbers(const std::string& line, std::array<double, kColumns>& numbers) {
  const char* next = line.data();
  const char* const end = line.data() + line.size();
  for (std::size_t i = 0; i < kColumns; ++i) {
    if (i > 0 && (next == end || *next++ != ',')) return false;
    while (next != end && *next == ' ') ++next;
    const auto [rest, error] = std::from_chars(next, end, numbers[i]);
    if (error != std::errc() || !std::isfinite(numbers[i])) return false;
    if (isAngle(i) && std::fabs(numbers[i]) > kTurn) return false;
    next = rest;
  }
  return next == end;
}

RecordedRow rowOf(const std::array<double, kColumns>& n) {
  RecordedRow row;
  row.time = n[0];
  row.neckTilt = Angle::deg(n[1]);
  row.headPan = Angle::deg(n[2]);
  row.headNod = Angle::deg(n[3]);
  row.stance = {n[5] / 10.0, Angle::deg(n[4])};
  row.odometry = {n[6], n[7], Angle::deg(n[8])};
  return row;
}

}  // namespace

Expected<std::vector<RecordedRow>> readSensorRows(const std::string& path) {
  std::ifstream file(path);
  if (!file) return Error{path + ": cannot be opened"};
  std::string line;
  std::getline(file, line);
  dropCarriageReturn(line);
  if (line.compare(0, 3, "\xEF\xBB\xBF") == 0) line.erase(0, 3);  // spreadsheets write a mark
  if (line != kHeader) return Error{path + ":1: the header must be " + kHeader};
  std::vector<RecordedRow> rows;
  for (int number = 2; std::getline(file, line); ++number) {
    dropCarriageReturn(line);
    if (line.empty()) continue;
    std::array<double, kColumns> numbers{};
    if (!parseNumbers(line, numbers))
      return Error{
          fmt::format("{}:{}: expected {} numbers, angles in -360..360", path, number, kColumns)};
    if (!rows.empty() && numbers[0] < rows.back().time + kLeastStep)
      return Error{fmt::format("{}:{}: time does not increase by {} s", path, number, kLeastStep)};
    if (!(numbers[0] >= 0.0 && numbers[0] < kLongest))
      return Error{fmt::format("{}:{}: time must lie in 0..{} s", path, number, kLongest)};
    const RecordedRow row = rowOf(numbers);
    std::string why;
    if (!verify(frameInput(0, row, rows.empty() ? nullptr : &rows.back()), &why))
      return Error{fmt::format("{}:{}: {}", path, number, why)};
    rows.push_back(row);
  }
  return rows;
}

Expected<std::vector<std::string>> listFrames(const std::string& folder) {
  std::error_code error;
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const auto extension = entry.path().extension();
    if (extension == ".yuv" || extension == ".png") files.push_back(entry.path().string());
  }
  if (error) return Error{folder + ": " + error.message()};
  if (files.empty()) return Error{folder + ": no .yuv or .png frames"};
  std::sort(files.begin(), files.end());
  return files;
}

FrameInput frameInput(std::uint32_t frame, const RecordedRow& row, const RecordedRow* previous) {
  FrameInput input;
  input.frame = frame;
  input.time = TimeUs::fromSeconds(row.time);
  input.sensors.joints[Joint::neckTilt] = row.neckTilt;
  input.sensors.joints[Joint::headPan] = row.headPan;
  input.sensors.joints[Joint::headNod] = row.headNod;
  input.stance = row.stance;
  input.odometry = row.odometry;
  input.motion.ready = true;
  if (previous == nullptr) return input;
  input.elapsed = row.time - previous->time;
  input.headRate = {(row.neckTilt - previous->neckTilt).rad() / input.elapsed,
                    (row.headPan - previous->headPan).rad() / input.elapsed,
                    (row.headNod - previous->headNod).rad() / input.elapsed};
  return input;
}

}  // namespace kelpie::cli
