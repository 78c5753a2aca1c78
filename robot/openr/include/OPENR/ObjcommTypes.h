// SPDX-License-Identifier: Apache-2.0
// What subjects and observers name each other by (openr.md 5.2, openr-measured.md 2).
#pragma once

#include "OPENR/OPENR.h"

using SubjectID = OServiceEntry;   // the Ready entry of a subject
using ObserverID = OServiceEntry;  // the Notify entry of an observer

// What a message between them orders. The numbers are those of the SDK's ObjcommTypes.h.
using ObjcommCommand = int;
constexpr ObjcommCommand objcommCMD_UNDEF = 0;
constexpr ObjcommCommand objcommCMD_ADDOBSERVER = 1;
constexpr ObjcommCommand objcommCMD_REMOVEOBSERVER = 2;
constexpr ObjcommCommand objcommCMD_ASSERT_READY = 3;
constexpr ObjcommCommand objcommCMD_DEASSERT_READY = 4;

using ObjcommVersion = unsigned int;
constexpr ObjcommVersion objcommVERSION22 = 4;
constexpr ObjcommVersion objcommVERSION_UNDEF = 0xffffffff;

constexpr std::size_t MAX_NUM_DATA = 13;  // most regions in one notification
