// SPDX-License-Identifier: Apache-2.0
#include "vision/Blobs.h"

#include <algorithm>

namespace kelpie::vision {
namespace {

constexpr std::uint16_t kNoBlob = 0xFFFF;

bool formsBlobs(ColourClass c) { return c >= ColourClass::orange && c <= ColourClass::robotRed; }

ColourClass onLattice(const Sampler& sampler, int row, int column) {
  return sampler.classAt(kLatticeLeft + column * kLatticeStep, kLatticeTop + row * kLatticeStep);
}

// Appends the runs of one lattice row; the number that did not fit.
std::uint32_t collectRuns(const Sampler& sampler, int row, RunBuffer& runs) {
  std::uint32_t lost = 0;
  int first = 0;
  while (first < kLatticeColumns) {
    const ColourClass colour = onLattice(sampler, row, first);
    int end = first + 1;
    while (end < kLatticeColumns && onLattice(sampler, row, end) == colour) ++end;
    if (formsBlobs(colour)) {
      Run run{colour,
              static_cast<std::uint8_t>(row),
              static_cast<std::uint8_t>(first),
              static_cast<std::uint8_t>(end - 1),
              static_cast<std::uint16_t>(runs.size()),
              kNoBlob};
      if (!runs.push_back(run)) ++lost;
    }
    first = end;
  }
  return lost;
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

void addRun(Blob& blob, const Run& run) {
  const double count = run.last - run.first + 1;
  const double x = kLatticeLeft + 0.5 + kLatticeStep * 0.5 * (run.first + run.last);
  const double y = kLatticeTop + 0.5 + kLatticeStep * run.row;
  const double half = 0.5 * kLatticeStep;
  const PixelBox box{x - half * count, y - half, x + half * count, y + half};
  const double before = blob.samples;
  const double total = before + count;
  if (before == 0.0) blob.box = box;
  blob.box = {std::min(blob.box.left, box.left), std::min(blob.box.top, box.top),
              std::max(blob.box.right, box.right), std::max(blob.box.bottom, box.bottom)};
  blob.centre = {(blob.centre.x * before + x * count) / total,
                 (blob.centre.y * before + y * count) / total};
  blob.samples += static_cast<std::uint32_t>(run.last - run.first + 1);
}

std::uint32_t collectBlobs(RunBuffer& runs, BlobBuffer& blobs) {
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
    addRun(blobs[root.blob], runs[i]);
  }
  return lost;
}

}  // namespace

std::uint32_t findBlobs(const Sampler& sampler, RunBuffer& runs, BlobBuffer& blobs) {
  runs.clear();
  blobs.clear();
  std::uint32_t lost = 0;
  std::size_t rowAbove = 0;
  for (int row = 0; row < kLatticeRows; ++row) {
    const std::size_t rowStart = runs.size();
    lost += collectRuns(sampler, row, runs);
    joinRows(runs, rowAbove, rowStart, runs.size());
    rowAbove = rowStart;
  }
  return lost + collectBlobs(runs, blobs);
}

}  // namespace kelpie::vision
