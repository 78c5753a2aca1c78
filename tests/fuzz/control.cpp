// SPDX-License-Identifier: Apache-2.0
// A packet of a game controller of any version. What is taken is in range, says the same when it is
// sent on as version 4, and every robot's view of it is in range.
#include "robot/core/fields/FieldCheck.h"
#include "robot/net/GameControlData.h"
#include "tests/fuzz/Input.h"

namespace {

using namespace kelpie;
using fuzz::require;

void checkViews(const net::GameControlData& control) {
  std::string why;
  for (const TeamColour team : {TeamColour::red, TeamColour::blue})
    for (std::uint8_t player = 1; player <= net::kControlPlayers; ++player)
      require(verify(net::gameStateFrom(control, team, player), &why), "in range: " + why);
}

// Version 4 has one word for who kicks off and for nobody, and always a blue and a red team.
net::GameControlData asVersion4(net::GameControlData control) {
  if (control.dropBall) control.kickOff = TeamColour::blue;
  control.coloursGiven = true;
  return control;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  net::GameControlData control;
  if (net::decodeControl(data, size, control)) return 0;
  require(net::controlVersion(data, size).has_value(), "what is taken has a version");
  std::string why;
  require(verify(control, &why), "what is taken is in range: " + why);
  checkViews(control);
  const auto sent = net::encodeControl(control);
  net::GameControlData back;
  require(!net::decodeControl(sent.data(), sent.size(), back), "what is sent on is taken");
  require(!firstDifference(asVersion4(control), back, &why), "and says the same: " + why);
  net::swapColours(control);
  checkViews(control);
  return 0;
}
