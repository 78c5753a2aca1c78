// SPDX-License-Identifier: Apache-2.0
// Everything the camera loop gets to know: image, body, sensors, odometry, game, the last Command
// and what a driver asks. It is logged whole, so that a replay of inputs gives the same outputs.
#pragma once

#include <cstdint>
#include <tuple>
#include <type_traits>

#include "robot/core/Time.h"
#include "robot/core/types/CameraLight.h"
#include "robot/core/types/CameraModel.h"
#include "robot/core/types/Command.h"
#include "robot/core/types/ControlPacket.h"
#include "robot/core/types/Image.h"
#include "robot/core/types/Motion.h"
#include "robot/core/types/Radio.h"
#include "robot/core/types/TeamMessage.h"

namespace kelpie {

enum class TeamColour : std::uint8_t { red, blue };  // red defends the yellow goal
enum class PlayState : std::uint8_t { initial, ready, set, playing, finished };

struct GameState {
  PlayState state = PlayState::playing;
  TeamColour team = TeamColour::red;
  std::uint8_t player = 1;
  bool penalised = false;
  std::uint8_t ownScore = 0;
  std::uint8_t opponentScore = 0;
  bool kickOff = false;  // of the own team, in ready and set
  bool firstHalf = true;
  double secondsLeft = 0.0;  // of the half

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(
        field("state", &GameState::state, "", 0, 4), field("team", &GameState::team, "", 0, 1),
        field("player", &GameState::player, "", 1, 4), field("penalised", &GameState::penalised),
        field("ownScore", &GameState::ownScore), field("opponentScore", &GameState::opponentScore),
        field("kickOff", &GameState::kickOff), field("firstHalf", &GameState::firstHalf),
        field("secondsLeft", &GameState::secondsLeft, "s", 0, 1e5));
  }
};

// What a person who drives the robot asks of its body, newest. It comes by network as the game
// state does. While it is present the behaviours are not asked.
struct Drive {
  bool present = false;
  Command command;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("present", &Drive::present), field("command", &Drive::command));
  }
};

// How fast the head joints turned during the exposure.
struct HeadRate {
  double neckTilt = 0.0;  // rad/s
  double headPan = 0.0;   // rad/s
  double headNod = 0.0;   // rad/s

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("neckTilt", &HeadRate::neckTilt, "rad/s", -60, 60),
                     field("headPan", &HeadRate::headPan, "rad/s", -60, 60),
                     field("headNod", &HeadRate::headNod, "rad/s", -60, 60));
  }
};

struct FrameInput {
  std::uint32_t frame = 0;          // counts camera frames of this robot from 0
  TimeUs time;                      // middle of the exposure
  double elapsed = 0.0;             // s since the previous frame; 0 for the first
  std::uint32_t droppedFrames = 0;  // images that the camera took since the first and nobody got
  SensorFrame sensors;  // joints at the middle of the exposure, latest of everything else
  HeadRate headRate;
  Stance stance;
  CameraTilt cameraTilt;  // believed after the previous frame
  FocalScale focalScale;  // so
  ImageLag imageLag;      // so; joints, head rate and odometry are those of that much before `time`
  CameraLight light;      // so
  Odometry odometry;      // from the exposure of the previous frame to that of this one
  MotionStatus motion;
  Battery battery;
  GameState game;
  Command lastCommand;
  Drive drive;
  FixedVector<TeamMessage, kTeammates> team;  // heard since the previous frame
  RadioCounts radio;                          // since the start
  ControlCounts control;                      // so, of the game controller
  Image image;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(
        field("frame", &FrameInput::frame), field("time", &FrameInput::time, "us"),
        field("elapsed", &FrameInput::elapsed, "s", 0, 10),
        field("droppedFrames", &FrameInput::droppedFrames), field("sensors", &FrameInput::sensors),
        field("headRate", &FrameInput::headRate), field("stance", &FrameInput::stance),
        field("cameraTilt", &FrameInput::cameraTilt), field("focalScale", &FrameInput::focalScale),
        field("imageLag", &FrameInput::imageLag), field("light", &FrameInput::light),
        field("odometry", &FrameInput::odometry), field("motion", &FrameInput::motion),
        field("battery", &FrameInput::battery), field("game", &FrameInput::game),
        field("lastCommand", &FrameInput::lastCommand), field("drive", &FrameInput::drive),
        field("team", &FrameInput::team), field("radio", &FrameInput::radio),
        field("control", &FrameInput::control), field("image", &FrameInput::image));
  }
};

namespace detail {

template <class Struct, class Member>
constexpr auto unlessImage(FieldOf<Struct, Member> f) {
  if constexpr (std::is_same_v<Member, Image>) {
    return std::tuple<>();
  } else {
    return std::make_tuple(f);
  }
}

}  // namespace detail

// The field list of a message that has something else in place of the image.
template <class Fields, class Instead>
constexpr auto withoutImage(Fields fields, Instead instead) {
  return fields.apply([instead](const auto&... fs) {
    return std::apply([](const auto&... kept) { return fieldList(kept...); },
                      std::tuple_cat(detail::unlessImage(fs)..., std::make_tuple(instead)));
  });
}

}  // namespace kelpie
