// SPDX-License-Identifier: Apache-2.0
// What every object does alike in its life-cycle methods (openr.md 5.1). Used inside a class with
// members `OSubject* subject[numOfSubject]` and `OObserver* observer[numOfObserver]`. Blocks or
// nothing, as on the robot (openr-measured.md 2): nothing is deleted, because objects never end
// there.
#pragma once

#include "OPENR/OObserver.h"
#include "OPENR/OSubject.h"
#include "entry.h"

#define NEW_ALL_SUBJECT_AND_OBSERVER                  \
  {                                                   \
    for (auto& one : subject) one = new OSubject();   \
    for (auto& one : observer) one = new OObserver(); \
  }

#define REGISTER_ALL_ENTRY                                                               \
  {                                                                                      \
    for (int i = 0; i < numOfSubject; ++i)                                               \
      RegisterServiceEntry(OServiceEntry(myOID_, Entry_Control[i]), subjectService[i]);  \
    for (int i = 0; i < numOfObserver; ++i)                                              \
      RegisterServiceEntry(OServiceEntry(myOID_, Entry_Connect[i]), observerService[i]); \
  }

#define SET_ALL_READY_AND_NOTIFY_ENTRY                                     \
  {                                                                        \
    for (int i = 0; i < numOfSubject; ++i)                                 \
      subject[i]->SetReadyEntry(OServiceEntry(myOID_, Entry_Ready[i]));    \
    for (int i = 0; i < numOfObserver; ++i)                                \
      observer[i]->SetNotifyEntry(OServiceEntry(myOID_, Entry_Notify[i])); \
  }

#define ENABLE_ALL_SUBJECT

#define DISABLE_ALL_SUBJECT                       \
  {                                               \
    for (auto* one : subject) one->ClearBuffer(); \
  }

#define ASSERT_READY_TO_ALL_OBSERVER               \
  {                                                \
    for (auto* one : observer) one->AssertReady(); \
  }

#define DEASSERT_READY_TO_ALL_OBSERVER               \
  {                                                  \
    for (auto* one : observer) one->DeassertReady(); \
  }

#define DELETE_ALL_SUBJECT_AND_OBSERVER
