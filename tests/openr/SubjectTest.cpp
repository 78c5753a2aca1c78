// SPDX-License-Identifier: Apache-2.0
// Ready and notify between subjects and observers: the rules of openr.md 5.2.
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>
#include <gtest/gtest.h>

#include "FakeSystem.h"

namespace kelpie::openr {
namespace {

const ObserverID kFirst = {objectOf(1), 12};
const ObserverID kSecond = {objectOf(2), 15};

class SubjectTest : public testing::Test {
 protected:
  ~SubjectTest() override {
    for (auto& one : system_.posted) {
      if (auto* sent = std::get_if<ONotifyMessage>(&one.message))
        sent->data[0].srcRCR->RemoveReference();
    }
  }
  void add(const ObserverID& observer) {
    OControlMessage message;
    message.command = objcommCMD_ADDOBSERVER;
    message.observerID = observer;
    EXPECT_EQ(oSUCCESS, subject_.ControlHandler(message));
  }
  void ready(const ObserverID& observer, bool asserted) {
    OReadyMessage message;
    message.observerID = observer;
    message.command = asserted ? objcommCMD_ASSERT_READY : objcommCMD_DEASSERT_READY;
    EXPECT_EQ(oSUCCESS, subject_.ReadyHandler(message));
  }
  void notify(int value) {
    subject_.SetData(&value, sizeof value);
    subject_.NotifyObservers();
  }
  // The values sent so far.
  std::vector<int> sent() const {
    std::vector<int> values;
    for (const auto& one : system_.posted) {
      const auto& message = std::get<ONotifyMessage>(one.message);
      for (int i = 0; i < message.NumberOfData(); ++i) {
        values.push_back(*reinterpret_cast<const int*>(message.data[i].srcRCR->Base()));
      }
    }
    return values;
  }

