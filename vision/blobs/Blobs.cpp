// SPDX-License-Identifier: Apache-2.0
#include "vision/blobs/Blobs.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace kelpie::vision {
namespace {

constexpr std::uint16_t kNoBlob = 0xFFFF;
constexpr int kMaxSamples = 160;  // of a lattice row; the image's diagonal has 132
constexpr int kAtOnce = 8;        // samples looked at together
using RowClasses = std::array<std::uint8_t, kMaxSamples>;

bool formsBlobs(ColourClass c) { return c >= ColourClass::orange && c <= ColourClass::robotRed; }

constexpr std::uint64_t kOneInEachByte = 0x0101010101010101ULL;
constexpr std::size_t kTopBit = 0x80U;       // of a byte
constexpr std::size_t kBelowTopBit = 0x7FU;  // all others of it

std::uint64_t inEachByte(std::size_t value) { return kOneInEachByte * value; }

// Whether one of eight classes forms blobs: each in a byte of its own, whose top bit the sums set
// from that class on.
bool anyFormsBlobs(const std::uint8_t* classes) {
  std::uint64_t eight = 0;
  std::memcpy(&eight, classes, sizeof eight);
  const std::uint64_t fromOrange = eight + inEachByte(kTopBit - index(ColourClass::orange));
  const std::uint64_t aboveRed = eight + inEachByte(kBelowTopBit - index(ColourClass::robotRed));
  return (fromOrange & ~aboveRed & inEachByte(kTopBit)) != 0;
}

// The first sample from i on whose class forms blobs, or the count: most of an image is carpet.
int nextOfBlobs(const RowClasses& classes, int i, int count) {
  const auto at = [&classes](int k) { return classes.data() + k; };
  while (i < count && !anyFormsBlobs(at(i))) i += kAtOnce;
  while (i < count && !formsBlobs(static_cast<ColourClass>(*at(i)))) ++i;
  return i;
}

// Appends the runs of one lattice row.
void collectRuns(const Sampler& sampler, const Lattice& lattice, int rowIndex, RunBuffer& runs,
                 BlobCounts& counts) {
  const LatticeRow row = lattice.row(rowIndex);
  counts.samples += static_cast<std::uint32_t>(row.count);
  RowClasses classes;
  const int count = std::min(row.count, kMaxSamples - kAtOnce);
  sampler.classifyRow(row.x, row.y, lattice.stepX(), lattice.stepY(), count, classes.data());
  std::fill_n(classes.data() + count, kAtOnce, static_cast<std::uint8_t>(ColourClass::none));
  const auto height = static_cast<std::uint8_t>(lattice.height(rowIndex));
  for (int i = nextOfBlobs(classes, 0, count); i < count; i = nextOfBlobs(classes, i, count)) {
    const int first = i;
    const std::uint8_t colour = classes[static_cast<std::size_t>(first)];
    while (classes[static_cast<std::size_t>(i)] == colour) ++i;
    const Run run{static_cast<ColourClass>(colour),
                  static_cast<std::uint8_t>(rowIndex),
                  static_cast<std::uint8_t>(row.first + first),
                  static_cast<std::uint8_t>(row.first + i - 1),
                  height,
                  static_cast<std::uint16_t>(runs.size()),
                  kNoBlob};
    if (!runs.push_back(run)) ++counts.lost;
  }
}

std::uint16_t rootOf(RunBuffer& runs, std::uint16_t run) {
  while (runs[run].parent != run) {
    runs[run].parent = runs[runs[run].parent].parent;
    run = runs[run].parent;
  }
  return run;
}

void join(RunBuffer& runs, std::size_t a, std::size_t b) {
  const std::uint16_t rootA = rootOf(runs, static_cast<std::uint16_t>(a));
  const std::uint16_t rootB = rootOf(runs, static_cast<std::uint16_t>(b));
  if (rootA < rootB) {
    runs[rootB].parent = rootA;
  } else {
    runs[rootA].parent = rootB;
  }
}

// Joins the runs [middle, end) of one row with the touching runs [begin, middle) of the row above.
void joinRows(RunBuffer& runs, std::size_t begin, std::size_t middle, std::size_t end) {
  std::size_t above = begin;
  for (std::size_t i = middle; i < end; ++i) {
    while (above < middle && runs[above].last + 1 < runs[i].first) ++above;
    for (std::size_t j = above; j < middle && runs[j].first <= runs[i].last + 1; ++j) {
      if (runs[j].colour == runs[i].colour) join(runs, i, j);
    }
  }
}

// The blob's middle is the sum of its samples until all are there: halves of pixels, so the sum is
// exact, and two divisions a blob in place of two a run.
void addRun(const Lattice& lattice, Blob& blob, const Run& run) {
  const double width = run.last - run.first + 1;
  const double count = width * run.height;
  const double u = lattice.u(0.5 * (run.first + run.last));
  const double v = lattice.v(run.row);
  const double half = 0.5 * kLatticeStep;
  const LevelBox box{u - half * width, v - half * run.height, u + half * width,
                     v + half * run.height};
  if (blob.samples == 0) blob.box = box;
  blob.box = {std::min(blob.box.left, box.left), std::min(blob.box.top, box.top),
              std::max(blob.box.right, box.right), std::max(blob.box.bottom, box.bottom)};
  blob.middle.u += u * count;
  blob.middle.v += v * count;
  blob.samples += static_cast<std::uint32_t>(count);
}

std::uint32_t collectBlobs(const Lattice& lattice, RunBuffer& runs, BlobBuffer& blobs) {
  std::uint32_t lost = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    Run& root = runs[rootOf(runs, static_cast<std::uint16_t>(i))];
    if (root.blob == kNoBlob) {
      Blob fresh;
      fresh.colour = root.colour;
      if (!blobs.push_back(fresh)) {
        ++lost;
        continue;
      }
      root.blob = static_cast<std::uint16_t>(blobs.size() - 1);
    }
    addRun(lattice, blobs[root.blob], runs[i]);
  }
  for (Blob& blob : blobs) {
    blob.middle = {blob.middle.u / blob.samples, blob.middle.v / blob.samples};
    blob.centre = lattice.frame().toImage(blob.middle);
  }
  return lost;
}

}  // namespace

BlobCounts findBlobs(const Sampler& sampler, const Lattice& lattice, RunBuffer& runs,
                     BlobBuffer& blobs) {
  runs.clear();
  blobs.clear();
  BlobCounts counts;
  std::size_t rowAbove = 0;
  for (int row = 0; row < lattice.rows(); row += lattice.height(row)) {
    const std::size_t rowStart = runs.size();
    collectRuns(sampler, lattice, row, runs, counts);
    joinRows(runs, rowAbove, rowStart, runs.size());
    rowAbove = rowStart;
  }
  counts.lost += collectBlobs(lattice, runs, blobs);
  return counts;
}

}  // namespace kelpie::vision
