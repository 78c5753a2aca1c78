// SPDX-License-Identifier: Apache-2.0
// sim_snapshot: one image of a seeded scene as PNG, to look at. Place and head can be given; what
// is not given comes from the seed.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <opencv2/imgproc.hpp>

#include "tools/cli/options/RandomisationOptions.h"
#include "tools/picture/CameraPicture.h"
#include "tools/picture/PngFile.h"
#include "tools/sim/bodies/BodyShape.h"
#include "tools/sim/camera/Camera.h"
#include "tools/sim/camera/OuterWall.h"

namespace kelpie::sim {
namespace {

struct Options {
  std::uint64_t seed = 1;
  std::string out = "snapshot.png";
  std::vector<double> pose;   // cm, cm, deg
  std::vector<double> head;   // neck tilt, pan, nod in deg
  std::vector<double> ball;   // cm, cm
  double panRate = 0.0;       // deg/s
  std::vector<double> robot;  // cm, cm, deg, of each red robot put somewhere
  int robots = 4;
  bool ideal = false;
  bool wall = false;
  bool hidden = false;
  bool small = false;
  cli::RandomisationOptions randomised;
};

Pose2 chosenPose(const Options& options, Random& random) {
  const double x = random.uniform(40.0, 320.0);
  const double y = random.uniform(60.0, 480.0);
  const double heading = random.uniform(0.0, 360.0);
  if (options.pose.size() == 3) {
    return {{options.pose[0], options.pose[1]}, Angle::deg(options.pose[2])};
  }
  return {{x, y}, Angle::deg(heading)};
}

BodyPlace placeOf(const Options& options, const Pose2& pose) {
  std::vector<double> head = options.head;
  if (head.size() != 3) head = {-5.0, 0.0, 0.0};
  BodyPlace place;
  place.pose = pose;
  place.stance = {10.0, Angle::deg(14.25), {}};
  place.joints[Joint::neckTilt] = Angle::deg(head[0]);
  place.joints[Joint::headPan] = Angle::deg(head[1]);
  place.joints[Joint::headNod] = Angle::deg(head[2]);
  setFrontFeet(place.joints, place.stance, {Point2<Robot>{-9.5, 5.0}, {9.5, -1.0}});
  return place;
}

ColumnCameras cameras(BodyPlace place, const RandomisedRobot& self, double panRate) {
  const Angle pan = place.joints[Joint::headPan];
  ColumnCameras columns;
  for (std::size_t x = 0; x < columns.size(); ++x) {
    const double late = (exposedAt(x, self.readout) - 0.5) * kFrameSeconds;
    place.joints[Joint::headPan] = pan + Angle::deg(panRate * late);
    columns[x] = fieldCamera(place.pose, trueCamera(place), self.lens);
  }
  return columns;
}

Status write(const Options& options, const Image& image) {
  if (options.small) return picture::writePng(options.out, picture::pictureOf(image));
  cv::Mat picture;
  cv::resize(picture::pictureOf(image), picture, {}, 3.0, 3.0, cv::INTER_NEAREST);
  return picture::writePng(options.out, picture);
}

int run(const Options& options) {
  const auto field = body::fieldDescription("2006");
  if (!field) {
    fmt::print(stderr, "sim_snapshot: {}\n", field.error());
    return 1;
  }
  Random random(options.seed);
  const RandomisationParams randomised = cli::paramsOf(options.randomised);
  const RandomisedRobot self = drawRandomisedRobot(randomised, options.seed, 0);
  Scene scene =
      fieldScene(*field, random.next() | 1U, drawRandomisedVenue(randomised, options.seed));
  if (options.wall) addWall(scene, outerWall(*field, 8.0, options.seed));
  if (options.hidden) hideLandmarks(scene);
  const Pose2 pose = chosenPose(options, random);
  const Point2<Field> ahead = fieldFromRobot(pose, {random.uniform(-30, 30), 80.0});
  setBall(scene,
          options.ball.size() == 2 ? Point2<Field>{options.ball[0], options.ball[1]} : ahead);
  std::vector<RobotLook> looks;
  looks.reserve(static_cast<std::size_t>(std::max(0, options.robots)) + options.robot.size() / 3);
  for (std::size_t i = 0; i + 2 < options.robot.size(); i += 3)
    looks.push_back({{{options.robot[i], options.robot[i + 1]}, Angle::deg(options.robot[i + 2])},
                     10.0,
                     TeamColour::red,
                     random.next(),
                     drawRandomisedRobot(randomised, options.seed, 1).uniform});
  for (int i = 0; i < options.robots; ++i) {
    looks.push_back(
        {{{random.uniform(20, 340), random.uniform(20, 520)}, Angle::deg(random.uniform(0, 360))},
         10.0,
         i % 2 == 0 ? TeamColour::red : TeamColour::blue,
         random.next(),
         drawRandomisedRobot(randomised, options.seed, static_cast<std::size_t>(i) + 1).uniform});
  }
  setRobots(scene, looks);
  BodyPlace place = placeOf(options, pose);
  place.lean = self.body.lean;
  scene.own = frontLegs(place);
  RobotCamera own = randomCamera(random, {});
  own.tone = self.tone;
  own.noise = self.noise;
  const auto camera = std::make_unique<Camera>(options.ideal ? idealCamera() : CameraParams{}, own);
  const auto image = std::make_unique<Image>();
  camera->render(scene, cameras(place, self, options.panRate), random, *image);
  const Status written = write(options, *image);
  if (!written) {
    fmt::print(stderr, "sim_snapshot: {}\n", written.error());
    return 1;
  }
  fmt::print("{}: seen from ({:.0f}, {:.0f}), heading {:.0f} deg\n", options.out, pose.position.x,
             pose.position.y, pose.heading.deg());
  return 0;
}

}  // namespace
}  // namespace kelpie::sim

int main(int argc, char** argv) {
  kelpie::sim::Options options;
  CLI::App app("One image of the simulated field as PNG");
  app.add_option("--seed", options.seed, "scene, place and colours");
  app.add_option("--out", options.out, "PNG file");
  app.add_option("--pose", options.pose, "x y in cm, heading in deg")->expected(3);
  app.add_option("--head", options.head, "neck tilt, pan, nod in deg")->expected(3);
  app.add_option("--ball", options.ball, "x y in cm")->expected(2);
  app.add_option("--pan-rate", options.panRate, "deg/s during the exposure");
  app.add_option("--robot", options.robot, "x y in cm, heading in deg of a red robot; repeated")
      ->expected(3)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.add_option("--others", options.robots, "other robots on the field");
  app.add_flag("--wall", options.wall, "the outer wall of the 2004 challenge, with sheets");
  app.add_flag("--hidden", options.hidden, "no beacons, goals covered");
  app.add_flag("--small", options.small, "208 x 160 pixels, as import takes them");
  app.add_flag("--ideal", options.ideal, "no artefacts");
  kelpie::cli::CommandLine line(&app);
  kelpie::cli::addRandomisationOptions(line, options.randomised);
  kelpie::cli::addLeanOptions(line, options.randomised);
  CLI11_PARSE(app, argc, argv);
  return kelpie::sim::run(options);
}
