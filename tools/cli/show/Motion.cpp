// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <cmath>
#include <filesystem>
#include <memory>

#include "tools/cli/Commands.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/options/Usage.h"
#include "tools/cli/show/MotionFilm.h"
#include "tools/learn/motion/BlockTrial.h"
#include "tools/learn/motion/MotionFile.h"
#include "tools/learn/motion/MotionScene.h"
#include "tools/picture/FileNames.h"
#include "tools/sim/physics/Variation.h"

namespace kelpie::cli {
namespace {

constexpr const char* kHelp =
    R"(
Plays one motion on the physical body and says what happened. A kick gets the ball where its file's
`kick` says that it lies, or held under the chin; getting up begins on the side it is for; a ball
rolls at a block. NAME is one of actuator/data/motions, or the path of such a file: then --as says
which motion it is (its own name says so too; one that is neither is a kick of a free ball when it
has `kick`). --film shows it four times slower; docs/physical-body.md tells more.

  kelpie motion upenn_left --film upenn.mp4
  kelpie motion my/sit.toml --picture sit.png --model 3)";

struct MotionOptions {
  std::string name;
  std::string as;
  std::string film;
  std::string picture;
  std::uint64_t seed = 1;
  std::uint64_t model = 0;
};

struct Chosen {
  std::string name;
  MotionKind kind = MotionKind::none;
  actuator::MotionData motion;
};

bool isPath(const std::string& name) {
  return name.find('/') != std::string::npos || picture::endingOf(name) == ".toml";
}

Expected<Chosen> chosenFile(const MotionOptions& options) {
  const auto motion = learn::readMotion(options.name);
  if (!motion) return Error{motion.error()};
  Chosen chosen{std::filesystem::path(options.name).stem(), MotionKind::stand, *motion};
  if (motion->kick.distance > 0.0) chosen.kind = MotionKind::kickForward;
  const auto own = learn::motionNamed(options.as.empty() ? chosen.name : options.as);
  if (own) chosen.kind = *own;
  if (!own && !options.as.empty()) return Error{own.error()};
  return chosen;
}

Expected<Chosen> chosen(const MotionOptions& options) {
  if (isPath(options.name)) return chosenFile(options);
  const auto kind = learn::motionNamed(options.name);
  const auto as = learn::motionNamed(options.as.empty() ? options.name : options.as);
  if (!as) return Error{as.error()};
  if (!kind) return Error{kind.error()};
  const actuator::MotionData& motion = actuator::standardMotions()[*kind];
  if (motion.frames.empty()) return Error{options.name + ": there is no file of that motion yet"};
  return Chosen{options.name, *kind, motion};
}

const char* wordFor(Joint joint) {
  static constexpr std::array<const char*, kJointCount> kWords{"neck tilt",
                                                               "head pan",
                                                               "head nod",
                                                               "mouth",
                                                               "left front rotator",
                                                               "left front shoulder",
                                                               "left front knee",
                                                               "left hind rotator",
                                                               "left hind shoulder",
                                                               "left hind knee",
                                                               "right front rotator",
                                                               "right front shoulder",
                                                               "right front knee",
                                                               "right hind rotator",
                                                               "right hind shoulder",
                                                               "right hind knee",
                                                               "tail tilt",
                                                               "tail pan"};
  return kWords[index(joint)];
}

// How strongly the legs are held; nothing where it is as usual all the time.
std::string gainText(const actuator::MotionData& motion) {
  bool usual = true;
  std::string text;
  for (const actuator::KeyFrame& key : motion.frames) {
    usual = usual && key.gain == 1.0;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", key.gain);
  }
  return usual ? "" : "gain of the legs by key frame, share of the standard one: " + text + "\n";
}

// What a block covers; nothing for other motions.
std::string coverText(const learn::MotionStage& stage) {
  if (!stage.rolling) return "";
  const learn::BlockCover cover = learn::coverOf(stage);
  return fmt::format(
      "covers {:.1f} cm to the left and {:.1f} to the right of its middle at the "
      "ball's height, after {:.2f} s\n",
      cover.left, cover.right, cover.seconds);
}

// "12.0 cm ahead and 6.0 cm to the left"
std::string placeText(Point2<Robot> p) {
  return fmt::format("{:.1f} cm {} and {:.1f} cm to the {}", std::fabs(p.y),
                     p.y < 0.0 ? "behind" : "ahead", std::fabs(p.x), p.x < 0.0 ? "left" : "right");
}

std::string legsText(const learn::MotionStage& stage, const learn::MotionCourse& course) {
  const std::string leant =
      stage.lies ? std::string("it lay") : fmt::format("it leant {:.0f} deg at most", course.lean);
  if (!stage.lies && course.fell) return "robot: it fell; " + leant;
  if (!course.upright) return fmt::format("robot: {} and does not stand at the end", leant);
  if (course.stands) return fmt::format("robot: {} and stands at the end", leant);
  return fmt::format(
      "robot: {} and is on its feet at the end, the shoulder {:.1f} cm high "
      "({:.1f} in the stance)",
      leant, course.height, stage.height);
}

// Where the robot is in the end; odometry gets it from the file's `way`.
std::string wayText(const learn::MotionStage& stage, const learn::MotionCourse& course) {
  if (stage.lies) return "";
  return fmt::format(", {}, turned {:.0f} deg to the {}", placeText(course.way),
                     std::fabs(course.turn.deg()), course.turn.rad() < 0.0 ? "right" : "left");
}

std::string ballText(const learn::MotionStage& stage, const learn::MotionCourse& course) {
  if (stage.rolling) {
    const char* end = course.nearest > learn::kBallPassed
                          ? (course.ballVelocity.y > 0.0 ? "was thrown back" : "was stopped")
                          : "came by";
    return fmt::format("ball: rolled at it with {:.0f} cm/s, {:.0f} cm {} of its middle; {}",
                       stage.rolling->speed, std::fabs(stage.rolling->at.x),
                       stage.rolling->at.x < 0.0 ? "left" : "right", end);
  }
  if (!stage.hasBall) return "ball: none";
  const std::string from = "ball: lay " + placeText(course.ballBefore) + " of the neck base; ";
  const Point2<Robot> way = course.ballRests - course.ballBefore;
  if (course.holds)
    return from + (course.chin ? "is held under the chin at the end"
                               : "lies between the forelegs at the end, clear of the chin");
  return from + fmt::format("goes {:.0f} cm, {:.0f} deg to the {}", way.norm(),
                            std::fabs(bearing(way).deg()), way.x > 0.0 ? "right" : "left");
}

void tell(const Chosen& chosen, const MotionOptions& options, const learn::MotionStage& stage,
          const learn::MotionCourse& course) {
  const std::uint32_t ticks = ticksOf(chosen.motion);
  const std::string model =
      options.model == 0 ? "the standard robot" : fmt::format("varied robot {}", options.model);
  fmt::print("{}: {} key frames in {:.0f} camera frames ({:.2f} s), on {}, seed {}\n", chosen.name,
             chosen.motion.frames.size(), std::ceil(ticks * kTickSeconds * 30.0),
             ticks * kTickSeconds, model, options.seed);
  fmt::print("{}", gainText(chosen.motion));
  fmt::print("{}{}\n{}\n", legsText(stage, course), wayText(stage, course),
             ballText(stage, course));
  fmt::print("fastest joint: {}, {:.0f} deg/s\n", wordFor(course.fastest), course.rate);
}

int play(const MotionOptions& options) {
  const auto motion = chosen(options);
  if (!motion) return fail(motion.error(), kExitBadInput);
  for (const std::string& out : {options.film, options.picture})
    if (!out.empty() && !canWrite(out)) return fail(out + ": cannot be written", kExitBadInput);
  if (!options.film.empty() && picture::endingOf(options.film) != ".mp4")
    return fail(options.film + ": a film's name ends with .mp4", kExitBadInput);
  const sim::PhysicsParams model =
      options.model == 0 ? sim::PhysicsParams{} : sim::varied({}, options.model);
  learn::MotionStage stage = learn::sceneOf(motion->kind, motion->motion, model, options.seed);
  const bool draws = !options.film.empty() || !options.picture.empty();
  const std::string cover = coverText(stage);
  const learn::MotionCourse course = learn::playMotion(stage, draws);
  tell(*motion, options, stage, course);
  fmt::print("{}", cover);
  Status written = Done{};
  if (!options.picture.empty())
    written = drawMotion(course, motion->motion, motion->name, options.picture);
  if (written && !options.film.empty()) written = filmMotion(course, motion->name, options.film);
  if (!written) return fail(written.error(), kExitBadInput);
  return course.upright && (stage.lies || !course.fell) ? kExitDone : kExitCheckFailed;
}

}  // namespace

void addMotion(CommandLine& app, int& code) {
  auto motion = app.subcommand("motion", "Play one motion on the physical body, and film it");
  motion.footer(kHelp);
  auto options = std::make_shared<MotionOptions>();
  motion.option("NAME", options->name, "the motion, hard_forward for example, or its file")
      .required();
  motion.option("--as", options->as, "which motion a file is, upenn_left for example");
  motion.option("--film", options->film, "MP4 to write");
  motion.option("--picture", options->picture, "PNG of its key moments to write");
  motion.option("--seed", options->seed, "of the sensors' noise and of how it lies")
      .check(inRange(0, kLargestSeed))
      .showDefault();
  motion.option("--model", options->model, "0: the standard robot; else one varied by it")
      .check(inRange(0, kLargestSeed))
      .showDefault();
  motion.callback([options, &code] { code = play(*options); });
}

}  // namespace kelpie::cli
