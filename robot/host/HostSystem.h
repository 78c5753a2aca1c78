// SPDX-License-Identifier: Apache-2.0
// Stands in for the robot's system software: runs one OPEN-R object through its life cycle,
// connects its services with those of the robot, and delivers messages one at a time, each to its
// end, in the order in which they were sent. Fails when the object refuses to start or the source
// breaks.
#pragma once

#include <OPENR/OObject.h>

#include <cstdio>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "robot/core/Random.h"
#include "robot/host/Source.h"
#include "robot/host/primitives/RobotPrimitives.h"
#include "robot/host/primitives/VirtualRobotComm.h"
#include "robot/openr/ObjectStub.h"

namespace kelpie::host {

struct HostParams {
  double dropRate = 0.0;  // share of images that are lost on their way, 0..1
  std::uint64_t seed = 1;
  std::uint64_t sensorOrder = 0;  // seed of the order of sensors in their vector; 0: by the tables
  bool highPassRows = false;      // images with three high-pass rows per line, as type 24
  std::FILE* printTo = stderr;    // what the object prints; nullptr: nowhere
};

// What comes and goes by the network, not through OPEN-R's sensors and effectors; each may be
// empty.
struct Network {
  std::function<void(TimeUs now)> tick;  // of each step, ahead of its sensors and image
  std::function<void(const ControlPacket&, TimeUs now)> control;  // so, if one has come
  std::function<void(const RadioPacket&, TimeUs now)> heard;      // so
  std::function<bool(RadioPacket&)> sends;  // after each step: whether there is a packet
};

struct RunSummary {
  std::uint32_t sensorMessages = 0;
  std::uint32_t images = 0;         // delivered
  std::uint32_t droppedImages = 0;  // by dropRate
  TimeUs end;                       // time of the last event
};

class HostSystem : public RobotPrimitives {
 public:
  HostSystem(Source& source, const HostParams& params);
  ~HostSystem() override;
  HostSystem(const HostSystem&) = delete;
  HostSystem& operator=(const HostSystem&) = delete;

  // From DoInit to DoDestroy, which come with the end of the source or with OPENR::Shutdown; once
  // per HostSystem.
  Expected<RunSummary> run(const openr::ObjectStub& object, const Network& network);

  void post(const OServiceEntry& to, const openr::Message& message) override;
  OStatus registerService(const OServiceEntry& entry, const char* name) override;
  void reportStatus(OStatus status) override { status_ = status; }
  OID self() const override { return running_; }
  SystemTime time() const override;
  void print(int level, const char* line) override;

 private:
  struct Envelope {
    OServiceEntry to;
    openr::Message message;
  };
  struct Service {
    OServiceEntry entry;
    std::string name;
  };
  using LifeCycle = void (OObject::*)(const OSystemEvent&);

  // An object's name is its address.
  OID oidOf(std::size_t place) const { return OID(objects_[place].object); }

  Status handle(const WorldEvent& event, const openr::ObjectStub& object, const Network& network);
  Status boot(const openr::ObjectStub& object);
  Status stopObjects();
  Status lifeCycle(LifeCycle method, OReason reason, const char* name);
  void connectServices();
  void connect(const Service& subject, const Service& observer);
  const openr::ObjectStub* stubOf(OID oid) const;
  void drain();
  void deliver(Envelope& envelope);
  Status deliver(const WorldEvent& event);
  void deliverImage(const Image& image);

  Source& source_;
  HostParams params_;
  Random random_;
  VirtualRobotComm comm_;
  std::vector<openr::ObjectStub> objects_;  // the robot first; empty until the boot
  std::vector<Service> services_;
  std::deque<Envelope> queue_;
  OID running_;
  OStatus status_ = oSUCCESS;
  TimeUs time_;
  RunSummary summary_;
};

}  // namespace kelpie::host
