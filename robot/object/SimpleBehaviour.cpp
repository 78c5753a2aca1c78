// SPDX-License-Identifier: Apache-2.0
// behaviour/Behaviour.h without Python: a program that links this in place of behaviour/ plays with
// the SimplePlayer. There are no scripts, so none can fail; `scripts` is not looked at.
#include <string_view>

#include "behaviour/Behaviour.h"
#include "behaviour/PlayerMark.h"
#include "robot/object/SimplePlayer.h"

namespace kelpie::behaviour {
namespace {

// With the mark in one piece, for tools/stick/Player.h.
constexpr char kPlayer[] = "kelpie player: simple";
static_assert(std::string_view(kPlayer).rfind(kPlayerMark, 0) == 0);

}  // namespace

// The interface's name for what decides.
class PythonHost {
 public:
  object::SimpleState player;
  std::string error;      // stays empty
  RecentReports reports;  // so does this
};

BehaviourState::BehaviourState(const std::string& /*scripts*/, const Constants& /*constants*/,
                               const BehaviourState* /*beside*/)
    : host_(std::make_unique<PythonHost>()) {}

BehaviourState::~BehaviourState() = default;

const std::string& BehaviourState::lastError() const { return host_->error; }

const RecentReports& BehaviourState::reports() const { return host_->reports; }

Expected<Rows> BehaviourState::ask(const std::string& function) {
  return Error{function + ": the simple player has no scripts to ask"};
}

// Not the driver's words: no driver reaches a robot yet, and the check of what comes by network
// makes its refusals' texts with std::to_chars(double), which the SDK's library has not.
Command step(const BehaviourIn& in, const BehaviourParams& /*params*/, BehaviourState& state) {
  return object::step(in, state.host().player);
}

const char* playerName() { return kPlayer + sizeof kPlayerMark - 1; }

}  // namespace kelpie::behaviour
