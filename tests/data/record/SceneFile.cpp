// SPDX-License-Identifier: Apache-2.0
#include "tests/data/record/SceneFile.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "robot/core/parameters/Toml.h"
#include "tools/picture/PngFile.h"
#include "vision/colour/ColourClass.h"

namespace kelpie::recorded {
namespace {

constexpr const char* kFileHead =
    "# What a person sees in each picture, and how the robot stood. Written by record_scenes from\n"
    "# what really was there (tests/data/README.md); not to be edited by hand.\n";

constexpr std::array<const char*, kLandmarkKindCount> kLandmarks = {
    "blue goal",           "yellow goal",           "blue on pink beacon",
    "pink on blue beacon", "yellow on pink beacon", "pink on yellow beacon"};

constexpr double kDegree = maths::kPi / 180.0;  // rad; of rates, which may be beyond half a turn

double numberIn(const toml::table& table, const char* key, std::string& lacks) {
  const auto value = table[key].value<double>();
  if (!value && lacks.empty()) lacks = key;
  return value.value_or(0.0);
}

std::string textIn(const toml::table& table, const char* key, std::string& lacks) {
  const auto value = table[key].value<std::string>();
  if (!value && lacks.empty()) lacks = key;
  return value.value_or("");
}

void readBody(const toml::table& table, FrameInput& input, std::string& lacks) {
  const auto number = [&](const char* key) { return numberIn(table, key, lacks); };
  JointAngles& joints = input.sensors.joints;
  joints[Joint::neckTilt] = Angle::deg(number("neck_tilt_deg"));
  joints[Joint::headPan] = Angle::deg(number("head_pan_deg"));
  joints[Joint::headNod] = Angle::deg(number("head_nod_deg"));
  input.headRate.headPan = kDegree * number("pan_rate_deg_s");
  input.headRate.headNod = kDegree * number("nod_rate_deg_s");
  input.stance.shoulderHeight = number("shoulder_height_cm");
  input.stance.bodyTilt = Angle::deg(number("body_tilt_deg"));
  input.odometry.turn = Angle::deg(number("turn_deg"));
  const double sd = Angle::deg(number("tilt_sd_deg")).rad();
  input.cameraTilt.tiltVariance = input.cameraTilt.rollVariance = sd * sd;
  input.elapsed = kFrameSeconds;
}

SeenThing thingFrom(const toml::table& table, std::string& lacks) {
  SeenThing thing;
  thing.what = textIn(table, "what", lacks);
  thing.distance = numberIn(table, "distance_cm", lacks);
  thing.heading = Angle::deg(numberIn(table, "heading_deg", lacks));
  if (thing.what == "ball") thing.elevation = Angle::deg(numberIn(table, "elevation_deg", lacks));
  thing.cut = table["cut"].value_or(false);
  thing.hidden = table["hidden"].value_or(false);
  thing.nameable = table["nameable"].value_or(false);
  thing.foundOnce = table["found_once"].value_or(false);
  return thing;
}

Scene sceneFrom(const toml::table& table, std::string& lacks) {
  Scene scene;
  scene.name = textIn(table, "name", lacks);
  scene.frame = table["frame"].value_or(false);
  scene.randomised = table["randomised"].value_or(false);
  readBody(table, scene.input, lacks);
  const toml::array* things = table["things"].as_array();
  if (things == nullptr) {
    lacks = "things";
    return scene;
  }
  for (const toml::node& thing : *things)
    scene.things.push_back(thingFrom(thing.as_table() ? *thing.as_table() : toml::table{}, lacks));
  return scene;
}

std::string wordsFor(const SeenThing& thing) {
  std::string words = fmt::format("  {{ what = \"{}\", distance_cm = {:.1f}, heading_deg = {:.1f}",
                                  thing.what, thing.distance, thing.heading.deg());
  if (thing.what == "ball") words += fmt::format(", elevation_deg = {:.1f}", thing.elevation.deg());
  if (thing.cut) words += ", cut = true";
  if (thing.hidden) words += ", hidden = true";
  if (thing.nameable) words += ", nameable = true";
  if (thing.foundOnce) words += ", found_once = true";
  return words + " },\n";
}

std::string wordsFor(const Scene& scene) {
  const FrameInput& input = scene.input;
  const JointAngles& joints = input.sensors.joints;
  std::string words = fmt::format("\n[[scene]]\nname = \"{}\"\n", scene.name);
  if (scene.frame) words += "frame = true\n";
  if (scene.randomised) words += "randomised = true\n";
  const auto number = [&words](const char* key, double value) {
    words += fmt::format("{} = {:.4f}\n", key, value);
  };
  number("neck_tilt_deg", joints[Joint::neckTilt].deg());
  number("head_pan_deg", joints[Joint::headPan].deg());
  number("head_nod_deg", joints[Joint::headNod].deg());
  number("pan_rate_deg_s", input.headRate.headPan / kDegree);
  number("nod_rate_deg_s", input.headRate.headNod / kDegree);
  number("shoulder_height_cm", input.stance.shoulderHeight);
  number("body_tilt_deg", input.stance.bodyTilt.deg());
  number("turn_deg", input.odometry.turn.deg());
  number("tilt_sd_deg", Angle::rad(std::sqrt(input.cameraTilt.tiltVariance)).deg());
  words += "things = [\n";
  for (const SeenThing& thing : scene.things) words += wordsFor(thing);
  return words + "]\n";
}

std::vector<cv::Vec3b> classPalette() {
  std::vector<cv::Vec3b> palette;
  for (const vision::Rgb& c : vision::kColourPalette) palette.emplace_back(c.b, c.g, c.r);
  return palette;
}

std::vector<cv::Vec3b> greyPalette() {
  std::vector<cv::Vec3b> palette;
  for (int i = 0; i < 256; ++i) {
    const auto grey = static_cast<std::uint8_t>(i);
    palette.emplace_back(grey, grey, grey);
  }
  return palette;
}

Expected<cv::Mat> readSized(const std::string& path, int height) {
  auto picture = picture::readPng(path);
  if (picture && (picture->cols != kImageWidth || picture->rows != height))
    return Error{fmt::format("{}: not {} x {} pixels", path, kImageWidth, height)};
  return picture;
}

}  // namespace

const char* nameOf(LandmarkKind mark) { return kLandmarks[static_cast<std::size_t>(mark)]; }

const char* nameOf(TeamColour robot) {
  return robot == TeamColour::red ? "red robot" : "blue robot";
}

Expected<std::vector<Scene>> readScenes(const std::string& folder) {
  const std::string path = folder + "/scenes.toml";
  const auto file = readToml(path);
  if (!file) return Error{file.error()};
  const toml::array* list = (*file)["scene"].as_array();
  if (list == nullptr) return Error{path + ": holds no scene"};
  std::vector<Scene> scenes;
  for (const toml::node& node : *list) {
    const toml::table* table = node.as_table();
    std::string lacks;
    scenes.push_back(sceneFrom(table != nullptr ? *table : toml::table{}, lacks));
    if (!lacks.empty())
      return Error{fmt::format("{}:{}: a scene without {}", path, node.source().begin.line, lacks)};
  }
  return scenes;
}

Status writeScenes(const std::string& folder, const std::vector<Scene>& scenes) {
  const std::string path = folder + "/scenes.toml";
  std::ofstream file(path);
  file << kFileHead;
  for (const Scene& scene : scenes) file << wordsFor(scene);
  file.close();
  return file ? Status(Done{}) : Error{path + ": cannot be written"};
}

std::string pictureFile(const std::string& folder, const Scene& scene) {
  return folder + (scene.frame ? "/frames/" : "/planes/") + scene.name + ".png";
}

Status readPlane(const std::string& path, vision::ClassPlane& plane) {
  const auto picture = readSized(path, kImageHeight);
  if (!picture) return Error{picture.error()};
  const std::vector<cv::Vec3b> palette = classPalette();
  for (std::size_t i = 0; i < plane.size(); ++i) {
    const cv::Vec3b& colour = picture->begin<cv::Vec3b>()[static_cast<int>(i)];
    const auto found = std::find(palette.begin(), palette.end(), colour);
    if (found == palette.end()) return Error{path + ": a colour that is of no class"};
    plane[i] = static_cast<std::uint8_t>(found - palette.begin());
  }
  return Done{};
}

Status writePlane(const std::string& path, const vision::ClassPlane& plane) {
  cv::Mat numbers(kImageHeight, kImageWidth, CV_8UC1);
  std::copy(plane.begin(), plane.end(), numbers.data);
  return picture::writeIndexedPng(path, numbers, classPalette());
}

Status readFrame(const std::string& path, Image& image) {
  const auto picture = readSized(path, 3 * kImageHeight);
  if (!picture) return Error{picture.error()};
  auto grey = picture->begin<cv::Vec3b>();
  for (Image::Plane* plane : {&image.y, &image.cr, &image.cb})
    for (std::uint8_t& pixel : *plane) pixel = (*grey++)[0];
  return Done{};
}

Status writeFrame(const std::string& path, const Image& image) {
  cv::Mat grey(3 * kImageHeight, kImageWidth, CV_8UC1);
  std::uint8_t* to = grey.data;
  for (const Image::Plane* plane : {&image.y, &image.cr, &image.cb})
    to = std::copy(plane->begin(), plane->end(), to);
  return picture::writeIndexedPng(path, grey, greyPalette());
}

}  // namespace kelpie::recorded
