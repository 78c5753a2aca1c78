// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/staging/Staging.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace kelpie::sim {
namespace {

constexpr double kFastest = 300.0;    // cm/s, as BallParams::maxSpeed
constexpr double kLatest = 1e5;       // s, as the longest match
constexpr double kHalfWidth = 9.0;    // cm, of a robot's trunk and legs
constexpr double kBallToBody = 15.0;  // cm from the middle of a body; nearer it lies between legs
// Points along a robot's body, from the neck base: from its nose to its tail.
constexpr std::array<double, 5> kAlongBody = {8.0, 1.0, -6.0, -13.0, -20.0};

// "a:b:c" as its parts.
std::vector<std::string> partsOf(const std::string& words) {
  std::vector<std::string> parts(1);
  for (const char c : words) {
    if (c == ':')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

// "1,-2.5,3" as numbers; nothing when a part is not a finite number or larger than 1e6.
std::vector<double> numbersOf(const std::string& text) {
  std::vector<double> numbers;
  const char* next = text.data();
  const char* const end = next + text.size();
  while (true) {
    double number = 0.0;
    const auto [rest, error] = std::from_chars(next, end, number);
    if (error != std::errc() || !std::isfinite(number) || std::fabs(number) > 1e6) return {};
    numbers.push_back(number);
    if (rest == end) return numbers;
    if (*rest != ',') return {};
    next = rest + 1;
  }
}

bool isInMatch(double seconds) { return seconds >= 0.0 && seconds <= kLatest; }

Error notInMatch(const std::string& words) { return {"'" + words + "': that is not in a match"}; }

std::optional<host::AgentHello> robotOf(const std::string& team, const std::string& player) {
  if ((team != "red" && team != "blue") || player.size() != 1 || player[0] < '1' || player[0] > '4')
    return std::nullopt;
  return host::AgentHello{team == "red" ? TeamColour::red : TeamColour::blue,
                          static_cast<std::uint8_t>(player[0] - '0')};
}

std::string wordFor(const host::AgentHello& robot) {
  return fmt::format("{}:{}", robot.team == TeamColour::red ? "red" : "blue", robot.player);
}

bool onField(const body::FieldDescription& field, Point2<Field> p) {
  return p.x >= 0.0 && p.x <= field.width && p.y >= 0.0 && p.y <= field.length;
}

std::string placeWords(Point2<Field> p) { return fmt::format("({:g}, {:g})", p.x, p.y); }

Point2<Field> bodyPoint(const Pose2& pose, double along) {
  return fieldFromRobot(pose, {0.0, along});
}

double bodyDistance(const Pose2& pose, Point2<Field> p) {
  double nearest = 1e9;
  for (const double along : kAlongBody)
    nearest = std::min(nearest, distance(bodyPoint(pose, along), p));
  return nearest;
}

bool overlap(const Pose2& a, const Pose2& b) {
  return std::any_of(kAlongBody.begin(), kAlongBody.end(), [&](double along) {
    return bodyDistance(b, bodyPoint(a, along)) < 2.0 * kHalfWidth;
  });
}

bool standsIn(const Obstacle& obstacle, const Pose2& pose) {
  return std::any_of(kAlongBody.begin(), kAlongBody.end(), [&](double along) {
    const Point2<Field> p = bodyPoint(pose, along);
    return distance(nearestOn(obstacle, p), p) < kHalfWidth + obstacle.radius;
  });
}

bool standsInSomething(const body::FieldDescription& field, const Pose2& pose) {
  const std::vector<Obstacle> obstacles = obstaclesOf(field);
  return std::any_of(obstacles.begin(), obstacles.end(),
                     [&](const Obstacle& obstacle) { return standsIn(obstacle, pose); });
}

// Nobody stands in anything. Robots that the scenario placed are checked too.
Status checkPlayerCount(const body::FieldDescription& field, const Setup& setup) {
  for (std::size_t i = 0; i < setup.players.size(); ++i) {
    const Player& one = setup.players[i];
    const std::string name = nameOf({one.team, one.number});
    if (standsInSomething(field, one.start))
      return Error{name + " would stand in a goal or beacon"};
    if (bodyDistance(one.start, setup.ball) < kBallToBody)
      return Error{name + " would stand on the ball"};
    for (std::size_t j = 0; j < i; ++j)
      if (overlap(one.start, setup.players[j].start))
        return Error{name + " would stand in " +
                     nameOf({setup.players[j].team, setup.players[j].number})};
  }
  return Done{};
}

bool isAmong(const std::vector<host::AgentHello>& agents, const host::AgentHello& robot) {
  return std::any_of(agents.begin(), agents.end(), [&](const host::AgentHello& agent) {
    return agent.team == robot.team && agent.player == robot.player;
  });
}

// Of balls that are taken, in the order of time, and of those that are thrown.
Status checkTakes(const body::FieldDescription& field, const Setup& setup) {
  double back = -1.0;
  for (const BallTake& take : setup.takes) {
    if (take.time < back)
      return Error{
          fmt::format("the ball is taken at {:g} s, but away until {:g} s", take.time, back)};
    back = take.time + take.seconds;
    for (const BallThrow& thrown : setup.throws)
      if (thrown.time >= take.time && thrown.time <= back)
        return Error{fmt::format("the ball is thrown at {:g} s, but away from {:g} to {:g} s",
                                 thrown.time, take.time, back)};
    const Status place = take.back ? checkBall(field, {*take.back, {}}) : Status(Done{});
    if (!place) return place;
  }
  return Done{};
}

Status checkCarries(const body::FieldDescription& field,
                    const std::vector<host::AgentHello>& agents, const Staging& staging) {
  for (const RobotCarry& carry : staging.carries) {
    const Status checked = checkCarry(field, agents, carry);
    if (!checked) return checked;
  }
  return Done{};
}

Status checkStaging(const body::FieldDescription& field,
                    const std::vector<host::AgentHello>& agents, const Staging& staging) {
  std::vector<host::AgentHello> seen;
  for (const RobotPlace& place : staging.places) {
    const std::string name = nameOf(place.robot);
    if (!isAmong(agents, place.robot)) return Error{"no " + name + " is there to be placed"};
    if (isAmong(seen, place.robot)) return Error{name + " is placed twice"};
    seen.push_back(place.robot);
    if (!onField(field, place.pose.position))
      return Error{name + " at " + placeWords(place.pose.position) + " is off the field"};
  }
  for (const BallThrow& thrown : staging.throws) {
    if (thrown.by && !isAmong(agents, *thrown.by))
      return Error{"no " + nameOf(*thrown.by) + " is there to throw a ball from"};
    const Status ball = thrown.by ? Status(Done{}) : checkBall(field, thrown.ball);
    if (!ball) return ball;
  }
  for (const host::AgentHello& robot : staging.deaf)
    if (!isAmong(agents, robot)) return Error{"no " + nameOf(robot) + " is there to be deaf"};
  const Status carries = checkCarries(field, agents, staging);
  if (!carries) return carries;
  return staging.ball ? checkBall(field, *staging.ball) : Status(Done{});
}

// Brings the players into the order of the agents, each at its own place or the scenario's.
void takePlaces(const std::vector<host::AgentHello>& agents, const Staging& staging, Setup& setup) {
  for (const RobotPlace& place : staging.places)
    setup.players.push_back({place.robot.team, place.robot.player, place.pose});
  std::vector<Player> ordered;
  ordered.reserve(agents.size());
  for (const host::AgentHello& agent : agents)
    ordered.push_back(*std::find_if(setup.players.begin(), setup.players.end(),
                                    [&](const Player& player) { return player.is(agent); }));
  for (Player& player : ordered)
    player.deaf = std::any_of(staging.deaf.begin(), staging.deaf.end(),
                              [&](const host::AgentHello& robot) { return player.is(robot); });
  setup.players = std::move(ordered);
}

}  // namespace

Status checkBall(const body::FieldDescription& field, const Ball& ball) {
  if (!onField(field, ball.position))
    return Error{"the ball at " + placeWords(ball.position) + " is off the field"};
  return Done{};
}

Status checkCarry(const body::FieldDescription& field, const std::vector<host::AgentHello>& agents,
                  const RobotCarry& carry) {
  const std::string name = nameOf(carry.robot);
  if (!isAmong(agents, carry.robot)) return Error{"no " + name + " is there to be carried"};
  if (!onField(field, carry.pose.position))
    return Error{name + " at " + placeWords(carry.pose.position) + " is off the field"};
  if (standsInSomething(field, carry.pose)) return Error{name + " would stand in a goal or beacon"};
  return Done{};
}

Expected<RobotPlace> placeFrom(const std::string& words) {
  const std::vector<std::string> parts = partsOf(words);
  if (parts.size() == 3) {
    const auto robot = robotOf(parts[0], parts[1]);
    const std::vector<double> place = numbersOf(parts[2]);
    if (robot && place.size() == 3)
      return RobotPlace{*robot, {{place[0], place[1]}, Angle::deg(place[2])}};
  }
  return Error{"'" + words + "': a place is TEAM:PLAYER:X,Y,DEG, as in red:1:180,100,90"};
}

Expected<Ball> ballFrom(const std::string& words) {
  const std::vector<double> n = numbersOf(words);
  if (n.size() != 2 && n.size() != 4)
    return Error{"'" + words + "': a ball is X,Y or X,Y,VX,VY, as in 180,270,0,50"};
  Ball ball{{n[0], n[1]}, {}};
  if (n.size() == 4) ball.velocity = {n[2], n[3]};
  if (ball.velocity.norm() > kFastest)
    return Error{fmt::format("'{}': a ball goes no faster than {:g} cm/s", words, kFastest)};
  return ball;
}

Expected<BallThrow> throwFrom(const std::string& words) {
  const std::vector<std::string> parts = partsOf(words);
  const Error form{"'" + words +
                   "': a throw is T:X,Y,VX,VY or T:X,Y,VX,VY:TEAM:PLAYER, as in 4.5:180,270,0,50"};
  if (parts.size() != 2 && parts.size() != 4) return form;
  const std::vector<double> time = numbersOf(parts[0]);
  if (time.size() != 1 || numbersOf(parts[1]).size() != 4) return form;
  if (!isInMatch(time[0])) return notInMatch(words);
  const auto ball = ballFrom(parts[1]);
  if (!ball) return Error{ball.error()};
  BallThrow thrown{time[0], *ball, std::nullopt};
  if (parts.size() == 2) return thrown;
  thrown.by = robotOf(parts[2], parts[3]);
  if (!thrown.by) return form;
  return thrown;
}

Expected<BallTake> takeFrom(const std::string& words) {
  const std::vector<std::string> parts = partsOf(words);
  const Error form{
      "'" + words +
      "': the ball is taken away at T, T:SECONDS or T:SECONDS:X,Y, as in 30:5:100,200"};
  if (parts.size() > 3) return form;
  const std::vector<double> time = numbersOf(parts[0]);
  const std::vector<double> away =
      parts.size() > 1 ? numbersOf(parts[1]) : std::vector<double>{BallTake().seconds};
  if (time.size() != 1 || away.size() != 1) return form;
  if (!isInMatch(time[0]) || !isInMatch(away[0])) return notInMatch(words);
  BallTake take{time[0], away[0], std::nullopt};
  if (parts.size() < 3) return take;
  const std::vector<double> place = numbersOf(parts[2]);
  if (place.size() != 2) return form;
  take.back = Point2<Field>{place[0], place[1]};
  return take;
}

Expected<RobotCarry> carryFrom(const std::string& words) {
  const Error form{"'" + words +
                   "': a robot is carried at T:TEAM:PLAYER:X,Y,DEG, as in 30:red:2:100,200,90"};
  const std::size_t end = words.find(':');
  if (end == std::string::npos) return form;
  const std::vector<double> time = numbersOf(words.substr(0, end));
  const auto place = placeFrom(words.substr(end + 1));
  if (time.size() != 1 || !place) return form;
  if (!isInMatch(time[0])) return notInMatch(words);
  return RobotCarry{time[0], place->robot, place->pose};
}

std::optional<host::AgentHello> robotFrom(const std::string& words) {
  const std::vector<std::string> parts = partsOf(words);
  return parts.size() == 2 ? robotOf(parts[0], parts[1]) : std::nullopt;
}

Expected<Staging> stagingFrom(const StagingWords& words) {
  Staging staging;
  for (const std::string& one : words.places) {
    const auto place = placeFrom(one);
    if (!place) return Error{place.error()};
    staging.places.push_back(*place);
  }
  if (!words.ball.empty()) {
    const auto ball = ballFrom(words.ball);
    if (!ball) return Error{ball.error()};
    staging.ball = *ball;
  }
  for (const std::string& one : words.throws) {
    const auto thrown = throwFrom(one);
    if (!thrown) return Error{thrown.error()};
    staging.throws.push_back(*thrown);
  }
  for (const std::string& one : words.takes) {
    const auto take = takeFrom(one);
    if (!take) return Error{take.error()};
    staging.takes.push_back(*take);
  }
  for (const std::string& one : words.carries) {
    const auto carry = carryFrom(one);
    if (!carry) return Error{carry.error()};
    staging.carries.push_back(*carry);
  }
  for (const std::string& one : words.deaf) {
    const auto robot = robotFrom(one);
    if (!robot) return Error{"'" + one + "': who is deaf is TEAM:PLAYER, as in red:2"};
    staging.deaf.push_back(*robot);
  }
  return staging;
}

std::string wordsFor(const RobotPlace& place) {
  return fmt::format("{}:{},{},{}", wordFor(place.robot), place.pose.position.x,
                     place.pose.position.y, place.pose.heading.deg());
}

std::string wordsFor(const Ball& ball) {
  return fmt::format("{},{},{},{}", ball.position.x, ball.position.y, ball.velocity.x,
                     ball.velocity.y);
}

std::string wordsFor(const BallThrow& thrown) {
  return fmt::format("{}:{}{}", thrown.time, wordsFor(thrown.ball),
                     thrown.by ? ":" + wordFor(*thrown.by) : "");
}

std::string wordsFor(const BallTake& take) {
  const std::string words = fmt::format("{}:{}", take.time, take.seconds);
  return take.back ? fmt::format("{}:{},{}", words, take.back->x, take.back->y) : words;
}

std::string wordsFor(const RobotCarry& carry) {
  return fmt::format("{}:{}", carry.time, wordsFor(RobotPlace{carry.robot, carry.pose}));
}

std::string wordsFor(const host::AgentHello& robot) { return wordFor(robot); }

Expected<Setup> stagedScenario(const std::string& name, const body::FieldDescription& field,
                               const std::vector<host::AgentHello>& agents, std::uint64_t seed,
                               const Staging& staging) {
  const Status staged = checkStaging(field, agents, staging);
  if (!staged) return Error{staged.error()};
  std::vector<host::AgentHello> others;
  for (const host::AgentHello& agent : agents)
    if (std::none_of(staging.places.begin(), staging.places.end(), [&](const RobotPlace& place) {
          return place.robot.team == agent.team && place.robot.player == agent.player;
        }))
      others.push_back(agent);
  auto setup = scenario(name, field, others, seed);
  if (!setup) return setup;
  takePlaces(agents, staging, *setup);
  if (staging.ball) setup->ball = staging.ball->position;
  if (staging.ball) setup->ballVelocity = staging.ball->velocity;
  setup->throws = staging.throws;
  std::stable_sort(setup->throws.begin(), setup->throws.end(),
                   [](const BallThrow& a, const BallThrow& b) { return a.time < b.time; });
  setup->takes = staging.takes;
  std::stable_sort(setup->takes.begin(), setup->takes.end(),
                   [](const BallTake& a, const BallTake& b) { return a.time < b.time; });
  setup->carries = staging.carries;
  const Status takes = checkTakes(field, *setup);
  if (!takes) return Error{takes.error()};
  const Status room = checkPlayerCount(field, *setup);
  if (!room) return Error{room.error()};
  return setup;
}

}  // namespace kelpie::sim
