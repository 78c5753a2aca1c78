// SPDX-License-Identifier: Apache-2.0
// An observer as its subject lists it: a pointer to what the subject keeps of it.
#pragma once

#include "OPENR/ObjcommTypes.h"

class OObserverInfo {
 public:
  OObserverInfo() = default;
  const ObserverID& GetObserverID() const;

 private:
  friend class OSubject;
  struct Kept;  // in OSubject.cpp
  explicit OObserverInfo(Kept* kept) : kept_(kept) {}

  Kept* kept_ = nullptr;
};
