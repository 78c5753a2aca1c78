// SPDX-License-Identifier: Apache-2.0
// The vector field of a skill: an arrow for what it asks the legs at each place of the field.
#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <set>

#include "actuator/motion/MotionData.h"
#include "tools/cli/Commands.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/options/Config.h"
#include "tools/match/Draw.h"
#include "tools/match/SkillField.h"
#include "tools/match/TraceWords.h"
#include "tools/picture/PngFile.h"

namespace kelpie::cli {
namespace {

using namespace match;

constexpr double kScale = 2.0;        // pixels per cm
constexpr double kLongest = 0.9;      // of the distance between places: the fastest arrow
constexpr double kStill = 0.5;        // cm/s, and deg/s: less is standing
constexpr double kStrongTurn = 60.0;  // deg/s: full colour
constexpr int kCaption = 84;          // px below the field
const cv::Scalar kInk(235, 235, 235);
const cv::Scalar kLeft(255, 120, 30);
const cv::Scalar kRight(40, 70, 255);

struct VectorOptions {
  std::string skill;
  std::string out;
  std::string ball;
  double heading = std::nan("");
  double step = 20.0;
  std::string pycode = defaultScripts();
  ConfigOptions config;
};

bool readBall(const VectorOptions& options, const body::FieldDescription& field,
              Point2<Field>& ball) {
  if (options.ball.empty()) {
    ball = {0.5 * field.width, 0.5 * field.length};
    return true;
  }
  const char* const end = options.ball.data() + options.ball.size();
  const auto x = std::from_chars(options.ball.data(), end, ball.x);
  if (x.ec != std::errc() || x.ptr == end || *x.ptr != ',') return false;
  const auto y = std::from_chars(x.ptr + 1, end, ball.y);
  return y.ec == std::errc() && y.ptr == end && ball.x >= 0.0 && ball.x <= field.width &&
         ball.y >= 0.0 && ball.y <= field.length;
}

// The skill's number; an error lists the names.
Expected<std::uint8_t> numberOf(const std::string& skill, behaviour::BehaviourState& behaviours) {
  const auto names = behaviours.ask("skill_names");
  if (!names) return Error{names.error()};
  std::string known;
  for (std::size_t i = 0; i < names->size(); ++i) {
    if ((*names)[i].empty()) continue;
    if ((*names)[i][0] == skill) return static_cast<std::uint8_t>(i);
    known += (known.empty() ? "" : ", ") + (*names)[i][0];
  }
  return Error{fmt::format("no skill '{}'; there are {}", skill, known)};
}

cv::Scalar inkOfTurn(double degrees) {
  const double share = std::min(1.0, std::fabs(degrees) / kStrongTurn);
  return ink::kWhite + ((degrees > 0.0 ? kLeft : kRight) - ink::kWhite) * share;
}

double speedOf(const SkillStep& step) { return std::hypot(step.way.x, step.way.y); }

// An arrow for walking, a disc for turning on the spot, a square for a motion, a dot for standing.
void drawStep(cv::Mat& picture, const body::FieldDescription& field, const SkillStep& step,
              double cmPerSpeed) {
  const cv::Point from = onPicture(field, kScale, step.place);
  const cv::Scalar colour = inkOfTurn(step.turn.deg());
  if (step.motion != MotionKind::none) {
    cv::rectangle(picture, from - cv::Point(4, 4), from + cv::Point(4, 4), ink::kOrange, 2);
  } else if (speedOf(step) > kStill) {
    const Point2<Field> tip{step.place.x + cmPerSpeed * step.way.x,
                            step.place.y + cmPerSpeed * step.way.y};
    cv::arrowedLine(picture, from, onPicture(field, kScale, tip), colour, 2, cv::LINE_AA, 0, 0.3);
  } else {
    const bool turns = std::fabs(step.turn.deg()) > kStill;
    cv::circle(picture, from, turns ? 5 : 2, turns ? colour : ink::kGrey, cv::FILLED, cv::LINE_AA);
  }
}

std::vector<std::string> captionOf(const VectorOptions& options, const SkillQuestion& question,
                                   const std::vector<SkillStep>& steps, double fastest) {
  std::set<std::string> motions;
  for (const SkillStep& step : steps)
    if (step.motion != MotionKind::none)
      motions.insert(actuator::kMotionNames[static_cast<std::size_t>(step.motion)]);
  std::string names;
  for (const std::string& name : motions) names += (names.empty() ? "" : ", ") + name;
  return {fmt::format("{}: the first step, ball at {:g}, {:g}, the robot {}", options.skill,
                      question.ball.x, question.ball.y,
                      question.heading ? fmt::format("at {:g} deg", question.heading->deg())
                                       : "faces the ball"),
          fmt::format("arrow: walk, the longest {} cm/s; disc: turn on the spot; dot: stand",
                      shortNumber(fastest)),
          "blue: turns to the left, red: to the right, white: keeps its heading",
          names.empty() ? "" : "square: " + names};
}

cv::Mat picture(const VectorOptions& options, const agent::AgentConfig& config,
                const SkillQuestion& question, const std::vector<SkillStep>& steps) {
  double fastest = 0.0;
  for (const SkillStep& step : steps) fastest = std::max(fastest, speedOf(step));
  const cv::Mat ground = drawField(config.field, config.team, kScale);
  cv::Mat whole(ground.rows + kCaption, ground.cols, CV_8UC3, cv::Scalar(30, 30, 30));
  cv::Mat field = whole(cv::Rect(0, 0, ground.cols, ground.rows));
  ground.copyTo(field);
  cv::circle(field, onPicture(config.field, kScale, question.ball),
             static_cast<int>(body::kBallRadius * kScale), ink::kOrange, cv::FILLED, cv::LINE_AA);
  for (const SkillStep& step : steps)
    drawStep(field, config.field, step, kLongest * question.step / std::max(fastest, kStill));
  drawLines(whole, captionOf(options, question, steps, fastest), {8, ground.rows + kReasonLine},
            whole.cols - 16, 0.45, kInk);
  return whole;
}

int vectors(const VectorOptions& options) {
  if (isDevice(options.out)) return fail(options.out + ": not a plain file", kExitBadInput);
  const Status scripts = checkScripts(options.pycode);
  if (!scripts) return fail(scripts.error(), kExitBadInput);
  auto config = makeConfig(options.config);
  if (!config) return fail(config.error(), kExitBadInput);
  SkillQuestion question;
  question.step = options.step;
  if (!std::isnan(options.heading)) question.heading = Angle::deg(options.heading);
  if (!readBall(options, config->field, question.ball))
    return fail(fmt::format("--ball {}: not x,y in cm on the field of {:g} x {:g}", options.ball,
                            config->field.width, config->field.length),
                kExitBadInput);
  behaviour::BehaviourState behaviours(options.pycode);
  const auto number = numberOf(options.skill, behaviours);
  if (!number) return fail(number.error(), kExitBadInput);
  config->behaviour.task.player = PlayerKind::skill;
  config->behaviour.task.skill = *number;
  config->behaviour.reload = false;
  const auto steps = skillField(*config, question, behaviours);
  if (!steps) return fail(steps.error(), kExitBadInput);
  const Status drawn = picture::writePng(options.out, picture(options, *config, question, *steps));
  if (!drawn) return fail(drawn.error(), kExitBadInput);
  fmt::print("{}\n", options.out);
  return kExitDone;
}

}  // namespace

void addVectors(CommandLine& app, int& code) {
  auto command = app.subcommand("vectors", "What a skill asks the legs at each place of the field");
  auto options = std::make_shared<VectorOptions>();
  command.option("SKILL", options->skill, "Its name; a wrong one lists them all").required();
  command.option("--out", options->out, "The picture to write, a PNG file").required();
  command.option("--ball", options->ball, "Where the ball lies: x,y in cm (default: middle)");
  command
      .option("--heading", options->heading,
              "Of the robot, deg, 90 is up-field (default: it faces the ball)")
      .check(inRange(-360.0, 360.0));
  command.option("--step", options->step, "cm between places")
      .check(inRange(5.0, 200.0))
      .showDefault();
  command.option("--pycode", options->pycode, "Behaviours (default: pycode/)")
      .check(existingPath());
  command.option("--field", options->config.field, "2006, osaka2005 or 2004");
  command.option("--team", options->config.team, "red (attacks the blue goal) or blue")
      .check(oneOf({"red", "blue"}));
  command.option("--params", options->config.params, "TOML files, general to specific");
  command.callback([options, &code] { code = vectors(*options); });
}

}  // namespace kelpie::cli