  FakeSystem system_;
  SystemScope scope_{system_};
  OSubject subject_;
};

TEST_F(SubjectTest, AssertedObserverGetsDataAtOnce) {
  add(kFirst);
  ready(kFirst, true);
  notify(5);
  EXPECT_EQ(std::vector<int>{5}, sent());
  EXPECT_TRUE(system_.posted[0].to == kFirst);
}

// Tells the values from 1 to `last`.
std::vector<int> upTo(int last, int first = 1) {
  std::vector<int> values;
  for (int value = first; value <= last; ++value) values.push_back(value);
  return values;
}

TEST_F(SubjectTest, WhatANewObserverIsNotifiedOfIsKeptUntilItsFirstAssert) {
  add(kFirst);
  EXPECT_EQ(0, subject_.ReadyStatus(kFirst));
  notify(1);
  notify(2);
  EXPECT_TRUE(sent().empty());
  ready(kFirst, true);
  ready(kFirst, true);
  EXPECT_EQ(upTo(2), sent());
}

TEST_F(SubjectTest, AQueueHolds14WhenNothingElseWasAskedFor) {
  EXPECT_EQ(0U, subject_.GetBufferSize());
  add(kFirst);
  for (const int value : upTo(20)) notify(value);
  EXPECT_EQ(14U, subject_.RemainBuffer(kFirst));
  for (int i = 0; i < 20; ++i) ready(kFirst, true);
  EXPECT_EQ(upTo(20, 7), sent());  // the oldest were overwritten
}

TEST_F(SubjectTest, ABufferSizeCountsForObserversThatComeLater) {
  add(kFirst);
  EXPECT_EQ(oSUCCESS, subject_.SetBufferSize(2));
  add(kSecond);
  for (const int value : upTo(5)) notify(value);
  EXPECT_EQ(5U, subject_.RemainBuffer(kFirst));
  EXPECT_EQ(2U, subject_.RemainBuffer(kSecond));
}

TEST_F(SubjectTest, WaitingObserverGetsTheNewestAtItsNextAssert) {
  subject_.SetBufferSize(1);
  add(kFirst);
  ready(kFirst, true);
  for (const int value : {1, 2, 3}) notify(value);
  EXPECT_EQ(std::vector<int>{1}, sent());
  ready(kFirst, true);
  EXPECT_EQ((std::vector<int>{1, 3}), sent());  // 2 was overwritten
}

TEST_F(SubjectTest, LongerBufferKeepsTheOrder) {
  subject_.SetBufferSize(2);
  add(kFirst);
  ready(kFirst, true);
  for (const int value : {1, 2, 3, 4}) notify(value);
  EXPECT_EQ(2U, subject_.RemainBuffer());
  for (int i = 0; i < 3; ++i) ready(kFirst, true);
  EXPECT_EQ((std::vector<int>{1, 3, 4}), sent());
}

TEST_F(SubjectTest, DeassertedObserverLosesTheData) {
  add(kFirst);
  ready(kFirst, false);
  notify(1);
  ready(kFirst, true);
  notify(2);
  notify(3);
  ready(kFirst, false);
  ready(kFirst, true);
  EXPECT_EQ(std::vector<int>{2}, sent());
}

TEST_F(SubjectTest, TwoSetsAndOneNotifyFollowEachOther) {
  add(kFirst);
  ready(kFirst, true);
  int value = 1;
  subject_.SetData(&value, sizeof value);
  notify(2);
  ready(kFirst, true);
  EXPECT_EQ((std::vector<int>{1, 2}), sent());
}

TEST_F(SubjectTest, NothingIsSentBeforeNotify) {
  add(kFirst);
  ready(kFirst, true);
  const int value = 1;
  subject_.SetData(&value, sizeof value);
  EXPECT_TRUE(system_.posted.empty());
}

TEST_F(SubjectTest, ObserversAreServedIndependently) {
  add(kFirst);
  add(kSecond);
  ready(kSecond, true);
  notify(9);
  ASSERT_EQ(1U, system_.posted.size());
  EXPECT_TRUE(system_.posted[0].to == kSecond);
  EXPECT_EQ(1U, subject_.RemainBuffer(kFirst));
  EXPECT_EQ(0, subject_.ReadyStatus(kSecond));
  ready(kFirst, false);
  EXPECT_EQ(-1, subject_.ReadyStatus(kFirst));
}

TEST_F(SubjectTest, AllReadyMeansNoneWaitsAndOneAsserted) {
  add(kFirst);
  add(kSecond);
  EXPECT_FALSE(subject_.IsAllReady());
  ready(kFirst, true);
  EXPECT_FALSE(subject_.IsAllReady());  // the other has not asserted yet
  EXPECT_TRUE(subject_.IsReady()) << "one is enough";
  ready(kSecond, false);
  EXPECT_TRUE(subject_.IsAllReady());
  ready(kSecond, true);
  subject_.NotifyObserver(kSecond);  // nothing set: nothing sent
  EXPECT_TRUE(subject_.IsAllReady());
  notify(1);
  ready(kFirst, true);
  EXPECT_FALSE(subject_.IsAllReady());
  EXPECT_TRUE(subject_.IsAnyReady());
  EXPECT_TRUE(subject_.IsReady(kFirst));
  EXPECT_FALSE(subject_.IsReady(kSecond));
}

TEST_F(SubjectTest, RemovedObserverGetsNothing) {
  add(kFirst);
  ready(kFirst, true);
  OControlMessage leave;
  leave.observerID = kFirst;
  leave.command = objcommCMD_REMOVEOBSERVER;
  EXPECT_EQ(oSUCCESS, subject_.ControlHandler(leave));
  EXPECT_EQ(oNOT_FOUND, subject_.ControlHandler(leave));
  notify(1);
  EXPECT_EQ(0, subject_.NumberOfObservers());
  EXPECT_TRUE(system_.posted.empty());
}

TEST_F(SubjectTest, RegionIsReferencedWhileAnyoneNeedsIt) {
  add(kFirst);
  ready(kFirst, true);
  auto* region = new RCRegion(4);
  subject_.SetData(region);
  EXPECT_EQ(2, region->NumberOfReference());
  subject_.NotifyObservers();
  EXPECT_EQ(2, region->NumberOfReference());  // the message holds it
  std::get<ONotifyMessage>(system_.posted[0].message).data[0].srcRCR->RemoveReference();
  EXPECT_EQ(1, region->NumberOfReference());  // may be overwritten
  system_.posted.clear();
  region->RemoveReference();
}

TEST_F(SubjectTest, OverwrittenAndClearedRegionsAreFreeAgain) {
  subject_.SetBufferSize(1);
  add(kFirst);
  ready(kFirst, true);
  notify(0);
  auto* older = new RCRegion(4);
  auto* newer = new RCRegion(4);
  for (RCRegion* region : {older, newer}) {
    subject_.SetData(region);
    subject_.NotifyObservers();
  }
  EXPECT_EQ(1, older->NumberOfReference());
  EXPECT_EQ(2, newer->NumberOfReference());
  subject_.ClearBuffer();
  EXPECT_EQ(1, newer->NumberOfReference());
  older->RemoveReference();
  newer->RemoveReference();
}

TEST(RegionTest, WrappedMemoryStaysTheOwners) {
  longword memory[4] = {1, 2, 3, 4};
  auto* region = new RCRegion(9, 16, memory, sizeof memory);
  EXPECT_EQ(9U, region->MemID());
  EXPECT_EQ(16U, region->Offset());
  EXPECT_EQ(sizeof memory, region->Size());
  EXPECT_EQ(reinterpret_cast<char*>(memory), region->Base());
  EXPECT_EQ(RCRegion::REFERENCE_V20, region->GetType());
  region->RemoveReference();
  EXPECT_EQ(4U, memory[3]);
}

TEST(ObserverTest, AssertGoesToEverySubjectOrToOne) {
  FakeSystem system;
  const SystemScope scope(system);
  OObserver observer;
  observer.SetNotifyEntry(kFirst);
  const SubjectID subjects[] = {{objectOf(3), 5}, {objectOf(4), 6}};
  for (const SubjectID& subject : subjects) {
    OConnectMessage message;
    message.entry = subject;
    EXPECT_EQ(oSUCCESS, observer.ConnectHandler(message));
  }
  EXPECT_EQ(oSUCCESS, observer.AssertReady());
  EXPECT_EQ(oSUCCESS, observer.DeassertReady(subjects[1]));
  EXPECT_EQ(oNOT_FOUND, observer.AssertReady(kSecond));
  ASSERT_EQ(3U, system.posted.size());
  EXPECT_TRUE(system.posted[0].to == subjects[0]);
  const auto said = [&](std::size_t i) {
    return std::get<OReadyMessage>(system.posted[i].message);
  };
  EXPECT_EQ(objcommCMD_ASSERT_READY, said(0).command);
  EXPECT_TRUE(system.posted[2].to == subjects[1]);
  EXPECT_EQ(objcommCMD_DEASSERT_READY, said(2).command);
  EXPECT_TRUE(said(2).observerID == kFirst);
}

TEST(ObserverTest, TheHandlerFillsTheEventThatTheMethodGets) {
  OObserver observer;
  const SubjectID subject = {objectOf(3), 5};
  ONotifyMessage message;
  message.subjectID = subject;
  message.numOfNotify = 1;
  auto* region = new RCRegion(4);
  EXPECT_EQ(oSUCCESS, message.Write(region));
  ONotifyEvent event;
  EXPECT_EQ(oNOT_FOUND, observer.NotifyHandler(message, &event)) << "not connected";
  OConnectMessage connect(oconnectcmdCONNECT);
  connect.entry = subject;
  observer.ConnectHandler(connect);
  EXPECT_EQ(oSUCCESS, observer.NotifyHandler(message, &event));
  EXPECT_TRUE(event.SenderID() == subject);
  EXPECT_EQ(1, event.NumOfData());
  EXPECT_EQ(region, event.RCData(0));
  EXPECT_EQ(region->Base(), event.Data(0));
  region->RemoveReference();
}

TEST(MessageTest, ANotificationTakesThirteenRegions) {
  ONotifyMessage message;
  auto* region = new RCRegion(4);
  for (int i = 0; i < 13; ++i) EXPECT_EQ(oSUCCESS, message.Write(region));
  EXPECT_EQ(oFULL_OF_QUEUE, message.Write(region));
  EXPECT_EQ(13, message.NumberOfData());
  region->RemoveReference();
}

}  // namespace
}  // namespace kelpie::openr
