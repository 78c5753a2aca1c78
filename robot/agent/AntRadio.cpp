// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/AntRadio.h"

#include <algorithm>

#include "entry.h"

namespace kelpie::agent {
namespace {

template <class Packet>
void take(const Heard& heard, Packet& packet) {
  packet.bytes.resize(heard.size);
  std::copy_n(heard.bytes, heard.size, packet.bytes.begin());
}

AntOwner ownerOf(const OID& object, int heard, int sent) {
  char name[] = "IPStack";  // not const in the documented call
  return {object, antStackRef(name), Extra_Entry[heard], Extra_Entry[sent]};
}

}  // namespace

AntRadio::AntRadio(const RadioPorts& ports)
    : ports_(ports),
      control_({ports.control, kMaxControlBytes}),
      team_({ports.team, kMaxPacketBytes}) {}

void AntRadio::begin(const OID& object, TimeUs now) {
  if (!present()) return;
  control_.begin(ownerOf(object, entryNotifyControl, entryReadyTeam), now);
  team_.begin(ownerOf(object, entryNotifyTeam, entryReadyTeam), now);
}

void AntRadio::tick(TimeUs now) {
  if (!present()) return;
  control_.tick(now);
  team_.tick(now);
}

void AntRadio::send(Loops& loops) {
  if (!present() || !loops.takePacket(said_)) return;
  (void)team_.broadcast(said_.bytes.begin(), said_.bytes.size());
}

void AntRadio::controlHeard(void* answer, TimeUs now, Loops& loops) {
  const Heard heard = control_.heard(answer);
  if (heard.size == 0) return;
  take(heard, controlPacket_);
  loops.hear(controlPacket_, now);
  control_.listen();
}

void AntRadio::teamHeard(void* answer, TimeUs now, Loops& loops) {
  const Heard heard = team_.heard(answer);
  if (heard.size == 0) return;
  take(heard, heard_);
  loops.hear(heard_, now);
  team_.listen();
}

}  // namespace kelpie::agent
