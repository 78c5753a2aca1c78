// SPDX-License-Identifier: Apache-2.0
#include "tools/desk/Stories.h"

namespace kelpie::desk {
namespace {

using host::Desk;
using host::WatchedSystem;

Event head(double at, double pressure) {
  return {at, [pressure](Desk& desk, WatchedSystem&) { desk.frame.headTouch = pressure; }};
}
Event says(double at, longword bits) {
  return {at, [bits](Desk&, WatchedSystem& system) {
            system.setRobotStatus(orsbBATTERY_CONNECTED | bits);
          }};
}
Event jams(double at) {
  return {at, [](Desk& desk, WatchedSystem& system) {
            system.jam();
            desk.frame.joints[Joint::leftHindKnee] = Angle::deg(110.0);  // it sinks
          }};
}
Event givesBack(double at) {
  return {at, [](Desk&, WatchedSystem& system) { system.giveBack(); }};
}
Event lifts(double at, bool lifted) {
  return {at, [lifted](Desk& desk, WatchedSystem&) { desk.lifted = lifted; }};
}

// A press of the head at two seconds, so that it stands at six, and then what the story is of.
Story after(const char* name, double seconds, std::vector<Event> events) {
  events.insert(events.begin(), {head(2.0, 40.0), head(2.3, 0.0)});
  return {name, seconds, std::move(events)};
}

}  // namespace

std::vector<Story> stories() {
  return {after("start", 6.5, {}),
          after("pause", 12.0, {says(6.5, orsbPAUSE), says(7.5, 0)}),
          after("jam", 11.0, {jams(6.5), givesBack(7.5)}),
          after("empty battery", 10.0, {says(6.5, orsbBATTERY_CAPACITY_LOW)}),
          after("pick-up", 12.0, {lifts(6.5, true), lifts(8.0, false)}),
          after("shutdown", 11.0, {says(6.5, orsbPAUSE)})};
}

JointAngles sprawled() {
  JointAngles joints;
  joints[Joint::leftHindKnee] = joints[Joint::rightHindKnee] = Angle::deg(110.0);
  joints[Joint::leftFrontRotator] = Angle::deg(55.0);
  joints[Joint::neckTilt] = Angle::deg(-70.0);
  return joints;
}

}  // namespace kelpie::desk
