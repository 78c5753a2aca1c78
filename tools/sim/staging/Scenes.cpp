// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/staging/Scenes.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "robot/core/Random.h"
#include "tools/sim/staging/RivalAttacks.h"

namespace kelpie::sim {
namespace {

constexpr double kShort = 15.0, kLong = 20.0;  // s
constexpr double kKeeper = 22.0;               // cm from the goal line to a keeper's neck base
constexpr double kAside = 15.0;                // cm that a keeper stands aside, at most
constexpr double kFromLines = 20.0;            // cm within which nobody is placed
constexpr int kTries = 400;
constexpr double kJitter = 8.0;       // cm and deg: half a robot's width, so that ways differ
constexpr double kWidens = 100.0;     // tries after which it is twice that
constexpr double kKeepersBox = 28.0;  // cm from the goal line within which a keeper is left
constexpr double kOffBall = 24.0;     // cm from it to a neck base: legal whatever it faces
constexpr TeamColour kRed = TeamColour::red, kBlue = TeamColour::blue;

// cm, from where to where something is drawn.
struct Range {
  double low, high;
};

// One scene as it is drawn, in red's field: red attacks the goal at y = length.
class Drawing {
 public:
  Drawing(const body::FieldDescription& field, std::uint64_t seed, Random& random)
      : inTurn(seed), field_(field), random_(random) {}

  StagedScene scene;
  const std::uint64_t inTurn;  // the seed itself, for what is taken in turn and not drawn
  double tries = 0.0;          // that had no room

  double in(Range range) { return random_.uniform(range.low, range.high); }
  double width() const { return field_.width; }
  double length() const { return field_.length; }
  double middle() const { return 0.5 * field_.width; }
  double post() const { return 0.5 * field_.goalWidth; }  // cm from the middle
  Point2<Field> ball() const { return scene.staging.ball->position; }
  // Wider from try to try: the narrow field of 2004 leaves no room to scrums of 2005 else.
  double jitter() { return random_.gaussian(0.0, kJitter * (1.0 + tries / kWidens)); }
  double side() { return random_.chance(0.5) ? 1.0 : -1.0; }

  void ballAt(double x, double y) { scene.staging.ball = Ball{{x, y}, {}}; }
  void ballAnywhere() { ballAt(in({60.0, width() - 60.0}), in({80.0, length() - 80.0})); }

  void add(TeamColour team, int number, Point2<Field> place, Angle heading) {
    const host::AgentHello robot{team, static_cast<std::uint8_t>(number)};
    scene.staging.places.push_back({robot, {place, heading}});
  }
  void addFacing(TeamColour team, int number, Point2<Field> place, Point2<Field> target) {
    add(team, number, place, directionOf(place, target) + Angle::deg(in({-20.0, 20.0})));
  }

  // Someone at that distance from the ball, in any direction, looking anywhere.
  void near(TeamColour team, int number, Range far) {
    add(team, number, around(ball(), {-180.0, 180.0}, far), Angle::deg(in({-180.0, 180.0})));
  }
  // So, in those directions from the ball (deg, 0 is up-field, left is positive), facing it.
  void facing(TeamColour team, int number, Range directions, Range far) {
    addFacing(team, number, around(ball(), directions, far), ball());
  }
  void keeper(TeamColour team) {
    const double x = middle() + in({-kAside, kAside});
    const bool red = team == kRed;
    add(team, 1, {x, red ? kKeeper : length() - kKeeper}, Angle::deg(red ? 90.0 : -90.0));
  }
  void keepers() {
    keeper(kRed);
    keeper(kBlue);
  }

  // On the field, if there is room in those directions.
  Point2<Field> around(Point2<Field> centre, Range directions, Range far) {
    constexpr int kDraws = 30;
    Point2<Field> place;
    for (int i = 0; i < kDraws; ++i) {
      const Angle direction = Angle::deg(90.0 + in(directions));
      const double way = in(far);
      place = {centre.x + way * direction.cos(), centre.y + way * direction.sin()};
      if (distance(place, inside(place)) == 0.0) break;
    }
    return inside(place);
  }

 private:
  static Angle directionOf(Point2<Field> from, Point2<Field> to) {
    return Angle::rad(maths::atan2(to.y - from.y, to.x - from.x));
  }
  Point2<Field> inside(Point2<Field> p) const {
    return {std::clamp(p.x, kFromLines, width() - kFromLines),
            std::clamp(p.y, kFromLines, length() - kFromLines)};
  }

