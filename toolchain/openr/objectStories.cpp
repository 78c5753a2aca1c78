// SPDX-License-Identifier: Apache-2.0
// object-stories TAPE PYCODE   plays each story of tools/desk through the OPEN-R object, the loops
// and the power service of the stand-in here, on the PC, and writes what passed between object and
// loops: what toolchain/emulate plays to the loops in the emulated image. Says of each story how
// fast a joint was asked to move before the robot played. Exit code 0: written, 1: a joint was
// asked for more than 60 deg/s, 2: no tape.
#include <cstdio>
#include <memory>
#include <string>

#include "robot/agent/loops/AgentLoops.h"
#include "robot/host/AgentStub.h"
#include "toolchain/openr/AgentTape.h"
#include "toolchain/openr/TapeWriter.h"
#include "tools/desk/Stories.h"

namespace {

using namespace kelpie;

constexpr double kMaxDegrees = 60.01;    // a second, of rounding
constexpr std::int32_t kImageEvery = 8;  // messages; a second without one is a story of its own

// Between the object and the loops: notes what passes. Is the loops' log, too, to see their frames.
class TapedLoops : public agent::Loops, public agent::LogSink {
 public:
  TapedLoops(tape::TapeWriter& out, const agent::AgentConfig& config, const std::string& scripts)
      : out_(out), loops_(config, scripts, *this) {
    out_.put('s', config);
  }

  const MotionOutput& motion(const MotionInput& input) override {
    const MotionOutput& output = loops_.motion(input);
    answer_ = {output, loops_.motors()};
    out_.put('n', input, answer_);
    const bool plays = output.status.ready && answer_.motors.rest == Rest::none;
    if (plays && playsFrom == 0.0) playsFrom = input.time.seconds();
    return output;
  }
  const agent::MotorsOut& motors() const override { return loops_.motors(); }
  void power(const agent::PowerReport& report) override {
    loops_.power(report);
    out_.put('p', report);
  }
  void camera(const Image& image, TimeUs exposed, std::uint32_t number) override {
    loops_.camera(image, exposed, number);
    moment_.exposed = exposed;
    moment_.number = number;
    moment_.image = image;
    out_.put('i', moment_, *frame_);
  }
  void motion(const MotionInput&, const MotionOutput&) override {}
  void frame(const FrameInput&, const FrameOutput& output) override { frame_ = &output; }
  void hear(const ControlPacket&, TimeUs) override {}
  void hear(const RadioPacket&, TimeUs) override {}
  bool takePacket(RadioPacket&) override { return false; }
  const behaviour::ReportLine* takeLine() override { return nullptr; }

  double playsFrom = 0.0;  // s; 0: never

 private:
  tape::TapeWriter& out_;
  agent::AgentLoops loops_;
  tape::Answer answer_;
  tape::Moment moment_;
  const FrameOutput* frame_ = nullptr;
};

// deg/s of the fastest joint before it plays; below 0: the story could not be played.
double play(const desk::Story& story, const std::string& scripts, tape::TapeWriter& out) {
  const auto config = std::make_unique<agent::AgentConfig>();
  const auto loops = std::make_unique<TapedLoops>(out, *config, scripts);
  const auto object = std::make_unique<agent::Agent>(*loops);
  host::Desk desk;
  desk.messages = static_cast<std::int32_t>(story.seconds / 0.032);
  desk.imageEvery = kImageEvery;
  desk.frame.joints = desk::sprawled();
  host::HostParams params;
  params.printTo = nullptr;
  host::WatchedSystem system(desk, params);
  auto next = story.events.begin();
  host::Network network;
  network.tick = [&](TimeUs now) {
    for (; next != story.events.end() && next->at <= now.seconds(); ++next)
      next->happens(desk, system);
  };
  if (!system.run(host::agentStub(*object), network)) return -1.0;
  return host::fastest(desk, 0.0, loops->playsFrom);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "object-stories: usage: object-stories TAPE PYCODE\n");
    return 2;
  }
  tape::TapeWriter out(argv[1]);
  bool gentle = true;
  for (const desk::Story& story : desk::stories()) {
    const double speed = play(story, argv[2], out);
    std::printf("%s: %.1f s, at most %.1f deg/s before it plays\n", story.name, story.seconds,
                speed);
    gentle = gentle && speed >= 0.0 && speed <= kMaxDegrees;
  }
  if (!out.close()) {
    std::fprintf(stderr, "object-stories: %s: cannot be written\n", argv[1]);
    return 2;
  }
  return gentle ? 0 : 1;
}
