// SPDX-License-Identifier: Apache-2.0
// Colour classification. First on pixels labelled by hand on real robots, which are the hard cases:
// the trained table, the 2005 table and nine nearest neighbours on the same held-out quarter, over
// seeded splits (the labels do not tell their image or robot, and no two have one colour), which
// class is taken for which, and how the table's size counts. Then on rendered views with every
// artefact: the share of pixels inside one surface that get its class, with the ring correction and
// without, in the middle and in the corners. A view's robot has a colour shift of its own; it is
// calibrated as `kelpie calibrate shift` does it, with seven papers before robot and base, and
// folded into the ring table. "unshifted" figures are those of a robot whose shift nobody measured.
#include <cmath>
#include <memory>

#include "tools/calibrate/SharedData.h"
#include "tools/calibrate/colour/KernelTrainer.h"
#include "tools/calibrate/colour/Shift.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/views/View.h"
#include "vision/pixels/ClassPicture.h"

namespace kelpie::experiments {
namespace {

using calibrate::LabelledPixels;
using calibrate::TableBits;
using vision::ColourClass;
using vision::kColourClassCount;

constexpr double kHeldOut = 0.25;
constexpr int kSplits = 40;      // sd 0.002 of the difference to the neighbours, which is 0.012
constexpr int kSizeSplits = 10;  // of them judge the table's sizes: fine ones take a second each
constexpr std::size_t kNeighbours = 9;
constexpr std::array<TableBits, 6> kSizes = {
    {{4, 5, 5}, {5, 5, 5}, {4, 6, 6}, {5, 6, 6}, {6, 6, 6}, {7, 7, 7}}};

using calibrate::addTo;
using calibrate::Confusion;

// Sums over the splits. "alike" is trained with every class alike, the ball as well.
struct LabelledFigures {
  Confusion table{};
  Confusion alike{};
  Confusion table2005{};
  Confusion neighbours{};
  std::array<Confusion, kSizes.size()> bySize{};
};

void addSizes(const calibrate::Split& split, LabelledFigures& sum) {
  for (std::size_t i = 0; i < kSizes.size(); ++i)
    addTo(sum.bySize[i], confusionOf(trainClasses(split.training, {}, kSizes[i]), split.heldOut));
}

void addSplit(const calibrate::Split& split, const vision::ColourTable& table2005,
              LabelledFigures& sum) {
  calibrate::KernelParams alike;
  alike.ballCost = 1.0;
  const auto add = [&](Confusion& to, const auto& classOf) {
    addTo(to, confusionOf(classOf, split.heldOut));
  };
  add(sum.table, robotTable(trainClasses(split.training, {}, {})));
  add(sum.alike, trainClasses(split.training, alike, {}));
  add(sum.table2005, table2005);
  add(sum.neighbours,
      [&](Yuv value) { return calibrate::nearestNeighbours(split.training, value, kNeighbours); });
}

void addScores(Json& out, const std::string& ending, const Confusion& confusion) {
  out["accuracy" + ending] = calibrate::accuracyOf(confusion);
  out["orange_recall" + ending] = calibrate::recallOf(confusion, ColourClass::orange);
  out["orange_precision" + ending] = calibrate::precisionOf(confusion, ColourClass::orange);
}

// Rows are what was labelled, columns what was found, in shares of the row.
Json confusionFigures(const Confusion& confusion) {
  Json rows;
  for (std::size_t i = 0; i < kColourClassCount; ++i) {
    double all = 0.0;
    for (const int count : confusion[i]) all += count;
    if (all == 0.0) continue;
    for (std::size_t j = 0; j < kColourClassCount; ++j)
      if (confusion[i][j] > 0)
        rows[vision::kColourNames[i]][vision::kColourNames[j]] = confusion[i][j] / all;
  }
  return rows;
}

Json sizeFigures(const LabelledFigures& figures) {
  Json sizes;
  for (std::size_t i = 0; i < kSizes.size(); ++i) {
    const TableBits& b = kSizes[i];
    const std::string name = std::to_string(b.y) + std::to_string(b.cr) + std::to_string(b.cb);
    sizes["bits_" + name] = {{"bytes", std::size_t{1} << (b.y + b.cr + b.cb - 1)},
                             {"accuracy", calibrate::accuracyOf(figures.bySize[i])}};
  }
  return sizes;
}

Json labelledFigures(Random& random) {
  const auto folder = calibrate::sharedData() + "colour/";
  const auto pixels = calibrate::readLabelledCsv(folder + "labelled_samples.csv");
  const auto table2005 = vision::loadColourTable(folder + "nnmc_2005.bin");
  if (!pixels || !table2005)
    return {{"accuracy", nullptr}, {"note", "without ../shared/data/colour"}};
  LabelledFigures sum;
  for (int i = 0; i < kSplits; ++i) {
    const auto split = calibrate::splitLabelled(*pixels, kHeldOut, random);
    addSplit(split, *table2005, sum);
    if (i < kSizeSplits) addSizes(split, sum);
  }
  Json out{{"splits", kSplits}};
  addScores(out, "", sum.table);
  addScores(out, "_alike", sum.alike);
  addScores(out, "_2005", sum.table2005);
  addScores(out, "_knn", sum.neighbours);
  out["confusion"] = confusionFigures(sum.table);
  out["table_sizes"] = sizeFigures(sum);
  return out;
}

// What stands on a field, with its class; the rest of a view is background.
struct Surface {
  sim::Colour colour;
  ColourClass colourClass;
};
constexpr std::array<Surface, 9> kSurfaces = {{{sim::colours::kOrange, ColourClass::orange},
                                               {sim::colours::kBlue, ColourClass::blue},
                                               {sim::colours::kYellow, ColourClass::yellow},
                                               {sim::colours::kPink, ColourClass::pink},
                                               {sim::colours::kGreen, ColourClass::green},
                                               {sim::colours::kWhite, ColourClass::white},
                                               {sim::colours::kRobotRed, ColourClass::robotRed},
                                               {sim::colours::kRobotBlue, ColourClass::robotBlue},
                                               {sim::colours::kGrey, ColourClass::grey}}};
constexpr float kDarkest = 0.62F;
constexpr float kBrightest = 1.2F;
constexpr int kBlackBelow = 60;  // the ceiling has black's chroma and shines at 172

bool chromaOf(Yuv p, sim::Colour c) {
  return p.cr == static_cast<int>(c.cr) && p.cb == static_cast<int>(c.cb);
}

// In an image without artefacts light changes Y alone, by 0.65 (a ball's shadow) to 1.2, so chroma
// tells the surface; a shirt may have a grey shell's chroma by chance, seldom its Y too.
bool wears(Yuv p, sim::Colour c) {
  const auto y = static_cast<float>(p.y);
  return chromaOf(p, c) && y > kDarkest * c.y && y < kBrightest * c.y;
}

ColourClass surfaceAt(Yuv p) {
  for (const Surface& s : kSurfaces)
    if (wears(p, s.colour)) return s.colourClass;
  if (chromaOf(p, sim::colours::kBlack) && p.y < kBlackBelow) return ColourClass::black;
  return ColourClass::none;
}

// What is beside the field and wears no colour of the game; clothes do and are not counted.
bool isSurroundings(Yuv p) {
  return chromaOf(p, sim::colours::kFloor) || chromaOf(p, sim::colours::kWall) ||
         chromaOf(p, sim::colours::kSkin) ||
         (chromaOf(p, sim::colours::kCeiling) && p.y >= kBlackBelow);
}
bool isColoured(std::size_t c) {
  return c != vision::index(ColourClass::none) && c != vision::index(ColourClass::grey) &&
         c != vision::index(ColourClass::white) && c != vision::index(ColourClass::black);
}

// Nothing where the eight pixels around are not of the same surface.
ColourClass wholeSurfaceAt(const Image& ideal, int px, int py) {
  const Yuv middle = ideal.pixel(px, py);
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const Yuv p = ideal.pixel(px + dx, py + dy);
      if (p.cr != middle.cr || p.cb != middle.cb) return ColourClass::none;
    }
  return surfaceAt(middle);
}

enum class Zone { middle, between, corners };
constexpr double kMiddle = 50.0;    // px from the image's centre
constexpr double kCorners = 100.0;  // beyond: 4 % of the image

Zone zoneAt(int px, int py) {
  const double d = std::hypot(px + 0.5 - kImageWidth / 2.0, py + 0.5 - kImageHeight / 2.0);
  return d < kMiddle ? Zone::middle : d < kCorners ? Zone::between : Zone::corners;
}

constexpr double kMinPixels = 50.0;  // pixels that make a share

struct Score {
  std::array<double, kColourClassCount> right{};
  std::array<double, kColourClassCount> all{};

