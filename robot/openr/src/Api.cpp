// SPDX-License-Identifier: Apache-2.0
// The documented free functions and OObject, handed to the system that is installed.
#include <MCOOP.h>
#include <OPENR/OObject.h>
#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>

#include <cstdarg>
#include <cstdio>
#include <cstring>

#include "robot/openr/System.h"

using kelpie::openr::currentSystem;
using kelpie::openr::GainSettings;

sError GetSystemTime(SystemTime* time) {
  *time = currentSystem().time();
  return sSUCCESS;
}

sError WhoAmI(OID* self) {
  *self = currentSystem().self();
  return sSUCCESS;
}

void OObject::Init(const OSystemEvent& event) {
  WhoAmI(&myOID_);
  currentSystem().reportStatus(DoInit(event));
}
void OObject::Start(const OSystemEvent& event) { currentSystem().reportStatus(DoStart(event)); }
void OObject::Stop(const OSystemEvent& event) { currentSystem().reportStatus(DoStop(event)); }
void OObject::Destroy(const OSystemEvent& event) { currentSystem().reportStatus(DoDestroy(event)); }

OStatus OObject::DoInit(const OSystemEvent&) { return oSUCCESS; }
OStatus OObject::DoStart(const OSystemEvent&) { return oSUCCESS; }
OStatus OObject::DoStop(const OSystemEvent&) { return oSUCCESS; }
OStatus OObject::DoDestroy(const OSystemEvent&) { return oSUCCESS; }

OStatus OObject::RegisterServiceEntry(const OServiceEntry& entry, const char* name) {
  return currentSystem().registerService(entry, name);
}

namespace {
constexpr int kLongestLine = 243;  // letters (openr.md 3.4)

void printLine(int level, const char* format, std::va_list arguments) {
  char line[kLongestLine + 1];
  std::vsnprintf(line, sizeof line, format, arguments);
  currentSystem().print(level, line);
}
}  // namespace

OStatus osysprint(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  printLine(0, format, arguments);
  va_end(arguments);
  return oSUCCESS;
}

OStatus osyslog(OSyslogPriority level, const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  printLine(static_cast<int>(level), format, arguments);
  va_end(arguments);
  return oSUCCESS;
}

namespace OPENR {

OStatus OpenPrimitive(const char* locator, OPrimitiveID* id) {
  if (locator == nullptr || id == nullptr) return oINVALID_ARG;
  return currentSystem().openPrimitive(locator, id);
}
OStatus ClosePrimitive(OPrimitiveID id) { return currentSystem().closePrimitive(id); }

OStatus ControlPrimitive(OPrimitiveID id, OPrimitiveRequest request, void* param,
                         std::size_t paramSize, void*, std::size_t) {
  longword parameter = 0;
  if (paramSize != 0 && (param == nullptr || paramSize != sizeof parameter)) return oINVALID_ARG;
  if (paramSize != 0) std::memcpy(&parameter, param, sizeof parameter);
  return currentSystem().controlPrimitive(id, request, parameter);
}

OStatus NewCommandVectorData(std::size_t count, MemoryRegionID* memID, OCommandVectorData** data) {
  if (count == 0 || memID == nullptr || data == nullptr) return oINVALID_ARG;
  return currentSystem().newCommandVector(count, memID, data);
}
OStatus DeleteCommandVectorData(MemoryRegionID memID) {
  return currentSystem().deleteCommandVector(memID);
}

OStatus EnableJointGain(OPrimitiveID id) { return currentSystem().enableGain(id, true); }
OStatus DisableJointGain(OPrimitiveID id) { return currentSystem().enableGain(id, false); }
OStatus SetJointGain(OPrimitiveID id, word pg, word ig, word dg, word ps, word is, word ds) {
  return currentSystem().setGain(id, {pg, ig, dg, ps, is, ds});
}
OStatus GetJointGain(OPrimitiveID id, word* pg, word* ig, word* dg, word* ps, word* is, word* ds) {
  GainSettings gain{};
  const OStatus status = currentSystem().getGain(id, &gain);
  *pg = gain.p;
  *ig = gain.i;
  *dg = gain.d;
  *ps = gain.pShift;
  *is = gain.iShift;
  *ds = gain.dShift;
  return status;
}

OStatus GetJointValue(OPrimitiveID id, OJointValue* value) {
  return value == nullptr ? oINVALID_ARG : currentSystem().jointValue(id, value);
}
OStatus GetSensorValue(OPrimitiveID id, OSensorValue* value) {
  return value == nullptr ? oINVALID_ARG : currentSystem().sensorValue(id, value);
}

OStatus SetMotorPower(OPower power) { return currentSystem().setMotorPower(power); }
OStatus Shutdown(const OBootCondition& condition) { return currentSystem().shutDown(condition); }

OStatus GetPowerStatus(OPowerStatus* status) {
  return status == nullptr ? oINVALID_ARG : currentSystem().powerStatus(status);
}
OStatus ObservePowerStatus(const OPowerStatus& watched, const OServiceEntry& entry) {
  return entry.IsValid() ? currentSystem().observePower(watched, entry) : oINVALID_ARG;
}
OStatus UnobservePowerStatus(const OServiceEntry& entry) {
  return currentSystem().unobservePower(entry);
}

OStatus GetRobotDesign(char* design) {
  std::strcpy(design, "ERS-7");
  return oSUCCESS;
}

}  // namespace OPENR
