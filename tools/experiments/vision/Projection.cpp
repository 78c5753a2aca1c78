// SPDX-License-Identifier: Apache-2.0
// The renderer and the robot's projection agree: white discs lie on a bare carpet in known places,
// the simulated camera draws them without artefacts, and the centre of light of each is compared
// with where robot/body says it should be, in the image and back on the ground. Renderer and
// projection share the head chain only; drawing and projecting are separate code.
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "robot/body/Camera.h"
#include "robot/core/Random.h"
#include "tools/experiments/harness/Trials.h"
#include "tools/sim/camera/Camera.h"

namespace kelpie::experiments {
namespace {

constexpr double kBorder = 2.0;      // px; a disc nearer to the image border is left out
constexpr double kRadiusShare = 60;  // a disc's radius is its distance over this

constexpr double kMargin = 3.0;  // px round a disc, six times the allowed error
constexpr std::array<double, 5> kRings = {36.0, 60.0, 100.0, 160.0, 260.0};  // cm

struct Marker {
  Point2<Robot> place;
  double radius = 0.0;
};

// A disc in the image: where its centre should be, and how far from it light is looked for.
struct DiscImage {
  const Marker* marker = nullptr;
  PixelPoint centre;
  double reach = 0.0;
};

struct HeadPose {
  JointAngles joints;
  Stance stance;
};

HeadPose randomHead(Random& random) {
  HeadPose head;
  head.joints[Joint::neckTilt] = Angle::deg(random.uniform(-60.0, 0.0));
  head.joints[Joint::headPan] = Angle::deg(random.uniform(-88.0, 88.0));
  head.joints[Joint::headNod] = Angle::deg(random.uniform(-15.0, 30.0));
  head.stance = {random.uniform(7.0, 12.0), Angle::deg(random.uniform(0.0, 18.0)), {}};
  return head;
}

// Discs on rings round the robot.
std::vector<Marker> markerGrid() {
  std::vector<Marker> markers;
  for (const double distance : kRings)
    for (double heading = -165.0; heading <= 180.0; heading += 15.0)
      markers.push_back({robotPolar(distance, Angle::deg(heading)), distance / kRadiusShare});
  return markers;
}

sim::Scene markedScene(const Pose2& pose, const std::vector<Marker>& markers) {
  sim::Scene scene;
  scene.carpet = {{{-1000.0, -1000.0}, {1000.0, 1000.0}}};
  for (const auto& marker : markers)
    scene.markers.push_back(
        {fieldFromRobot(pose, marker.place), marker.radius, sim::colours::kWhite, 0.0});
  return scene;
}

std::vector<DiscImage> discImages(const CameraPose& camera, const std::vector<Marker>& markers) {
  std::vector<DiscImage> discs;
  for (const auto& marker : markers) {
    const auto centre = body::project(camera, {marker.place.x, marker.place.y, 0.0});
    if (!centre) continue;
    const double range = maths::hypot(
        maths::hypot(marker.place.x - camera.position.x, marker.place.y - camera.position.y),
        camera.position.z);
    const double radius = body::kNominalLens.focalLength * marker.radius / range;
    discs.push_back({&marker, *centre, radius + kMargin});
  }
  return discs;
}

// Whether the light of another disc may fall into this one's window.
bool alone(const DiscImage& disc, const std::vector<DiscImage>& all) {
  for (const auto& other : all) {
    const double reach = disc.reach + other.reach;
    if (other.marker != disc.marker && std::fabs(other.centre.x - disc.centre.x) < reach &&
        std::fabs(other.centre.y - disc.centre.y) < reach)
      return false;
  }
  return true;
}

// Centre of the light that a disc adds to the carpet, in its window. Nothing if the window is not
// all in the image.
std::optional<PixelPoint> centreOfLight(const Image& image, const DiscImage& disc) {
  const int left = static_cast<int>(std::floor(disc.centre.x - disc.reach));
  const int right = static_cast<int>(std::ceil(disc.centre.x + disc.reach));
  const int top = static_cast<int>(std::floor(disc.centre.y - disc.reach));
  const int bottom = static_cast<int>(std::ceil(disc.centre.y + disc.reach));
  if (left < kBorder || top < kBorder || right > kImageWidth - kBorder ||
      bottom > kImageHeight - kBorder)
    return std::nullopt;
  const double carpet = image.y[Image::at(left, bottom - 1)];
  double sum = 0.0;
  PixelPoint centre;
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x) {
      const double light = image.y[Image::at(x, y)] - carpet;
      if (light < 0.0) continue;  // above the horizon
      sum += light;
      centre.x += light * (x + 0.5);
      centre.y += light * (y + 0.5);
    }
  if (sum < 100.0) return std::nullopt;  // less than one white pixel: lost in the rounding
  return PixelPoint{centre.x / sum, centre.y / sum};
}

struct Errors {
  double pixels = 0.0;
  double atOneMetre = 0.0;  // cm
  std::size_t discs = 0;
};

void compare(const Image& image, const CameraPose& camera, const DiscImage& disc, Errors& worst) {
  const auto found = centreOfLight(image, disc);
  if (!found) return;
  ++worst.discs;
  worst.pixels =
      std::fmax(worst.pixels, maths::hypot(found->x - disc.centre.x, found->y - disc.centre.y));
  const double distance = disc.marker->place.norm();
  const auto ground = body::groundPoint(camera, *found);
  if (ground && distance > 90.0 && distance < 110.0)
    worst.atOneMetre = std::fmax(worst.atOneMetre, kelpie::distance(*ground, disc.marker->place));
}

Expected<Json> projection(const Request& request) {
  Random random(request.seed);
  sim::Camera renderer(sim::idealCamera(), {});
  const auto markers = markerGrid();
  auto image = std::make_unique<Image>();
  Errors worst;
  eachTrial(request, [&](const Trial&) {
    const HeadPose head = randomHead(random);
    const Pose2 pose{{random.uniform(0.0, 360.0), random.uniform(0.0, 540.0)},
                     Angle::deg(random.uniform(-180.0, 180.0))};
    const CameraPose camera = body::cameraPose(head.joints, head.stance);
    sim::ColumnCameras columns;
    columns.fill(sim::fieldCamera(pose, camera));
    renderer.render(markedScene(pose, markers), columns, random, *image);
    const auto discs = discImages(camera, markers);
    for (const auto& disc : discs)
      if (alone(disc, discs)) compare(*image, camera, disc, worst);
  });
  if (worst.discs == 0) return Error{"no disc was in view"};
  return Json{{"discs", worst.discs}, {"max_px", worst.pixels}, {"max_cm_at_1m", worst.atOneMetre}};
}

const Registration kProjection(
    "projection", "rendered discs found again, against their projection: largest error",
    {Option::trials, Option::seed}, 500, projection);

}  // namespace
}  // namespace kelpie::experiments
