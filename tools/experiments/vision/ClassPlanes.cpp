// SPDX-License-Identifier: Apache-2.0
// What a recording loses when class planes stand in for its images: vision on random views and on
// the images made again from their planes, percept by percept, and the size of the planes.
#include <algorithm>
#include <cmath>
#include <memory>

#include "robot/body/Camera.h"
#include "robot/core/types/PlaneFrame.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/views/View.h"
#include "vision/Vision.h"
#include "vision/pixels/PlaneImage.h"

namespace kelpie::experiments {
namespace {

// One kind of percept over all views, as seen in the image and in the plane.
struct Agreement {
  Share same;  // seen in both or in neither
  int inImage = 0;
  int inBoth = 0;
  Values distance;  // difference in %
  Values heading;   // deg

  template <class Percept>
  void compare(const Percept* image, const Percept* plane) {
    same.count((image == nullptr) == (plane == nullptr));
    if (image == nullptr) return;
    ++inImage;
    if (plane == nullptr) return;
    ++inBoth;
    distance.push_back(100.0 * std::fabs(plane->distance / image->distance - 1.0));
    heading.push_back(std::fabs((plane->heading - image->heading).deg()));
  }
};

const LandmarkPercept* find(const Percepts& seen, LandmarkKind kind) {
  for (const auto& landmark : seen.landmarks)
    if (landmark.kind == kind) return &landmark;
  return nullptr;
}

const BallPercept* ballOf(const Percepts& seen) { return seen.ball.present ? &seen.ball : nullptr; }

// Both visions and the planes between them.
class Comparison {
 public:
  Comparison()
      : onImage_(std::make_unique<vision::VisionState>()),
        onPlane_(
            std::make_unique<vision::VisionState>(*vision::loadCalibration("nominal", "none"))),
        again_(std::make_unique<PlaneFrame>()) {}

  void add(const FrameInput& input) {
    const BodyState body = body::step(input, {});
    const Percepts image = vision::step({input, body}, {}, *onImage_);
    vision::ClassPlane plane{};
    vision::classifyWhole(input.image, onImage_->tables, plane);
    encodePlane(plane, again_->plane);
    bytes_.push_back(static_cast<double>(again_->plane.size()));
    vision::imageOf(plane, again_->image);
    const Percepts made = vision::step({*again_, body}, {}, *onPlane_);
    ball_.compare(ballOf(image), ballOf(made));
    for (std::size_t k = 0; k < kLandmarkKindCount; ++k) {
      const auto kind = static_cast<LandmarkKind>(k);
      (k < 2 ? goals_ : beacons_).compare(find(image, kind), find(made, kind));
    }
    points_ += static_cast<double>(made.linePoints.size());
    pointsInImage_ += static_cast<double>(image.linePoints.size());
  }
  Json figures() const {
    Json json{{"plane_mean_bytes", mean(bytes_)}};
    json["plane_p95_bytes"] = percentile(bytes_, 0.95);
    json["plane_max_bytes"] = percentile(bytes_, 1.0);
    json["image_bytes"] = 3 * kImagePixels;
    add("ball", ball_, json);
    add("goal", goals_, json);
    add("beacon", beacons_, json);
    json["line_points_ratio"] = points_ / std::fmax(pointsInImage_, 1.0);
    return json;
  }

 private:
  static void add(const std::string& name, const Agreement& a, Json& json) {
    json[name + "_same_rate"] = a.same.value();
    json[name + "_in_image"] = a.inImage;
    json[name + "_in_both"] = a.inBoth;
    json[name + "_within_5_percent_rate"] = shareUpTo(a.distance, 5.0);
    json[name + "_distance_median_percent"] = percentile(a.distance, 0.5);
    json[name + "_distance_p90_percent"] = percentile(a.distance, 0.9);
    json[name + "_heading_p90_deg"] = percentile(a.heading, 0.9);
  }

  std::unique_ptr<vision::VisionState> onImage_;
  std::unique_ptr<vision::VisionState> onPlane_;
  std::unique_ptr<PlaneFrame> again_;
  Values bytes_;
  Agreement ball_;
  Agreement goals_;
  Agreement beacons_;
  double points_ = 0.0;
  double pointsInImage_ = 0.0;
};

Expected<Json> classPlanes(const Request& request) {
  Comparison comparison;
  eachView({}, request, [&](const View& view) { comparison.add(view.input); });
  return comparison.figures();
}

const Registration kClassPlanes(
    "class-planes", "class planes for images: their size, and what vision loses by them",
    {Option::trials, Option::seed, Option::randomised}, 500, classPlanes);

}  // namespace
}  // namespace kelpie::experiments