  const body::FieldDescription& field_;
  Random& random_;
};

void freeBall(Drawing& draw) {
  draw.ballAnywhere();
  draw.keepers();
  draw.near(kRed, 2, {60.0, 200.0});
  draw.near(kBlue, 2, {60.0, 200.0});
}

void contested(Drawing& draw) {
  draw.ballAnywhere();
  draw.keepers();
  const double from = draw.in({-180.0, 180.0});
  draw.facing(kRed, 2, {from - 30.0, from + 30.0}, {25.0, 40.0});
  draw.facing(kBlue, 2, {from + 150.0, from + 210.0}, {25.0, 40.0});
}

// Red defends.
void ownBox(Drawing& draw) {
  draw.ballAt(draw.middle() + draw.in({-70.0, 70.0}), draw.in({45.0, 90.0}));
  draw.keepers();
  draw.near(kRed, 2, {70.0, 160.0});
  draw.facing(kBlue, 2, {-60.0, 60.0}, {40.0, 120.0});
}

void corner(Drawing& draw) {
  draw.ballAt(draw.middle() + draw.side() * (draw.middle() - draw.in({12.0, 40.0})),
              draw.length() - draw.in({12.0, 40.0}));
  draw.keepers();
  draw.near(kRed, 2, {50.0, 130.0});
  draw.near(kBlue, 2, {50.0, 130.0});
}

void edge(Drawing& draw) {
  draw.ballAt(draw.middle() + draw.side() * (draw.middle() - draw.in({10.0, 28.0})),
              draw.in({110.0, draw.length() - 110.0}));
  draw.keepers();
  draw.near(kRed, 2, {40.0, 150.0});
  draw.near(kBlue, 2, {40.0, 150.0});
}

// The ball before blue's goal, a red robot behind it.
void shotPlace(Drawing& draw) {
  draw.ballAt(draw.middle() + draw.in({-90.0, 90.0}), draw.length() - draw.in({80.0, 220.0}));
  draw.facing(kRed, 2, {120.0, 240.0}, {25.0, 70.0});
  draw.keepers();
}

void goalieTwo(Drawing& draw) {
  shotPlace(draw);
  draw.near(kRed, 3, {80.0, 200.0});
}

void twoTwo(Drawing& draw) {
  draw.ballAnywhere();
  draw.keepers();
  for (const int number : {2, 3})
    for (const TeamColour team : {kRed, kBlue}) draw.near(team, number, {50.0, 250.0});
}

void threeThree(Drawing& draw) {
  twoTwo(draw);
  for (const TeamColour team : {kRed, kBlue}) draw.near(team, 4, {100.0, 300.0});
}

// Red has it.
void kickOff(Drawing& draw) {
  draw.ballAt(draw.middle(), 0.5 * draw.length());
  draw.keepers();
  draw.facing(kRed, 2, {160.0, 200.0}, {30.0, 60.0});
  draw.facing(kRed, 3, {110.0, 150.0}, {80.0, 130.0});
  draw.facing(kRed, 4, {170.0, 190.0}, {140.0, 170.0});
  draw.facing(kBlue, 2, {-20.0, 20.0}, {60.0, 80.0});
  draw.facing(kBlue, 3, {30.0, 70.0}, {80.0, 130.0});
  draw.facing(kBlue, 4, {-10.0, 10.0}, {140.0, 170.0});
}

void throwInBall(Drawing& draw) {
  draw.ballAt(draw.middle() + draw.side() * (draw.middle() - 50.0),
              draw.in({110.0, draw.length() - 110.0}));
  draw.keepers();
  for (const TeamColour team : {kRed, kBlue}) {
    draw.near(team, 2, {50.0, 120.0});
    draw.near(team, 3, {120.0, 250.0});
    draw.near(team, 4, {150.0, 300.0});
  }
}

void scrum(Drawing& draw) {
  draw.ballAt(draw.middle() + draw.in({-60.0, 60.0}), draw.length() - draw.in({50.0, 110.0}));
  draw.keepers();
  for (const int number : {2, 3})
    for (const TeamColour team : {kRed, kBlue}) draw.near(team, number, {25.0, 70.0});
}

// An opponent stands between red's forward and the ball.
void behind(Drawing& draw) {
  draw.ballAnywhere();
  draw.keepers();
  const double from = draw.in({-180.0, 180.0});
  draw.facing(kBlue, 2, {from - 20.0, from + 20.0}, {30.0, 45.0});
  draw.facing(kRed, 2, {from - 15.0, from + 15.0}, {85.0, 150.0});
}

// The ball within 60 cm of blue's goal, a defender and the goalie before it.
void finish(Drawing& draw) {
  draw.ballAt(draw.middle() + draw.in({-55.0, 55.0}), draw.length() - draw.in({15.0, 60.0}));
  draw.facing(kRed, 2, {110.0, 250.0}, {24.0, 60.0});
  draw.facing(kBlue, 2, {-180.0, 180.0}, {30.0, 80.0});
  draw.keepers();
}

// The ball before a goal line that nobody guards, wherever its forward comes from.
void openLine(Drawing& draw) {
  draw.ballAt(draw.middle() + draw.in({5.0 - draw.post(), draw.post() - 5.0}),
              draw.length() - draw.in({6.0, 15.0}));
  draw.keeper(kRed);
  draw.facing(kRed, 2, {90.0, 270.0}, {24.0, 80.0});
}

// The ball beside a post, a forward and the goalie at it.
void post(Drawing& draw) {
  const double side = draw.side();
  draw.ballAt(draw.middle() + side * (draw.post() + draw.in({-4.0, 12.0})),
              draw.length() - draw.in({6.0, 14.0}));
  draw.keeper(kRed);
  draw.facing(kRed, 2, {110.0, 250.0}, {24.0, 30.0});
  const double x = draw.ball().x - side * draw.in({20.0, 30.0});
  draw.addFacing(kBlue, 1, {x, draw.length() - kKeeper}, draw.ball());
}

// The ball in a corner, one of each team at it.
void jam(Drawing& draw) {
  draw.ballAt(draw.middle() + draw.side() * (draw.middle() - draw.in({6.0, 12.0})),
              draw.length() - draw.in({6.0, 12.0}));
  draw.keepers();
  draw.facing(kRed, 2, {-180.0, 180.0}, {24.0, 36.0});
  draw.facing(kBlue, 2, {-180.0, 180.0}, {24.0, 36.0});
}

// Red's forward has the ball before it, an opponent 125 cm ahead of that.
void ahead(Drawing& draw) {
  draw.ballAt(draw.middle() + draw.in({-60.0, 60.0}), 140.0);
  draw.keepers();
  draw.facing(kRed, 2, {155.0, 205.0}, {30.0, 40.0});
  draw.facing(kBlue, 2, {-7.0, 7.0}, {124.0, 126.0});
}

// The recorded attacks, on whatever field: places are shares of it, velocities stay.
class RivalDrawing {
 public:
  explicit RivalDrawing(Drawing& draw)
      : draw_(draw),
        side_(draw.side()),
        across_(draw.width() / kRivalWidth),
        along_(draw.length() / kRivalLength) {}

