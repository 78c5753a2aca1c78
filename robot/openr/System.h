// SPDX-License-Identifier: Apache-2.0
// What the OPEN-R calls of an object end in on the host: message passing, time, primitives. A
// dispatcher (robot/host/HostSystem) implements it.
//
// The documented calls are free functions without a handle, so one pointer to the system behind
// them cannot be avoided. It is kept in System.cpp and nowhere else, per thread, and is set only
// while the dispatcher runs a method of an object.
#pragma once

#include <MCOOP.h>
#include <OPENR/OPENRAPI.h>
#include <OPENR/ObjcommMessages.h>
#include <antEnvMsg.h>

#include <cstddef>
#include <variant>
#include <vector>

namespace kelpie::openr {

// A message of the network's with its answer, byte by byte, aligned for all that may be in it.
struct AntReply {
  std::vector<std::max_align_t> bytes;
};

using Message = std::variant<OControlMessage, OReadyMessage, OConnectMessage, ONotifyMessage,
                             OPowerStatusMessage, AntReply>;

struct GainSettings {
  word p, i, d, pShift, iShift, dShift;
};

class System {
 public:
  virtual ~System() = default;

  // Queues a message. A notification owns one reference to each of its regions.
  virtual void post(const OServiceEntry& to, const Message& message) = 0;
  virtual OStatus registerService(const OServiceEntry& entry, const char* name) = 0;
  virtual void reportStatus(OStatus status) = 0;  // of the life-cycle method that just ran
  virtual OID self() const = 0;                   // the object whose method runs
  virtual SystemTime time() const = 0;
  virtual void print(int level, const char* line) = 0;  // level 0: no level

  virtual OStatus openPrimitive(const char* locator, OPrimitiveID* id) = 0;
  virtual OStatus closePrimitive(OPrimitiveID id) = 0;
  virtual OStatus controlPrimitive(OPrimitiveID id, OPrimitiveRequest request,
                                   longword parameter) = 0;
  virtual OStatus newCommandVector(std::size_t count, MemoryRegionID* memID,
                                   OCommandVectorData** data) = 0;
  virtual OStatus deleteCommandVector(MemoryRegionID memID) = 0;
  virtual OStatus enableGain(OPrimitiveID id, bool enable) = 0;
  virtual OStatus setGain(OPrimitiveID id, const GainSettings& gain) = 0;
  virtual OStatus getGain(OPrimitiveID id, GainSettings* gain) = 0;
  virtual OStatus jointValue(OPrimitiveID id, OJointValue* value) = 0;
  virtual OStatus sensorValue(OPrimitiveID id, OSensorValue* value) = 0;
  virtual OStatus setMotorPower(OPower power) = 0;
  virtual OStatus shutDown(const OBootCondition& condition) = 0;
  virtual OStatus powerStatus(OPowerStatus* status) = 0;
  virtual OStatus observePower(const OPowerStatus& watched, const OServiceEntry& entry) = 0;
  virtual OStatus unobservePower(const OServiceEntry& entry) = 0;

  // The network, of which most systems have none. A message that is sent has msgSize bytes and is
  // to be answered at contInfo.
  virtual antError antCall(antEnvMsg&) { return ANT_FAIL; }
  virtual antError antSend(const antEnvMsg&) { return ANT_FAIL; }
};

// The system behind the calls made now. Ends the program when there is none: an OPEN-R call outside
// a method of an object is a mistake in the program.
System& currentSystem();

// Installs a system for as long as it lives.
class SystemScope {
 public:
  explicit SystemScope(System& system);
  ~SystemScope();
  SystemScope(const SystemScope&) = delete;
  SystemScope& operator=(const SystemScope&) = delete;

 private:
  System* previous_;
};

}  // namespace kelpie::openr
