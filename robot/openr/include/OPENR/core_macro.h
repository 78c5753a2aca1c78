// SPDX-License-Identifier: Apache-2.0
// What every object does alike in its life-cycle methods (openr.md 5.1). Used inside a class with
// members `OSubject* subject[numOfSubject]` and `OObserver* observer[numOfObserver]`, in a file
// that includes def.h and entry.h. On the robot the delete macro is empty, because objects never
// end.
#pragma once

#include "OPENR/OObserver.h"
#include "OPENR/OSubject.h"

#define NEW_ALL_SUBJECT_AND_OBSERVER              \
  for (auto& one : subject) one = new OSubject(); \
  for (auto& one : observer) one = new OObserver()

#define REGISTER_ALL_ENTRY                                                   \
  for (int i = 0; i < numOfSubject; ++i) {                                   \
    RegisterServiceEntry({myOID_, Control_Entry[i]}, subjectServiceName[i]); \
  }                                                                          \
  for (int i = 0; i < numOfObserver; ++i)                                    \
  RegisterServiceEntry({myOID_, Connect_Entry[i]}, observerServiceName[i])

#define SET_ALL_READY_AND_NOTIFY_ENTRY                   \
  for (int i = 0; i < numOfSubject; ++i) {               \
    subject[i]->SetReadyEntry({myOID_, Ready_Entry[i]}); \
  }                                                      \
  for (int i = 0; i < numOfObserver; ++i) observer[i]->SetNotifyEntry({myOID_, Notify_Entry[i]})

#define ENABLE_ALL_SUBJECT static_cast<void>(0)

#define DISABLE_ALL_SUBJECT \
  for (auto* one : subject) one->ClearBuffer()

#define ASSERT_READY_TO_ALL_OBSERVER \
  for (auto* one : observer) one->AssertReady()

#define DEASSERT_READY_TO_ALL_OBSERVER \
  for (auto* one : observer) one->DeassertReady()

#define DELETE_ALL_SUBJECT_AND_OBSERVER \
  for (auto*& one : subject) {          \
    delete one;                         \
    one = nullptr;                      \
  }                                     \
  for (auto*& one : observer) {         \
    delete one;                         \
    one = nullptr;                      \
  }                                     \
  static_cast<void>(0)
