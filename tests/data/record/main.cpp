// SPDX-License-Identifier: Apache-2.0
// record_scenes FOLDER SHEETS   draws the scenes of tests/data anew: class planes, frames and
// scenes.toml; and into the folder SHEETS pictures of all of them, for a person to look at. Each
// kind of scene takes the first of its seeded random views that show what
// the kind is about, whatever vision makes of them.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <opencv2/imgproc.hpp>

#include "robot/body/Camera.h"
#include "tests/data/record/Kinds.h"
#include "tests/data/record/RecordedVision.h"
#include "tools/picture/CameraPicture.h"
#include "tools/picture/PngFile.h"
#include "vision/pixels/ClassPicture.h"

namespace kelpie::recorded {
namespace {

// A person names what shows so many pixels of a thing; of a robot so many, some in its colour.
constexpr int kLarge = 300;
constexpr int kRobot = 150;
constexpr int kUniform = 15;
constexpr int kMostViews = 20000;  // of one kind, before it is given up
constexpr int kSheetColumns = 3;
constexpr int kSheetTiles = 12;
const cv::Scalar kBackground(40, 40, 40);
constexpr std::uint64_t kRandomisedSeed = 2006;

// `uniform`: pixels of a robot's coloured patches.
bool isNameable(const experiments::TrueObject& object, int uniform) {
  if (object.kind == experiments::ObjectKind::robot)
    return object.pixels >= kRobot && uniform >= kUniform;
  return object.toSee || object.pixels >= kLarge;
}

SeenThing thingOf(const experiments::View& view, const experiments::TrueObject& object) {
  SeenThing thing;
  thing.what = nameOf(object);
  thing.distance = object.distance;
  thing.heading = object.heading;
  if (object.kind == experiments::ObjectKind::ball) {
    const Point2<Robot> ball = robotFromField(view.pose, view.ball);
    const Point3<Robot>& eye = view.camera.position;
    thing.elevation = Angle::rad(
        maths::atan2(body::kBallRadius - eye.z, maths::hypot(ball.x - eye.x, ball.y - eye.y)));
  }
  thing.cut = object.cut;
  thing.hidden = object.pixels < 0.8 * object.pixelsAlone;
  return thing;
}

// The scenes so far, and the sheet that shows them.
class Recorder {
 public:
  explicit Recorder(std::string folder) : folder_(std::move(folder)) {}

  Status record(const Kind& kind, bool randomised) {
    const int planes = kind.planes[randomised ? 1 : 0];
    const int wanted = planes + kind.frames[randomised ? 1 : 0];
    const auto maker =
        std::make_unique<experiments::ViewMaker>(paramsFor(kind, randomised ? kRandomisedSeed : 0),
                                                 kind.seed + (randomised ? kRandomisedSeed : 0));
    int kept = 0;
    for (int i = 0; i < kMostViews && kept < wanted; ++i) {
      const experiments::View& view = maker->next();
      const auto objects = trueObjects(view, *body::fieldDescription("2006"), visibility_);
      if (!kind.fits({view, objects})) continue;
      const bool frame = kept >= planes;
      const std::string name =
          fmt::format("{}_{}_{}", kind.name, randomised ? "randomised" : "nominal", ++kept);
      const Status added = add(sceneOf(view, objects, {name, frame, randomised}));
      if (!added) return added;
    }
    if (kept < wanted)
      return Error{fmt::format("{}: only {} of {} views", kind.name, kept, wanted)};
    return Done{};
  }

  Status finish(const std::string& sheets) {
    for (std::size_t first = 0; first < tiles_.size(); first += kSheetTiles) {
      const std::string path = fmt::format("{}/scenes_{:02}.png", sheets, first);
      const Status drawn = picture::writePng(path, sheetFrom(first));
      if (!drawn) return drawn;
    }
    return writeScenes(folder_, scenes_);
  }

 private:
  struct Named {
    std::string name;
    bool frame;
    bool randomised;
  };
  // The robots are the last of the objects, in their own order.
  Scene sceneOf(const experiments::View& view, const std::vector<experiments::TrueObject>& objects,
                const Named& named) {
    Scene scene{named.name, named.frame, named.randomised, view.input, {}};
    const std::size_t firstRobot = objects.size() - view.robots.size();
    for (std::size_t i = 0; i < objects.size(); ++i) {
      if (objects[i].pixels == 0) continue;
      const int uniform = i < firstRobot ? 0 : visibility_.uniform(view, i - firstRobot).pixels;
      scene.things.push_back(thingOf(view, objects[i]));
      scene.things.back().nameable = isNameable(objects[i], uniform);
    }
    return scene;
  }

