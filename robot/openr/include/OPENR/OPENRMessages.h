// SPDX-License-Identifier: Apache-2.0
// Messages of the system to an object: it was connected to a subject, or taken off it; the
// battery's state changed. The kind of each message is its first word (openr-measured.md 2; numbers
// of the kinds: the SDK's OPENRMessages.h).
#pragma once

#include "OPENR/OPENR.h"
#include "OPENR/OPower.h"

using OMessageType = longword;
constexpr OMessageType omsgCONNECT = 6;
constexpr OMessageType omsgPOWER_STATUS = 1024 + 6;

// Which number stands for which order is not documented; it never leaves the system's own messages.
using OConnectCmd = longword;
constexpr OConnectCmd oconnectcmdCONNECT = 1;
constexpr OConnectCmd oconnectcmdDISCONNECT = 2;

struct OConnectMessage {
  OMessageType msgType = omsgCONNECT;
  OConnectCmd command = oconnectcmdCONNECT;
  OServiceEntry entry;  // the Ready entry of the subject
  char subName[oserviceNAME_MAX + 1] = {};

  OConnectMessage() = default;
  explicit OConnectMessage(OConnectCmd order) : command(order) {}
};

struct OPowerStatusMessage {
  OMessageType msgType = omsgPOWER_STATUS;
  OPowerStatus powerStatus;

  OPowerStatusMessage() = default;
  explicit OPowerStatusMessage(const OPowerStatus& status) : powerStatus(status) {}
};
static_assert(sizeof(OPowerStatusMessage) == 24, "a longword before the status");
