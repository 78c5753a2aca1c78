// SPDX-License-Identifier: Apache-2.0
// A subject as its observer knows it: its name, and the version of the library behind it. 12 bytes
// with the robot's 32-bit pointers.
#pragma once

#include "OPENR/ObjcommTypes.h"

class OSubjectInfo : public SubjectID {
 public:
  OSubjectInfo() = default;
  OSubjectInfo(const SubjectID& id, ObjcommVersion version) : SubjectID(id), version_(version) {}
  const SubjectID& GetSubjectID() const { return *this; }
  ObjcommVersion GetVersion() const { return version_; }

 private:
  ObjcommVersion version_ = objcommVERSION_UNDEF;
};
