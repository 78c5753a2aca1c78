// SPDX-License-Identifier: Apache-2.0
// Selector numbers of the agent's entries, as the SDK's stub generator counts and names them
// (openr.md section 1, openr-measured.md 1): four of the life cycle, Control and Ready of each
// subject, Connect and Notify of each observer, then the Extra entries of stub.cfg.
#pragma once

#include <Types.h>

#include "def.h"

constexpr int numOfBasicEntries = 4;
constexpr int numOfHook = 0;  // and so no Entry_Hook

constexpr Selector Entry_Control[numOfSubject] = {4};
constexpr Selector Entry_Ready[numOfSubject] = {5};
constexpr Selector Entry_Connect[numOfObserver] = {6, 7};
constexpr Selector Entry_Notify[numOfObserver] = {8, 9};

// Places in Extra_Entry.
constexpr int entryNotifyPower = 0;
constexpr int entryNotifyControl = 1;
constexpr int entryNotifyTeam = 2;
constexpr int entryReadyTeam = 3;

constexpr Selector Extra_Entry[] = {10, 11, 12, 13};