  Status add(Scene scene) {
    auto plane = std::make_unique<vision::ClassPlane>();
    vision::classifyWhole(scene.input.image, vision::nominalCalibration(), *plane);
    const std::string path = pictureFile(folder_, scene);
    const Status written =
        scene.frame ? writeFrame(path, scene.input.image) : writePlane(path, *plane);
    if (!written) return written;
    const auto seen = vision_.look(scene, folder_);
    if (!seen) return Error{seen.error()};
    for (SeenThing& thing : scene.things) thing.foundOnce = finds(*seen, thing, scene.randomised);
    addToSheet(scene, *plane);
    fmt::print("{}\n", scene.name);
    scenes_.push_back(std::move(scene));
    return Done{};
  }

  void addToSheet(const Scene& scene, const vision::ClassPlane& plane) {
    cv::Mat tile(kImageHeight + 120, 2 * kImageWidth, CV_8UC3, kBackground);
    cv::Mat classes(kImageHeight, kImageWidth, CV_8UC3);
    for (std::size_t i = 0; i < plane.size(); ++i) {
      const vision::Rgb& c = vision::kColourPalette[plane[i]];
      classes.begin<cv::Vec3b>()[static_cast<int>(i)] = {c.b, c.g, c.r};
    }
    picture::pictureOf(scene.input.image).copyTo(tile({0, 0, kImageWidth, kImageHeight}));
    classes.copyTo(tile({kImageWidth, 0, kImageWidth, kImageHeight}));
    int row = kImageHeight + 10;
    const auto line = [&](const std::string& text, const cv::Scalar& colour) {
      cv::putText(tile, text, {2, row}, cv::FONT_HERSHEY_PLAIN, 0.7, colour);
      row += 10;
    };
    line(scene.name, {255, 255, 255});
    for (const SeenThing& thing : scene.things) line(wordsOf(thing), colourOf(thing));
    tiles_.push_back(tile);
  }
  static std::string wordsOf(const SeenThing& thing) {
    return fmt::format("{} {:.0f} cm {:.0f} deg{}{}{}{}", thing.what, thing.distance,
                       thing.heading.deg(), thing.cut ? " cut" : "", thing.hidden ? " hidden" : "",
                       thing.nameable ? "" : " (hardly)", thing.foundOnce ? "" : " NOT FOUND");
  }
  static cv::Scalar colourOf(const SeenThing& thing) {
    if (thing.foundOnce) return {120, 255, 120};
    return thing.nameable ? cv::Scalar(80, 80, 255) : cv::Scalar(180, 180, 180);
  }
  // The tiles from that one on, as many as a sheet holds.
  cv::Mat sheetFrom(std::size_t first) const {
    const int count = std::min(kSheetTiles, static_cast<int>(tiles_.size() - first));
    const int rows = (count + kSheetColumns - 1) / kSheetColumns;
    const cv::Size size = tiles_[0].size();
    cv::Mat sheet(rows * size.height, kSheetColumns * size.width, CV_8UC3, kBackground);
    for (int i = 0; i < count; ++i)
      tiles_[first + static_cast<std::size_t>(i)].copyTo(
          sheet({i % kSheetColumns * size.width, i / kSheetColumns * size.height, size.width,
                 size.height}));
    return sheet;
  }

  std::string folder_;
  std::vector<Scene> scenes_;
  std::vector<cv::Mat> tiles_;
  experiments::Visibility visibility_;
  RecordedVision vision_;
};

Status recordAll(const std::string& folder, const std::string& sheets) {
  std::error_code ignored;
  for (const char* below : {"/planes", "/frames"}) {
    std::filesystem::remove_all(folder + below, ignored);
    std::filesystem::create_directories(folder + below, ignored);
  }
  Recorder recorder(folder);
  for (const bool randomised : {false, true})
    for (const Kind& kind : kinds()) {
      const Status recorded = recorder.record(kind, randomised);
      if (!recorded) return recorded;
    }
  return recorder.finish(sheets);
}

}  // namespace
}  // namespace kelpie::recorded

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "record_scenes FOLDER SHEETS: draws the scenes of tests/data anew\n");
    return 2;
  }
  const kelpie::Status done = kelpie::recorded::recordAll(argv[1], argv[2]);
  if (!done) fmt::print(stderr, "record_scenes: {}\n", done.error());
  return done ? 0 : 3;
}