  void ball(const RivalAttack& attack) {
    const Point2<Field> place = at(attack.ball[0], attack.ball[1]);
    draw_.scene.staging.ball = Ball{place, {side_ * attack.velocity[0], attack.velocity[1]}};
  }

  void robot(TeamColour team, int number, const RivalPlace& place) {
    const double heading = side_ > 0.0 ? place.heading : 180.0 - place.heading;
    Point2<Field> where = place.off ? corner(team, number) : at(place.x, place.y);
    if (!place.off) where = {where.x + draw_.jitter(), where.y + draw_.jitter()};
    if (number == 1) where.y = inBox(team, where.y);
    if (!place.off) where = offBall(where);
    if (place.off)
      draw_.addFacing(team, number, where, draw_.ball());
    else
      draw_.add(team, number, where, Angle::deg(heading + draw_.jitter()));
  }

 private:
  Point2<Field> at(double x, double y) const {
    return {draw_.middle() + side_ * across_ * (x - 0.5 * kRivalWidth), along_ * y};
  }
  // Nobody begins on the ball, though three of the runners had it between their paws.
  Point2<Field> offBall(Point2<Field> p) const {
    const Point2<Field> ball = draw_.ball();
    const double away = std::max(distance(p, ball), 0.1);
    if (away >= kOffBall) return p;
    const double share = kOffBall / away;
    return {ball.x + share * (p.x - ball.x), ball.y + share * (p.y - ball.y)};
  }
  // Who served a penalty was out of play, and so it is here: by a corner of its own half.
  Point2<Field> corner(TeamColour team, int number) {
    const double x = draw_.middle() + draw_.side() * (draw_.middle() - draw_.in({35.0, 70.0}));
    const double up = number == 1 ? kKeeper : draw_.in({30.0, 80.0});
    return {x, team == kRed ? up : draw_.length() - up};
  }
  double inBox(TeamColour team, double y) const {
    return team == kRed ? std::clamp(y, 0.0, kKeepersBox)
                        : std::clamp(y, draw_.length() - kKeepersBox, draw_.length());
  }

