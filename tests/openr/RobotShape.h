// SPDX-License-Identifier: Apache-2.0
// Sizes and offsets of the stand-in where pointers have 32 bits, as measured with the robot's
// headers (openr.md 3.4, openr-measured.md 2). CrossTest.cpp compiles it for mipsel; on a PC it
// does not.
#pragma once

#include <MCOOP.h>
#include <OPENR/OFbkImage.h>
#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OPENRAPI.h>
#include <OPENR/OSubject.h>
#include <UDPEndpointMsg.h>

#include <cstddef>

static_assert(std::is_same_v<longword, unsigned long> && std::is_same_v<slongword, long>);
static_assert(sizeof(OID) == 4 && sizeof(OServiceEntry) == 8 && sizeof(SystemTime) == 8);
static_assert(sizeof(OSystemEvent) == 12 && sizeof(OControlEvent) == 20);
static_assert(sizeof(OConnectEvent) == 12 && sizeof(OReadyEvent) == 16);
static_assert(sizeof(ONotifyEvent) == 76 && sizeof(OSubjectInfo) == 12);
static_assert(sizeof(OControlMessage) == 156 && sizeof(OConnectMessage) == 144);
static_assert(sizeof(OReadyMessage) == 72 && sizeof(ONotifyMessage) == 224);
static_assert(sizeof(OObject) == 8 && sizeof(RCRegion) == 24 && sizeof(OFbkImage) == 16);
static_assert(sizeof(OObserverInfo) == 4 && sizeof(OPowerStatusMessage) == 24);

static_assert(sizeof(ODataVectorInfo) == 192 && sizeof(OSensorFrameVectorData) == 224);
static_assert(sizeof(OCommandVectorData) == 224 && sizeof(OFbkImageVectorData) == 224);
static_assert(offsetof(ODataVectorInfo, infoOffset) == 20);
static_assert(offsetof(ODataVectorInfo, numData) == 32);
static_assert(offsetof(ODataVectorInfo, optional) == 64);
static_assert(offsetof(OSensorFrameVectorData, info) == 192);
static_assert(sizeof(OSensorFrameInfo) == 32 && offsetof(OSensorFrameInfo, dataOffset) == 20);
static_assert(sizeof(OCommandInfo) == 32 && offsetof(OCommandInfo, dataOffset) == 20);
static_assert(sizeof(OFbkImageInfo) == 32 && offsetof(OFbkImageInfo, dataOffset) == 12);
static_assert(offsetof(OFbkImageInfo, width) == 20 && offsetof(OFbkImageInfo, height) == 24);
static_assert(offsetof(OJointValue, pwmDuty) == 6 && offsetof(OJointValue, refValue) == 8);

static_assert(sizeof(UDPEndpointSendMsg) == 60 && sizeof(UDPEndpointReceiveMsg) == 60);
static_assert(sizeof(antModuleRef) == 8 && sizeof(antSharedBuffer) == 16);
