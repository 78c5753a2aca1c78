// SPDX-License-Identifier: Apache-2.0
// Channels of the camera's colour detection: each is named by its bit (openr-measured.md 2).
#pragma once

#include "Types.h"

using OCdtChannel = longword;
constexpr OCdtChannel ocdtCHANNEL_UNDEF = 0x00;
constexpr OCdtChannel ocdtCHANNEL0 = 0x01;
constexpr OCdtChannel ocdtCHANNEL1 = 0x02;
constexpr OCdtChannel ocdtCHANNEL2 = 0x04;
constexpr OCdtChannel ocdtCHANNEL3 = 0x08;
constexpr OCdtChannel ocdtCHANNEL4 = 0x10;
constexpr OCdtChannel ocdtCHANNEL5 = 0x20;
constexpr OCdtChannel ocdtCHANNEL6 = 0x40;
constexpr OCdtChannel ocdtCHANNEL7 = 0x80;
