// SPDX-License-Identifier: Apache-2.0
// That the stand-in is no more permissive than the robot's OPEN-R (openr-measured.md 2): what an
// object may not do there does not compile here either. RobotShape.h has the sizes and offsets.
#include <MCOOP.h>
#include <OPENR/OFbkImage.h>
#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OPENRAPI.h>
#include <OPENR/OSubject.h>
#include <OPENR/OSyslog.h>
#include <OPENR/OUnits.h>
#include <gtest/gtest.h>

#include "FakeSystem.h"
#include "entry.h"

namespace kelpie::openr {
namespace {

template <class Vector, class = void>
constexpr bool kReadsAsConst = false;
template <class Vector>
constexpr bool
    kReadsAsConst<Vector, std::void_t<decltype(std::declval<const Vector&>().GetInfo(0))>> = true;

template <class Vector, class = void>
constexpr bool kIsCountable = false;
template <class Vector>
constexpr bool kIsCountable<Vector, std::void_t<decltype(std::declval<Vector&>().SetNumData(0U))>> =
    true;

TEST(Shape, AVectorOfTheSystemCannotBeReadAsConst) {
  EXPECT_FALSE(kReadsAsConst<OSensorFrameVectorData>);
  EXPECT_FALSE(kReadsAsConst<OCommandVectorData>);
  EXPECT_FALSE(kReadsAsConst<OFbkImageVectorData>);
}

TEST(Shape, OnlyTheSystemTellsHowManyLayersAnImageHas) {
  EXPECT_TRUE(kIsCountable<OSensorFrameVectorData>);
  EXPECT_TRUE(kIsCountable<OCommandVectorData>);
  EXPECT_FALSE(kIsCountable<OFbkImageVectorData>);
}

TEST(Shape, APrimitiveIsSetInAllLayersThatThereAre) {
  struct {
    OFbkImageVectorData image{};
    OFbkImageInfo second{};
  } both;
  both.image.vectorInfo.numData = 1;
  both.image.SetPrimitiveID(7);
  EXPECT_EQ(7U, both.image.info[0].primitiveID);
  EXPECT_EQ(0U, both.second.primitiveID);
}

TEST(Shape, WhatWasNotifiedIsConst) {
  using Data = decltype(std::declval<const ONotifyEvent&>().Data(0));
  EXPECT_TRUE((std::is_same_v<const void*, Data>));
  EXPECT_TRUE((std::is_same_v<const void*, decltype(std::declval<OSystemEvent>().Param())>));
}

TEST(Shape, ValuesWithConstructorsMayNotBeCopiedInto) {
  EXPECT_FALSE(std::is_trivially_default_constructible_v<OJointValue>);
  EXPECT_FALSE(std::is_trivially_copyable_v<OPowerStatus>);
  EXPECT_FALSE(std::is_trivially_copyable_v<OServiceEntry>);
  EXPECT_FALSE(std::is_aggregate_v<OServiceEntry>);
  EXPECT_FALSE((std::is_constructible_v<OSystemEvent, OReason>));
  EXPECT_FALSE((std::is_constructible_v<OID, longword>));
  EXPECT_FALSE((std::is_constructible_v<OFbkImage, const OFbkImageInfo*, byte*, OFbkImageBand>));
  EXPECT_FALSE(std::is_trivially_destructible_v<OFbkImage>);
}

TEST(Shape, ASensorIsNotASwitch) {
  EXPECT_FALSE((std::is_same_v<OSensorValue, OSwitchStatus>));
  EXPECT_FALSE((std::is_same_v<OSensorValue, OLength>));
  EXPECT_FALSE((std::is_same_v<OSensorValue, OAcceleration>));
  EXPECT_TRUE((std::is_same_v<longword, decltype(OSwitchStatus::value)>));
  EXPECT_TRUE((std::is_same_v<longword, OLEDValue>));
  EXPECT_TRUE((std::is_same_v<int, OFbkImageLayer>));
  EXPECT_TRUE((std::is_same_v<slongword, sError>));
}

TEST(Shape, OffsetsInAVectorAreSizes) {
  EXPECT_TRUE((std::is_same_v<std::size_t, decltype(ODataVectorInfo::totalSize)>));
  EXPECT_TRUE((std::is_same_v<std::size_t, decltype(OSensorFrameInfo::dataOffset)>));
  EXPECT_TRUE((std::is_same_v<std::size_t, decltype(OCommandInfo::numFrames)>));
  EXPECT_TRUE((std::is_same_v<std::size_t, decltype(OFbkImageInfo::width)>));
  EXPECT_TRUE((std::is_same_v<void*, decltype(ODataVectorInfo::physAddr)>));
}

TEST(Shape, AllThatASubjectOrObserverDoesHasAStatus) {
  using Subject = OSubject&;
  const OServiceEntry entry;
  EXPECT_TRUE((std::is_same_v<OStatus, decltype(std::declval<Subject>().SetReadyEntry(entry))>));
  EXPECT_TRUE((std::is_same_v<OStatus, decltype(std::declval<Subject>().SetBufferSize(1))>));
  EXPECT_TRUE((std::is_same_v<OStatus, decltype(std::declval<Subject>().ClearBuffer())>));
  EXPECT_TRUE(
      (std::is_same_v<OStatus, decltype(std::declval<OObserver&>().SetNotifyEntry(entry))>));
  EXPECT_TRUE((std::is_same_v<OStatus, decltype(osysprint("x"))>));
  EXPECT_TRUE((std::is_same_v<OStatus, decltype(osyslog(osyslogERROR, "x"))>));
}

TEST(Shape, ObserversAreListedAndNotIndexed) {
  EXPECT_TRUE((std::is_same_v<ObserverConstIterator, decltype(std::declval<OSubject>().begin())>));
  EXPECT_TRUE((std::is_same_v<const OObserverInfo&, ObserverConstIterator::reference>));
  EXPECT_EQ(sizeof(void*), sizeof(OObserverInfo));
}

TEST(Shape, ARegionIsOfLettersAndFromAPool) {
  EXPECT_TRUE((std::is_same_v<char*, decltype(std::declval<RCRegion*>()->Base())>));
  EXPECT_TRUE((std::is_same_v<offset_t, decltype(std::declval<RCRegion*>()->Offset())>));
  EXPECT_FALSE(std::is_destructible_v<RCRegion>);
  auto* region = new RCRegion();
  EXPECT_EQ(0, region->NumberOfReference());
  region->AddReference();
  region->RemoveReference();
}

TEST(Shape, AnEntryIsValidWhenItHasAnObjectAndAMethod) {
  OServiceEntry entry;
  EXPECT_FALSE(entry.IsValid());
  entry.Set(objectOf(1), 5);
  EXPECT_TRUE(entry.IsValid());
  EXPECT_TRUE(entry < OServiceEntry(objectOf(2), 0));
  EXPECT_TRUE(entry != OServiceEntry(objectOf(1), 6));
}

TEST(Shape, ATimeIsInvalidUntilItIsSet) {
  SystemTime time;
  EXPECT_FALSE(time.IsValid());
  time = SystemTime(0, 0);
  EXPECT_TRUE(time.IsValid());
}

// The generator counts them so (openr.md section 1, openr-measured.md 3).
TEST(Shape, EntriesFollowEachOther) {
  EXPECT_EQ(4U, Entry_Control[sbjEffector]);
  EXPECT_EQ(5U, Entry_Ready[sbjEffector]);
  EXPECT_EQ(6U, Entry_Connect[obsSensor]);
  EXPECT_EQ(8U, Entry_Notify[obsSensor]);
  EXPECT_EQ(9U, Entry_Notify[obsFbkImageSensor]);
  const std::size_t services = 2 * numOfSubject + 2 * numOfObserver;
  EXPECT_EQ(numOfBasicEntries + services, Extra_Entry[entryNotifyPower]);
}

}  // namespace
}  // namespace kelpie::openr
