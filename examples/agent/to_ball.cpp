// SPDX-License-Identifier: Apache-2.0
// An agent for Kelpie's world with nothing but the C++ library and sockets: what to_ball.py beside
// it does, in C++, without anything of Kelpie's. README.md has the protocol.
//
//     c++ -std=c++17 -O2 examples/agent/to_ball.cpp -o out/to_ball
//     kelpie play --red-agent out/to_ball
#include <sys/socket.h>
#include <sys/un.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace {

using Bytes = std::vector<unsigned char>;
enum Kind : std::uint32_t { hello, step, image, reply, goodbye };
constexpr std::size_t kWidth = 208, kPlane = kWidth * 160;
constexpr double kPeriod = 48.0, kLift = 2.0;  // of a double step: ticks of 8 ms, cm
constexpr double kLean = 0.18;                 // the body's nose is so far down, in radians
constexpr std::uint32_t kAllJoints = (1U << 18) - 1U;

// Its first joint, the place of its shoulder (cm ahead of the body's middle, to the left), where
// its foot stands from there (cm ahead, out, below), its lower leg (cm), its share of the double
// step.
struct Leg {
  std::size_t joint;
  double x, y, ahead, out, below, lower, share;
};
constexpr Leg kLegs[] = {{4, 6.5, 6.7, 3.8, 2.8, 9.7, 7.7, 0.0},
                         {7, -6.5, 6.7, 2.1, 3.4, 12.4, 8.3, 0.5},
                         {10, 6.5, -6.7, 3.8, 2.8, 9.7, 7.7, 0.5},
                         {13, -6.5, -6.7, 2.1, 3.4, 12.4, 8.3, 0.0}};

// A little-endian number of this machine's own type, as every x86 and ARM has them.
template <class T>
T get(const Bytes& bytes, std::size_t at) {
  T value;
  std::memcpy(&value, &bytes.at(at), sizeof value);
  return value;
}
template <class T>
void put(T value, Bytes& bytes) {
  const auto* first = reinterpret_cast<const unsigned char*>(&value);
  bytes.insert(bytes.end(), first, first + sizeof value);
}

Bytes receive(int world, std::size_t size) {
  Bytes bytes(size);
  if (size > 0 && recv(world, bytes.data(), size, MSG_WAITALL) != static_cast<ssize_t>(size))
    std::exit(0);  // the world is gone, so the match is over
  return bytes;
}

std::uint32_t receiveMessage(int world, Bytes& body) {
  const Bytes header = receive(world, 12);
  body = receive(world, get<std::uint32_t>(header, 8));
  return get<std::uint32_t>(header, 4);
}

void send(int world, Kind kind, const Bytes& body) {
  Bytes bytes;
  for (const std::uint32_t word :
       {0x4b4c5031U, static_cast<std::uint32_t>(kind), static_cast<std::uint32_t>(body.size())})
    put(word, bytes);
  bytes.insert(bytes.end(), body.begin(), body.end());
  ::send(world, bytes.data(), bytes.size(), MSG_NOSIGNAL);
}

struct Walker {
  int tick = 0;
  double step = 0.0, turn = 0.4;  // cm and radians that the body goes in a half step
  double neck = 0.0;              // degrees
  int unseen = 0;                 // images without a ball

  // Goes towards the middle of what is orange; where it was seen last, it went out of sight.
  void see(const Bytes& picture) {
    std::vector<std::size_t> columns, rows;
    for (std::size_t i = 0; i < kPlane; i += 3) {
      if (picture[kPlane + i] <= 160 || picture[2 * kPlane + i] >= 100) continue;
      columns.push_back(i % kWidth);
      rows.push_back(i / kWidth);
    }
    unseen = columns.size() < 4 ? unseen + 1 : 0;
    if (unseen > 10) {
      step = neck = 0.0;
      turn = turn > 0.0 ? 0.4 : -0.4;
    }
    if (unseen > 0) return;
    std::sort(columns.begin(), columns.end());
    const double left = 57.0 * (0.5 - static_cast<double>(columns[columns.size() / 2]) / kWidth);
    neck = std::clamp(neck - 0.1 * (static_cast<double>(rows[rows.size() / 2]) - 80.0), -50.0, 0.0);
    turn = std::clamp(0.02 * left, -0.4, 0.4);
    step = std::fabs(left) < 15.0 ? 5.0 : 2.0;
  }

