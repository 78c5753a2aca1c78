// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/log/Recording.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "robot/core/fields/FieldCheck.h"
#include "tools/calibrate/Csv.h"
#include "tools/picture/FileNames.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

struct Column {
  const char* name;
  const char* what;
};
constexpr std::size_t kColumns = 9;
constexpr std::array<Column, kColumns> kTable = {{
    {"t_s", "time of the exposure's middle; each row 0.001 to 10 s after the one before"},
    {"neck_tilt_deg", "joint at the foot of the neck, up positive: 0 neck upright, -75 lowest"},
    {"head_pan_deg", "left positive: 0 straight ahead, 88 far left, -88 far right"},
    {"head_nod_deg", "joint at the top of the neck, up positive: -15 to 45"},
    {"body_tilt_deg", "how far the body leans, nose down positive"},
    {"shoulder_height_mm", "front shoulder axis above the ground, 0 to 300"},
    {"odo_forward_cm", "way since the row before, forward positive, back negative; 0 at first"},
    {"odo_left_cm", "way to the left since the row before, left positive"},
    {"odo_turn_deg", "turn since the row before, left (counter-clockwise) positive"},
}};
constexpr double kLongest = 1e6;   // s, of a recording
constexpr double kMinStep = 1e-3;  // s between frames; a thirtieth of a real one
constexpr double kTurn = 360.0;    // deg; a joint or a step that says more is a slip of units

constexpr const char* kHelpOfFrames =
    R"(DIR holds the images and one table:

  frames/000000.yuv, frames/000001.yuv, ...   one file an image, its name is its number; no gaps
  sensors.csv                                 one row an image, in the same order

Names and endings in capitals, as a FAT stick gives them, and FRAME000.YUV are taken as well.
An image is 208 x 160 pixels, either
  .yuv  99840 bytes: the planes Y, Cr, Cb one after the other, in this order (Cr comes before Cb),
        each of 208 x 160 = 33280 bytes, rows from the top, pixels from the left; grey has Cr and
        Cb 128
  .png  RGB, 8 bits; it is turned into Y, Cr, Cb (all of 0 to 255, as in JPEG)

sensors.csv has a header and nine numbers a row, parted by commas; angles in degrees, left and up
positive, but body_tilt_deg nose down positive:
)";
constexpr const char* kHelpOfTyping =
    R"(
A robot that stands has a body_tilt_deg of 10.5 and a shoulder_height_mm of 102 in Kelpie's own
stance (14.25 and 100 in that of 2006), a neck_tilt_deg of -20 or so, and 0 in the odo columns.

Example of a sensors.csv for two images (head turning left, robot walking):
)";
constexpr const char* kExampleRows =
    "0.0000,-20,0,0,10.5,102,0,0,0\n"
    "0.0333,-20,3.5,0,10.5,102,0.7,0,-0.4\n";

std::string headerText() {
  std::string text;
  for (const auto& column : kTable) text += (text.empty() ? "" : ",") + std::string(column.name);
  return text;
}

bool isAngle(std::size_t column) {
  const std::string_view name = kTable[column].name;
  return name.find("_deg") != name.npos;
}

std::string_view trimmed(std::string_view text) {
  const auto from = text.find_first_not_of(" \t\r");
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
}

std::vector<std::string> trimmedCells(const std::string& line) {
  std::vector<std::string> cells;
  for (const auto cell : calibrate::cellsOf(line, ',')) cells.emplace_back(trimmed(cell));
  return cells;
}

// Adds " WHAT a, b" to the complaints, if there is anything to list.
void addNames(const char* what, const std::vector<std::string>& names, std::string& complaints) {
  if (names.empty()) return;
  complaints += (complaints.empty() ? "" : "; ") + std::string(what);
  for (std::size_t i = 0; i < names.size(); ++i) complaints += (i > 0 ? ", " : " ") + names[i];
}

// All that is wrong with a header; empty when nothing is.
std::string headerComplaints(const std::string& line) {
  const auto cells = trimmedCells(line);
  std::vector<std::string> missing, unknown, twice;
  bool ordered = true;
  for (std::size_t i = 0; i < kColumns; ++i) {
    const auto times = std::count(cells.begin(), cells.end(), kTable[i].name);
    if (times == 0) missing.emplace_back(kTable[i].name);
    if (times > 1) twice.emplace_back(kTable[i].name);
    ordered = ordered && i < cells.size() && cells[i] == kTable[i].name;
  }
  for (const auto& cell : cells) {
    const bool known = std::any_of(kTable.begin(), kTable.end(),
                                   [&](const Column& column) { return cell == column.name; });
    if (!known) unknown.push_back("'" + cell + "'");
  }
  std::string complaints;
  addNames("missing", missing, complaints);
  addNames("unknown", unknown, complaints);
  addNames("more than once", twice, complaints);
  if (complaints.empty() && !ordered) complaints = "the columns are in the wrong order";
  return complaints;
}

using Numbers = std::array<double, kColumns>;

// The nine numbers of a row, finite and with angles that can be meant.
Expected<Numbers> parseNumbers(const std::string& line) {
  const auto cells = trimmedCells(line);
  if (cells.size() != kColumns)
    return Error{fmt::format("{} columns, expected {}{}", cells.size(), kColumns,
                             cells.size() > kColumns || line.find(';') != std::string::npos
                                 ? "; write numbers with a decimal point (12.5, not 12,5)"
                                 : "")};
  Numbers numbers{};
  for (std::size_t i = 0; i < kColumns; ++i) {
    if (!calibrate::parseNumber(cells[i], numbers[i]))
      return Error{fmt::format("{}: '{}' is not a number", kTable[i].name, cells[i])};
    if (isAngle(i) && std::fabs(numbers[i]) > kTurn)
      return Error{fmt::format("{}: {}, expected angles in -360..360", kTable[i].name, numbers[i])};
  }
  return numbers;
}

