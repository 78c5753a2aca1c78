// SPDX-License-Identifier: Apache-2.0
// Selector numbers of the agent's entries, as the stub generator counts them: four of the life
// cycle, Control and Ready of each subject, Connect and Notify of each observer.
#pragma once

#include <Types.h>

#include "def.h"

constexpr Selector Control_Entry[numOfSubject] = {4};
constexpr Selector Ready_Entry[numOfSubject] = {5};
constexpr Selector Connect_Entry[numOfObserver] = {6, 7};
constexpr Selector Notify_Entry[numOfObserver] = {8, 9};