  // In the robot's signs a hind leg is a front leg's mirror image: `ahead` is backward then.
  static void reach(double ahead, double out, double below, double lower, double* radians) {
    const double upper = std::hypot(6.95, 0.9), bend = std::atan2(0.9, 6.95);
    radians[1] = std::atan2(out, below);
    below = std::hypot(below, out);
    const double cosine =
        (ahead * ahead + below * below - upper * upper - lower * lower) / (2.0 * upper * lower);
    const double knee = std::acos(std::clamp(cosine, -1.0, 1.0));
    radians[0] = std::atan2(ahead, below) - bend -
                 std::atan2(lower * std::sin(knee), upper + lower * std::cos(knee));
    radians[2] = knee + bend;
  }

  // Radians in the order of the joints.
  std::array<double, 18> nextTargets() {
    constexpr double kPi = 3.14159265358979;
    std::array<double, 18> targets{};
    targets[0] = neck * kPi / 180.0;
    targets[3] = -0.0524;  // mouth
    targets[16] = 0.5;     // tail
    ++tick;
    for (const Leg& leg : kLegs) {
      const double phase = std::fmod(tick / kPeriod + leg.share, 1.0);
      const bool stands = phase < 0.5;
      const double way = stands ? 0.5 - 2.0 * phase : 2.0 * phase - 1.5;
      const double lift = stands ? 0.0 : kLift * std::sin(2.0 * kPi * (phase - 0.5));
      const double forward = way * (step - turn * leg.y);
      const double left = way * turn * leg.x;
      reach((leg.ahead + forward) * (leg.x > 0.0 ? 1.0 : -1.0),
            leg.out + left * (leg.y > 0.0 ? 1.0 : -1.0), leg.below - lift - kLean * forward,
            leg.lower, &targets[leg.joint]);
    }
    return targets;
  }
};

// Motors on, every joint held at its usual gain, so many vectors of four ticks, no radio.
Bytes replyOf(Walker& walker, std::uint32_t vectors) {
  Bytes body;
  put(std::uint8_t{1}, body);
  put(kAllJoints, body);
  put(1.0, body);
  put(vectors, body);
  for (; vectors > 0; --vectors) {
    put(std::uint32_t{4}, body);
    put(kAllJoints, body);
    for (int tick = 0; tick < 4; ++tick)
      for (const double target : walker.nextTargets())
        put(static_cast<std::int32_t>(std::lround(1e6 * target)), body);
    body.resize(body.size() + 4 * (12 * 18 + 2));  // ticks that are not played, lights, ears
  }
  put(std::uint32_t{0}, body);
  return body;
}

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr ? value : "";
}

}  // namespace

int main() {
  const int world = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  environment("KELPIE_SOCKET").copy(address.sun_path, sizeof address.sun_path - 1);
  if (connect(world, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) return 1;
  const bool blue = environment("KELPIE_TEAM") == "blue";
  send(world, hello,
       {static_cast<unsigned char>(blue),
        static_cast<unsigned char>(std::atoi(environment("KELPIE_PLAYER").c_str()))});
  Walker walker;
  Bytes body, picture;
  std::uint32_t underWay = 0;  // vectors; one is played while the next waits
  while (receiveMessage(world, body) != goodbye) {
    underWay -= get<std::uint32_t>(body, 829);
    if (body.at(833) != 0) {
      receiveMessage(world, picture);
      walker.see(picture);
    }
    const std::uint32_t more = body.at(8) != 0 && underWay < 2 ? 2 - underWay : 0;
    underWay += more;
    send(world, reply, replyOf(walker, more));
  }
  return 0;
}