RecordedRow rowOf(const Numbers& n) {
  RecordedRow row;
  row.time = n[0];
  row.neckTilt = Angle::deg(n[1]);
  row.headPan = Angle::deg(n[2]);
  row.headNod = Angle::deg(n[3]);
  row.stance = {n[5] / 10.0, Angle::deg(n[4]), {}};
  row.odometry = {n[6], n[7], Angle::deg(n[8]), {}};
  return row;
}

// Whether a robot can have given this row after the one before.
Status checkRow(const RecordedRow& row, const RecordedRow* previous) {
  if (!(row.time >= 0.0 && row.time < kLongest))
    return Error{fmt::format("t_s: {}, expected 0..{} s", row.time, kLongest)};
  if (previous != nullptr && row.time < previous->time + kMinStep)
    return Error{
        fmt::format("t_s: time does not increase by {} s, as in frames of a camera", kMinStep)};
  std::string why;
  if (!verify(frameInput(0, row, previous), &why)) return Error{why};
  return Done{};
}

// Takes the rows one by one and keeps what is wrong with the first wrong one.
class RowReader {
 public:
  void take(const std::string& line, int number) {
    const auto numbers = parseNumbers(line);
    if (!numbers) return report(number, numbers.error());
    const RecordedRow row = rowOf(*numbers);
    const Status checked = checkRow(row, rows_.empty() ? nullptr : &rows_.back());
    if (!checked) report(number, checked.error());
    rows_.push_back(row);  // a wrong one too: the next is judged against what stands before it
  }
  Expected<std::vector<RecordedRow>> result(const std::string& path) const {
    if (wrong_ == 0) return rows_;
    const std::string more = wrong_ == 1   ? ""
                             : wrong_ == 2 ? "; 1 more row is wrong"
                                           : fmt::format("; {} more rows are wrong", wrong_ - 1);
    return Error{path + first_ + more};
  }

 private:
  void report(int number, const std::string& what) {
    if (wrong_++ == 0) first_ = fmt::format(":{}: {}", number, what);
  }
  std::vector<RecordedRow> rows_;
  std::string first_;
  int wrong_ = 0;
};

struct FrameFile {
  std::uint64_t number = 0;
  std::string name;
};

// The number that a frame's file is named by, with or without "frame" before it; false for any
// other name.
bool parseFrameNumber(const fs::path& path, std::uint64_t& number) {
  std::string stem = picture::lowerCase(path.stem().string());
  if (stem.compare(0, 5, "frame") == 0) stem.erase(0, 5);
  if (stem.empty() || stem.size() > 18 || stem.find_first_not_of("0123456789") != stem.npos)
    return false;
  number = std::stoull(stem);
  return true;
}

}  // namespace

std::string recordingHelp() {
  std::string text = kHelpOfFrames;
  for (const auto& column : kTable) text += fmt::format("  {:<19} {}\n", column.name, column.what);
  return text + kHelpOfTyping + headerText() + "\n" + kExampleRows;
}

Expected<std::vector<RecordedRow>> readSensorRows(const std::string& path) {
  std::ifstream file(path);
  if (!file) return Error{path + ": cannot be opened"};
  std::string line;
  std::getline(file, line);
  if (line.compare(0, 3, "\xEF\xBB\xBF") == 0) line.erase(0, 3);  // spreadsheets write a mark
  const std::string complaints = headerComplaints(line);
  if (!complaints.empty())
    return Error{path + ":1: " + complaints + "; the header must be " + headerText() +
                 (line.find(';') == std::string::npos ? "" : ", parted by commas")};
  RowReader reader;
  for (int number = 2; std::getline(file, line); ++number)
    if (!trimmed(line).empty()) reader.take(line, number);
  return reader.result(path);
}

Expected<std::vector<std::string>> listFrames(const std::string& folder) {
  std::error_code error;
  std::vector<FrameFile> files;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const auto extension = picture::endingOf(entry.path());
    if (extension != ".yuv" && extension != ".png") continue;
    FrameFile file{0, entry.path().filename().string()};
    if (!parseFrameNumber(entry.path(), file.number))
      return Error{fmt::format("{}/{}: its name must be its number, such as 000000{}", folder,
                               file.name, extension)};
    files.push_back(file);
  }
  if (error) return Error{folder + ": " + error.message()};
  if (files.empty()) return Error{folder + ": no .yuv or .png frames"};
  std::sort(files.begin(), files.end(),
            [](const FrameFile& a, const FrameFile& b) { return a.number < b.number; });
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (i > 0 && files[i].number != files[i - 1].number + 1)
      return Error{fmt::format("{}: {} follows {}: numbers must follow without a gap", folder,
                               files[i].name, files[i - 1].name)};
    paths.push_back(folder + "/" + files[i].name);
  }
  return paths;
}

Expected<Recording> readRecording(const std::string& folder) {
  const auto files = listFrames(picture::fileIn(folder, "frames"));
  if (!files) return Error{files.error()};
  const std::string table = picture::fileIn(folder, "sensors.csv");
  const auto rows = readSensorRows(table);
  if (!rows) return Error{rows.error()};
  if (rows->size() != files->size())
    return Error{fmt::format("{}: {} rows for {} frames", table, rows->size(), files->size())};
  return Recording{*files, *rows};
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
