// SPDX-License-Identifier: Apache-2.0
// A World for agent processes: sends each what its robot senses and sees, waits for what it sends
// to the effectors, and lets time go on. Sensors every 32 ms, images every 1/30 s, in the order of
// time; no agent can be late, and none can be early. Images take most of a match's time: they are
// rendered on all cores, while the bodies already move on to the next one, and while agents still
// think about the last one. Of an agent's two command vectors in flight one lasts for these 32 ms,
// so that none comes too late; what an agent sends without them, such as gains, waits until then.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/log/LogWriter.h"
#include "robot/host/world/Connection.h"
#include "tools/sim/world/Stranger.h"
#include "tools/sim/world/ThreadPool.h"
#include "tools/sim/world/World.h"

namespace kelpie::sim {

struct Agent {
  host::Connection connection;
  host::AgentHello hello;
  bool present = true;
  int life = 0;        // which of those that came by this name
  std::string lost{};  // why, if it is no longer present
  // Of a robot that somebody else's program plays, in place of the connection.
  std::unique_ptr<Stranger> stranger{};

  bool takesSteps() const { return stranger ? stranger->takesSteps() : present; }
  int lifeNow() const { return stranger ? stranger->life() : life; }
};

// The next agent that comes to an open socket within that time.
Expected<Agent> nextAgent(host::Listener& listener, double seconds);

// Waits for `count` agents at an open socket and sorts them by team and number; gives up within a
// tenth of a second when `stopped` says so.
Expected<std::vector<Agent>> gatherAgents(host::Listener& listener, std::size_t count,
                                          double seconds,
                                          const std::function<bool()>& stopped = {});

// Opens a place for each of those robots, at SOCKET-red-1 and so on.
Expected<std::vector<Agent>> openStrangers(const std::string& socket,
                                           const std::vector<host::AgentHello>& robots,
                                           double limit);
// Waits at most so long for their agents, and adds their robots to the others in their order.
void addStrangers(std::vector<Agent> strangers, double seconds,
                  const std::function<bool()>& stopped, std::vector<Agent>& agents);

// What else hears of a match while it is played; each may be empty.
struct ServerHooks {
  std::function<void(const MatchEvent&)> onEvent;
  std::function<void(TimeUs now)> beforeStep;  // may wait
  std::function<bool()> stopped;               // ends the match before its time
  std::function<void()> hear;                  // between steps: what has come for the world
  // Who has come since the last call, if somebody has. With it an agent that dies does not end the
  // match: its robot stands until an agent of that name is there again. While there is none at all
  // the match waits, half a minute at most.
  std::function<std::optional<Agent>()> arrival;
  std::function<void(const std::string&)> tell;  // of who talks nonsense, or is there again
};

class Server {
 public:
  // `log` may be null. World and log must outlive the server.
  Server(World& world, std::vector<Agent>& agents, LogWriter* log, ServerHooks hooks = {});

  // Plays to the end. An agent that dies or talks nonsense ends the match with one line, unless
  // there is a hook for arrivals.
  Status run();

 private:
  // What happens at one time, and how it is said to each robot.
  struct Step {
    TimeUs now;
    bool sensors = false;
    bool image = false;
    std::vector<std::vector<std::uint8_t>> messages;
    // Of each robot: the life of the agent that it is sent to, and what became of that.
    std::vector<int> lives;
    std::vector<Status> sent;
  };
  static constexpr int kNobody = -1;
  struct Arrival {
    Agent agent;
    int tries = 60;  // a second of play
  };
  Step nextStep() const;
  Status moveTo(TimeUs now);
  void prepare(Step step);
  Status moveAhead();
  void begin(Step& step);
  Status startNext();
  void send(Step& step);
  Status sendTo(std::size_t robot, const Step& step);
  Status takeReplies(const Step& step);
  bool isThere(const Step& step) const;
  bool ends() const;
  Status takeReply(std::size_t robot);
  void takeAnswers(std::size_t robot, const Step& step);
  void obey(std::size_t robot, const host::AgentReply& reply);
  std::uint32_t takeVectorsDone(std::size_t robot);
  void lookForStrangers();
  void tellNews(Stranger& stranger);
  Status refuse(std::size_t robot, const std::string& why);
  Status lose(std::size_t robot, const std::string& why);
  bool takesPlace(Agent& agent);
  void welcome();
  bool isAnybodyThere() const;
  void waitForSomebody();
  Status playOn();
  void writeTruth(TimeUs now, bool image);
  void sayGoodbye(std::uint8_t reason);
  std::string nameOf(std::size_t robot) const;

  World& world_;
  std::vector<Agent>& agents_;
  LogWriter* log_;
  ServerHooks hooks_;
  std::vector<Arrival> waiting_;  // until a place is free
  // Of one robot, so that all images can be rendered at the same time.
  struct Outbox {
    std::vector<std::uint8_t> buffer;
    Image image;
  };
  std::vector<std::unique_ptr<Outbox>> outboxes_;
  std::vector<std::uint8_t> buffer_;
  Past exposed_;  // what the images show that are being rendered
  std::int64_t messages_ = 1;
  std::int64_t images_ = 1;
  std::deque<Step> open_;  // steps whose answers have not been taken, the oldest first
  bool over_ = false;      // the last of them ends the match
  ThreadPool pool_;        // renders and sends the images of the last of them
};

}  // namespace kelpie::sim
