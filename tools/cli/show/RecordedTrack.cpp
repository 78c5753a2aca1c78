// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/show/RecordedTrack.h"

namespace kelpie::cli {
namespace {

Angle between(Angle older, Angle newer, double share) {
  return newer - (newer - older) * (1.0 - share);
}

// A row of between two: `share` of the way from the one to the other.
RecordedRow between(const RecordedRow& older, const RecordedRow& newer, double share) {
  RecordedRow row = newer;
  row.neckTilt = between(older.neckTilt, newer.neckTilt, share);
  row.headPan = between(older.headPan, newer.headPan, share);
  row.headNod = between(older.headNod, newer.headNod, share);
  row.stance.shoulderHeight +=
      (1.0 - share) * (older.stance.shoulderHeight - newer.stance.shoulderHeight);
  row.stance.bodyTilt = between(older.stance.bodyTilt, newer.stance.bodyTilt, share);
  return row;
}

}  // namespace

RecordedTrack::RecordedTrack(const std::vector<RecordedRow>& rows) : rows_(rows) {
  Way way;
  for (const RecordedRow& row : rows) {
    const Odometry& step = row.odometry;
    way = {way.forward + step.forward, way.left + step.left, way.turn + step.turn.rad()};
    ways_.push_back(way);
  }
}

RecordedTrack::Place RecordedTrack::placeAt(std::size_t n, double time) const {
  while (n > 0 && rows_[n - 1].time >= time) --n;
  if (n == 0) return {0, 1.0};
  const double start = rows_[n - 1].time;
  return {n, (time - start) / (rows_[n].time - start)};
}

RecordedTrack::Way RecordedTrack::wayAt(const Place& place) const {
  const Way& to = ways_[place.newer];
  if (place.newer == 0) return to;
  const Way& from = ways_[place.newer - 1];
  const auto mix = [&](double a, double b) { return b - (1.0 - place.share) * (b - a); };
  return {mix(from.forward, to.forward), mix(from.left, to.left), mix(from.turn, to.turn)};
}

FrameInput RecordedTrack::input(std::size_t n, double lag) {
  const Place place = placeAt(n, rows_[n].time - lag);
  const RecordedRow* const older = place.newer > 0 ? &rows_[place.newer - 1] : nullptr;
  RecordedRow row = rows_[place.newer];
  const HeadRate rate = frameInput(0, row, older).headRate;
  if (older != nullptr) row = between(*older, row, place.share);
  const Way way = wayAt(place);
  row.odometry = {
      way.forward - taken_.forward, way.left - taken_.left, Angle::rad(way.turn - taken_.turn), {}};
  taken_ = way;
  row.time = rows_[n].time;
  FrameInput input =
      frameInput(static_cast<std::uint32_t>(n), row, n > 0 ? &rows_[n - 1] : nullptr);
  input.headRate = rate;
  return input;
}

}  // namespace kelpie::cli
