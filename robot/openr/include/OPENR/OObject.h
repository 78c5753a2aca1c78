// SPDX-License-Identifier: Apache-2.0
// The base of every OPEN-R object: four life-cycle methods that the system calls, each of which
// calls its Do method and reports the status (openr.md 5.1). All objects end DoInit before any
// begins DoStart, and DoStop before any begins DoDestroy.
#pragma once

#include "OPENR/OPENREvent.h"

class OObject {
 public:
  OObject() = default;
  virtual ~OObject() = default;

  void Init(const OSystemEvent& event);
  void Start(const OSystemEvent& event);
  void Stop(const OSystemEvent& event);
  void Destroy(const OSystemEvent& event);

  virtual OStatus DoInit(const OSystemEvent& event);
  virtual OStatus DoStart(const OSystemEvent& event);
  virtual OStatus DoStop(const OSystemEvent& event);
  virtual OStatus DoDestroy(const OSystemEvent& event);

 protected:
  // Makes a service known under "Object.Service.DataType.S" or ".O".
  OStatus RegisterServiceEntry(const OServiceEntry& entry, const char* name);

  OID myOID_;  // known from Init on
};
