// SPDX-License-Identifier: Apache-2.0
#include "tools/broadcast/SplitFilm.h"

#include <algorithm>

#include "tools/broadcast/Captions.h"
#include "tools/broadcast/Overlay.h"
#include "tools/match/drawing/CameraDrawing.h"
#include "tools/match/drawing/Inks.h"

namespace kelpie::broadcast {
namespace {

using namespace picture;
namespace inks = match::inks;

constexpr double kTileWide = 216.0;
constexpr double kTileHigh = kTileWide * kImageHeight / kImageWidth;
constexpr double kBetween = 12.0;
constexpr Frame kStageFrame{240.0, 10.0, 800.0, 450.0};
constexpr Frame kMap{240.0, 472.0, 380.0, 238.0};
constexpr Frame kCalls{644.0, 476.0, 396.0, 230.0};
constexpr std::size_t kCallCount = 8;

// The whole field, from where the stand is.
View wholeField(const body::FieldDescription& field) {
  View view;
  view.target = {0.0054 * field.width, 0.005 * field.length, 0.0};
  view.eye = {0.01 * field.width + 3.3, 0.005 * field.length, 3.4};
  return view;
}

Frame tileOf(TeamColour team, int player) {
  const double x = team == TeamColour::red ? 10.0 : 1280.0 - 10.0 - kTileWide;
  return {x, 10.0 + (player - 1) * (kTileHigh + kBetween), kTileWide, kTileHigh};
}

std::string titleOf(const Feed* feed, TeamColour team, int player) {
  const std::string name = nameOf(team, player);
  if (feed == nullptr || !feed->any()) return name;
  const Role role = feed->moment().output.command.team.role;
  if (role == Role::none) return name;
  return name + ", " + kRoleNames[static_cast<std::size_t>(role)];
}

}  // namespace

Expected<SplitFilm> SplitFilm::create(const match::Match& match, Course course,
                                      const std::vector<std::string>& logs, double sharpness) {
  const auto fonts = Canvas::create({1, 1}, inks::kGround);
  if (!fonts) return Error{fonts.error()};
  auto stage = Stage::build(
      match.field(), course.players(),
      {static_cast<int>(kStageFrame.width), static_cast<int>(kStageFrame.height)}, sharpness);
  if (!stage) return Error{stage.error()};
  SplitFilm film(match, std::move(course), std::move(*stage));
  for (const std::string& log : logs) {
    auto feed = Feed::open(log);
    if (!feed) return Error{feed.error()};
    film.feeds_.push_back(std::move(*feed));
  }
  return Expected<SplitFilm>(std::move(film));
}

SplitFilm::SplitFilm(const match::Match& match, Course course, Stage stage)
    : match_(&match),
      course_(std::move(course)),
      stage_(std::move(stage)),
      facts_(match::factsOf(match.notes(), match.team(), match.player())) {}

Feed* SplitFilm::feedOf(TeamColour team, int player) {
  const auto found = std::find_if(feeds_.begin(), feeds_.end(), [&](const Feed& feed) {
    return feed.team() == team && feed.player() == player;
  });
  return found == feeds_.end() ? nullptr : &*found;
}

void SplitFilm::drawTile(Canvas& canvas, TeamColour team, int player, const Tableau& tableau) {
  const Frame frame = tileOf(team, player);
  const Feed* const feed = feedOf(team, player);
  const bool plays =
      std::any_of(tableau.actors.begin(), tableau.actors.end(),
                  [&](const Actor& actor) { return actor.team == team && actor.player == player; });
  if (feed != nullptr && feed->any()) {
    match::drawCameraView(canvas, frame, feed->moment());
  } else {
    canvas.box(frame, inks::kPanel, 6.0);
    const Spot middle{frame.x + 0.5 * frame.width, frame.y + 0.5 * frame.height - 9.0};
    canvas.text(middle, plays ? "no log" : "does not play",
                {13.0, inks::kQuiet, false, Align::centre});
  }
  const std::string title = titleOf(feed, team, player);
  const Type type{12.0, {1.0, 1.0, 1.0}, true};
  const double wide = canvas.measure(title, type).width + 14.0;
  const Ink ground = team == TeamColour::red ? Ink{0.72, 0.13, 0.13} : Ink{0.15, 0.28, 0.72};
  canvas.box({frame.x, frame.y, wide, 21.0}, ground.faded(plays ? 1.0 : 0.5), 6.0);
  canvas.text({frame.x + 7.0, frame.y + 3.0}, title, type);
}

Expected<cv::Mat> SplitFilm::frame(const match::Moment& moment) {
  const double seconds = moment.input.time.seconds();
  for (Feed& feed : feeds_) feed.advance(seconds);
  const Tableau tableau = course_.at(seconds);
  stage_.put(tableau);
  const View view = wholeField(match_->field());
  const auto stage = stage_.shoot(view);
  if (!stage) return stage;
  match::add(moment, facts_);
  match::score(course_.events(), moment.input.time, facts_);
  auto canvas = Canvas::create(size(), inks::kGround);
  if (!canvas) return Error{canvas.error()};
  canvas->paste(*stage, kStageFrame, false);
  drawScore(*canvas, {kStageFrame.x + 14.0, kStageFrame.y + 12.0}, facts_);
  drawBanner(*canvas, kStageFrame, bannerAt(course_.events(), seconds));
  drawMap(*canvas, kMap, match_->field(), tableau, nullptr);
  const Actor* const holder = course_.holderOf(tableau, seconds);
  drawCalls(*canvas, kCalls, ballWords(holder, tableau.ballThere),
            callsUntil(course_.events(), seconds, kCallCount));
  for (const TeamColour team : {TeamColour::red, TeamColour::blue})
    for (int player = 1; player <= static_cast<int>(kRobotsOfTeam); ++player)
      drawTile(*canvas, team, player, tableau);
  return canvas->picture();
}

}  // namespace kelpie::broadcast