  double share() const {
    double good = 0.0;
    double count = 0.0;
    for (std::size_t c = 0; c < kColourClassCount; ++c) {
      good += right[c];
      count += all[c];
    }
    return ratio(good, count);
  }
  // Mean of the classes' shares: the carpet counts no more than a robot's patch.
  double classMean() const {
    double sum = 0.0;
    double classes = 0.0;
    for (std::size_t c = 0; c < kColourClassCount; ++c) {
      if (all[c] < kMinPixels) continue;
      sum += right[c] / all[c];
      classes += 1.0;
    }
    return ratio(sum, classes);
  }
  Json byClass() const {
    Json out;
    for (std::size_t c = 1; c < kColourClassCount; ++c)
      out[vision::kColourNames[c]] = all[c] > 0.0 ? Json(right[c] / all[c]) : Json(nullptr);
    return out;
  }
};

// Scores of one way to calibrate: over the image, by zone.
struct Scores {
  Score whole;
  std::array<Score, 3> zone;
  double surroundings = 0.0;
  double surroundingsColoured = 0.0;
};

void addImage(const Image& image, const Image& ideal, const vision::VisionCalibration& calibration,
              Scores& scores) {
  const auto classes = std::make_unique<vision::ClassPlane>();
  classifyWhole(image, calibration, *classes);
  for (int py = vision::kUsableTop; py < vision::kUsableBottom; ++py)
    for (int px = vision::kUsableLeft; px < vision::kUsableRight; ++px) {
      const auto truth = vision::index(wholeSurfaceAt(ideal, px, py));
      const std::size_t found = (*classes)[Image::at(px, py)];
      if (isSurroundings(ideal.pixel(px, py))) {
        scores.surroundings += 1.0;
        scores.surroundingsColoured += isColoured(found) ? 1.0 : 0.0;
      }
      if (truth == 0) continue;
      const double right = found == truth ? 1.0 : 0.0;
      for (Score* score : {&scores.whole, &scores.zone[static_cast<std::size_t>(zoneAt(px, py))]}) {
        score->right[truth] += right;
        score->all[truth] += 1.0;
      }
    }
}

// Seven papers in the middle of the image, a thousand pixels each, as in 2005.
Expected<vision::RobotShift> calibratedShift(const sim::ColourShift& robot, Random& random) {
  constexpr std::array<sim::Colour, 7> kPapers = {
      {sim::colours::kYellow, sim::colours::kBlue, sim::colours::kGreen, sim::colours::kPink,
       sim::colours::kWhite, sim::colours::kRobotRed, sim::colours::kOrange}};
  constexpr int kPixels = 1000;
  const sim::ArtefactParams noise;
  const auto seen = [&](std::size_t c, double value, double sd) {
    const double v = robot.gain[c] * value + robot.offset[c] + random.gaussian(0.0, sd);
    return static_cast<std::uint8_t>(maths::clamp(v + 0.5, 0.0, 255.0));
  };
  std::vector<calibrate::ShiftPair> pairs;
  for (const auto& paper : kPapers) {
    const std::array<double, 3> base{static_cast<double>(paper.y), static_cast<double>(paper.cr),
                                     static_cast<double>(paper.cb)};
    for (int i = 0; i < kPixels; ++i)
      pairs.push_back({{seen(0, base[0], noise.noiseSdY), seen(1, base[1], noise.noiseSdChroma),
                        seen(2, base[2], noise.noiseSdChroma)},
                       base});
  }
  return calibrate::fitShift(pairs);
}

struct SceneScores {
  Scores calibrated;
  Scores unshifted;
  Scores uncorrected;
};

Status addView(const View& view, Random& random, sim::Camera& idealCamera, SceneScores& scores) {
  const auto ideal = std::make_unique<Image>();
  idealCamera.render(view.scene, view.columns, random, *ideal);
  const auto shift = calibratedShift(view.robotCamera.shift, random);
  if (!shift) return Error{shift.error()};
  const auto calibration =
      std::make_unique<vision::VisionCalibration>(vision::nominalCalibration());
  addImage(view.input.image, *ideal, *calibration, scores.unshifted);
  calibration->ring = buildRingTable(vision::ringModelNominal(), *shift);
  addImage(view.input.image, *ideal, *calibration, scores.calibrated);
  calibration->ring = buildRingTable({}, *shift);
  addImage(view.input.image, *ideal, *calibration, scores.uncorrected);
  return Done{};
}

void addScores(Json& out, const std::string& ending, const Scores& scores) {
  out["scene_accuracy" + ending] = scores.whole.share();
  out["scene_accuracy_middle" + ending] = scores.zone[0].share();
  out["scene_accuracy_corners" + ending] = scores.zone[2].share();
  out["scene_class_mean" + ending] = scores.whole.classMean();
  out["scene_class_mean_corners" + ending] = scores.zone[2].classMean();
  out["surroundings_coloured_share" + ending] =
      scores.surroundingsColoured / std::fmax(1.0, scores.surroundings);
}

Expected<Json> colour(const Request& request) {
  Random random(request.seed);
  Json out = labelledFigures(random);
  ViewParams params;
  params.randomised = cli::paramsOf(request.randomised);
  ViewMaker views(params, request.seed);
  sim::Camera idealCamera(sim::idealCamera(), {});
  SceneScores scores;
  const Status done = eachTrial(
      request, [&](const Trial&) { return addView(views.next(), random, idealCamera, scores); });
  if (!done) return Error{done.error()};
  addScores(out, "", scores.calibrated);
  addScores(out, "_unshifted", scores.unshifted);
  addScores(out, "_uncorrected", scores.uncorrected);
  out["scene_accuracy_by_class"] = scores.calibrated.whole.byClass();
  out["scene_accuracy_by_class_unshifted"] = scores.unshifted.whole.byClass();
  return out;
}

const Registration kColour("colour",
                           "share of pixels that get their class: held-out labels, rendered views",
                           {Option::trials, Option::seed, Option::randomised}, 60, colour);

}  // namespace
}  // namespace kelpie::experiments
