// SPDX-License-Identifier: Apache-2.0
// The place of one robot whose agent is somebody else's program, which nobody here has tried: it
// may never come, say nonsense, think for ever, read nothing, or die. None of this stops the match.
// Each place has a socket of its own, so that no agent can take another's. An agent has so much
// real time for its answer to a step; after that it is late, and the match goes on without it: no
// step is sent to it until it has answered those that it got, and an answer counts when it comes.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/host/world/GuardedLine.h"

namespace kelpie::sim {

class Stranger {
 public:
  // Listens at the socket for that robot's agent, which has `limit` s for each answer.
  static Expected<Stranger> open(const std::string& socket, const host::AgentHello& robot,
                                 double limit);

  // Takes the agent that has come, if the place is free. Waits no longer than that; nobody may be
  // sending.
  bool look(double seconds);
  bool present() const { return line_ && !lost_; }
  // Present, and not late.
  bool takesSteps() const { return present() && !late_; }
  int life() const { return lives_; }  // which of those that came
  void absent(double waited);          // nobody came in that time; said once

  void owe() { ++owed_; }  // a step is under way
  // Never waits; may be called while another thread is inside hear().
  void send(host::MessageType type, const std::vector<std::uint8_t>& body);
  // Its answers, in turn. With `waits` for one of them, as long as the limit and if it is not late;
  // otherwise for none.
  void hear(TimeUs now, bool waits, const std::function<void(const host::AgentReply&)>& obey);

  // Command vectors whose output has ended and that the agent has not been told of.
  std::uint32_t vectorsDone = 0;
  // What people should know of it since the last call, a line each; of all its life some lines.
  std::vector<std::string> takeNews();
  // How often it was late; nothing unless more than once.
  std::optional<std::string> lateness() const;

 private:
  Stranger(host::Listener listener, const host::AgentHello& robot, double limit)
      : listener_(std::move(listener)), robot_(robot), limit_(limit) {}
  void greet();
  Expected<bool> hearOne(double seconds, const std::function<void(const host::AgentReply&)>& obey);
  void beLate(TimeUs now);
  void turnAway(const std::string& why);
  void lose(const std::string& why);
  void tell(const std::string& line);
  std::string title() const;

  host::Listener listener_;
  host::AgentHello robot_;
  double limit_;                               // s
  std::unique_ptr<host::GuardedLine> line_;    // of who is present, or was
  bool lost_ = false;                          // its agent is gone
  std::unique_ptr<host::GuardedLine> caller_;  // who has come and not yet said hello
  std::vector<std::uint8_t> body_;             // of the message at hand
  int owed_ = 0;                               // answers
  bool late_ = false;
  int timesLate_ = 0;
  int lives_ = 0;
  int told_ = 0;  // lines
  std::vector<std::string> news_;
};

}  // namespace kelpie::sim