  Drawing& draw_;
  double side_, across_, along_;
};

// Red defends. The seed takes the six in turn: were they drawn, those with room would prevail.
void rivalAttack(Drawing& draw) {
  const RivalAttack& attack = kRivalAttacks[draw.inTurn % kRivalAttacks.size()];
  RivalDrawing rival(draw);
  rival.ball(attack);
  for (std::size_t i = 0; i < attack.attack.size(); ++i) {
    rival.robot(kBlue, static_cast<int>(i) + 1, attack.attack[i]);
    rival.robot(kRed, static_cast<int>(i) + 1, attack.defence[i]);
  }
}

struct Kind {
  const char* name;
  const char* robots;
  double seconds;
  void (*draw)(Drawing&);
};

constexpr Kind kKinds[] = {
    {"free-ball", "2v2", kShort, freeBall},
    {"contested", "2v2", kShort, contested},
    {"own-box", "2v2", kShort, ownBox},
    {"corner", "2v2", kShort, corner},
    {"edge", "2v2", kShort, edge},
    {"goalie-one", "2v1", kShort, shotPlace},
    {"goalie-two", "3v1", kShort, goalieTwo},
    {"two-two", "3v3", kShort, twoTwo},
    {"three-three", "4v4", kLong, threeThree},
    {"kick-off", "4v4", kLong, kickOff},
    {"throw-in", "4v4", kLong, throwInBall},
    {"scrum", "3v3", kShort, scrum},
    {"behind", "2v2", kShort, behind},
    {"rival-attack", "4v4", kLong, rivalAttack},
    {"finish", "2v2", kShort, finish},
    {"open-line", "2v0", kShort, openLine},
    {"post", "2v1", kShort, post},
    {"jam", "2v2", kShort, jam},
    {"ahead", "2v2", kLong, ahead},
};

std::vector<host::AgentHello> robotsOf(const StagedScene& scene) {
  std::vector<host::AgentHello> robots;
  for (const RobotPlace& place : scene.staging.places) robots.push_back(place.robot);
  return robots;
}

// So that no two kinds draw the same numbers.
std::uint64_t seedOf(std::uint64_t seed, std::size_t kind) {
  return Random(seed ^ (0x5ce9e000ULL + (static_cast<std::uint64_t>(kind) << 32U))).next();
}

}  // namespace

const std::vector<std::string>& sceneKinds() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Kind& kind : kKinds) all.emplace_back(kind.name);
    return all;
  }();
  return names;
}

Expected<StagedScene> drawScene(const std::string& kind, const body::FieldDescription& field,
                                std::uint64_t seed) {
  const auto found = std::find_if(std::begin(kKinds), std::end(kKinds),
                                  [&](const Kind& one) { return one.name == kind; });
  if (found == std::end(kKinds))
    return Error{fmt::format("no scene \"{}\"; there are {}", kind, fmt::join(sceneKinds(), ", "))};
  Random random(seedOf(seed, static_cast<std::size_t>(found - std::begin(kKinds))));
  std::string why;
  for (int i = 0; i < kTries; ++i) {
    Drawing drawing(field, seed, random);
    drawing.tries = i;
    drawing.scene.robots = found->robots;
    drawing.scene.seconds = found->seconds;
    found->draw(drawing);
    const auto setup =
        stagedScenario("kickoff", field, robotsOf(drawing.scene), seed, drawing.scene.staging);
    if (setup) return drawing.scene;
    why = setup.error();
  }
  return Error{fmt::format("scene {}: no room on this field: {}", kind, why)};
}

}  // namespace kelpie::sim
