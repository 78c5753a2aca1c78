// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/colour/GenuineFrames.h"

#include "tools/calibrate/Images.h"
#include "tools/calibrate/SharedData.h"
#include "tools/calibrate/ring/Ring2005.h"
#include "tools/calibrate/ring/RingLearner.h"

namespace kelpie::experiments {

using cli::Json;

namespace {

using calibrate::Sheet;
using calibrate::SheetPixel;

constexpr std::array<const char*, 3> kNames = {"y", "cr", "cb"};
constexpr std::array<const char*, 2> kCarpets = {"frame3", "frame4"};  // frame 1 shows a carton
// With one colour of surface gain and offset cannot be distinguished: the published polynomial gets
// the weight of a twentieth of the pixels.
constexpr double kPriorShare = 0.05;

// Spread of the ring means about the image's centre, of what correct(pixel, channel) gives.
template <class Correct>
Json spreads(const Sheet& surface, Correct&& correct) {
  Json out;
  for (std::size_t c = 0; c < 3; ++c) {
    calibrate::RingMeans rings;
    for (const SheetPixel& p : surface.pixels)
      rings.add(calibrate::distanceTo({kImageWidth / 2.0, kImageHeight / 2.0}, p), correct(p, c));
    out[kNames[c]] = rings.spread();
  }
  return out;
}

Json withTable(const Sheet& surface, const vision::RingTable& table) {
  const vision::RingDistances distances;
  return spreads(surface, [&](const SheetPixel& p, std::size_t c) {
    return calibrate::channelOf(table(p.value, distances(p.px, p.py, table.centre)), c);
  });
}

Json spreadsOf(const Sheet& surface, const vision::RingTable& learnt,
               const Expected<calibrate::Ring2005>& real) {
  Json out{{"pixels", surface.pixels.size()}};
  out["raw_spread_levels"] = spreads(
      surface, [](const SheetPixel& p, std::size_t c) { return calibrate::channelOf(p.value, c); });
  out["polynomial_2006_spread_levels"] =
      withTable(surface, buildRingTable(vision::ringModel2006()));
  out["learnt_spread_levels"] = withTable(surface, learnt);
  if (real)
    out["table_2005_spread_levels"] = spreads(surface, [&](const SheetPixel& p, std::size_t c) {
      return real->corrected(p.px, p.py, p.value, c);
    });
  return out;
}

Json absent(const std::string& why) { return {{"figures", nullptr}, {"note", why}}; }

}  // namespace

Json genuineFrames() {
  std::vector<Sheet> surfaces;
  for (const char* name : kCarpets) {
    const auto image =
        calibrate::readImage(calibrate::sharedData() + "frames-ers7/" + name + "_y_cr_cb_rows.bin");
    if (!image) return absent("without ../shared/data/frames-ers7");
    surfaces.push_back(calibrate::dominantSurface(name, *image, 1));
  }
  calibrate::RingLearnParams params;
  params.findCentre = false;  // a carpet that fills the lower half does not show it
  params.maxResidual = 30.0;  // nor is it even: 15 levels of texture and shade
  params.priorShare = kPriorShare;
  const auto fit = calibrate::learnRing(surfaces, params);
  if (!fit) return absent(fit.error());
  const auto learnt = buildRingTable(fit->model);
  const auto real = calibrate::loadRing2005(calibrate::sharedData() + "camera");
  Json out;
  for (const Sheet& surface : surfaces) out[surface.name] = spreadsOf(surface, learnt, real);
  return out;
}

}  // namespace kelpie::experiments
