// SPDX-License-Identifier: Apache-2.0
// Ready and notify between subjects and observers: the rules of openr.md 5.2.
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>
#include <gtest/gtest.h>

#include "FakeSystem.h"

namespace kelpie::openr {
namespace {

const ObserverID kFirst = {OID(1), 12};
const ObserverID kSecond = {OID(2), 15};

class SubjectTest : public testing::Test {
 protected:
  ~SubjectTest() override {
    for (auto& one : system_.posted) {
      if (auto* sent = std::get_if<ONotifyMessage>(&one.message))
        sent->regions[0]->RemoveReference();
    }
  }
  void add(const ObserverID& observer) {
    OControlMessage message;
    message.observer = observer;
    subject_.ControlHandler(message, oSUCCESS);
  }
  void ready(const ObserverID& observer, bool asserted) {
    OReadyMessage message;
    message.sender = observer;
    message.isAssert = asserted;
    subject_.ReadyHandler(message);
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
      for (longword i = 0; i < message.count; ++i) {
        values.push_back(*reinterpret_cast<const int*>(message.regions[i]->Base()));
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

TEST_F(SubjectTest, WaitingObserverGetsTheNewestAtItsNextAssert) {
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
  EXPECT_EQ(oreadyDEASSERT, subject_.ReadyStatus(kFirst));
  EXPECT_EQ(oreadyWAITING, subject_.ReadyStatus(kSecond));
}

TEST_F(SubjectTest, AllReadyMeansNoneWaitsAndOneAsserted) {
  add(kFirst);
  add(kSecond);
  EXPECT_FALSE(subject_.IsAllReady());
  ready(kFirst, true);
  EXPECT_TRUE(subject_.IsAllReady());  // the other is deasserted
  ready(kSecond, true);
  subject_.NotifyObserver(kSecond);  // nothing set: nothing sent
  EXPECT_TRUE(subject_.IsAllReady());
  notify(1);
  ready(kFirst, true);
  EXPECT_FALSE(subject_.IsAllReady());
  EXPECT_TRUE(subject_.IsAnyReady());
}

TEST_F(SubjectTest, RemovedObserverGetsNothing) {
  add(kFirst);
  ready(kFirst, true);
  OControlMessage leave;
  leave.observer = kFirst;
  leave.add = false;
  subject_.ControlHandler(leave, oSUCCESS);
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
  std::get<ONotifyMessage>(system_.posted[0].message).regions[0]->RemoveReference();
  EXPECT_EQ(1, region->NumberOfReference());  // may be overwritten
  system_.posted.clear();
  region->RemoveReference();
}

TEST_F(SubjectTest, OverwrittenAndClearedRegionsAreFreeAgain) {
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
  EXPECT_EQ(reinterpret_cast<byte*>(memory), region->Base());
  region->RemoveReference();
  EXPECT_EQ(4U, memory[3]);
}

TEST(ObserverTest, AssertGoesToEverySubjectOrToOne) {
  FakeSystem system;
  const SystemScope scope(system);
  OObserver observer;
  observer.SetNotifyEntry(kFirst);
  const SubjectID subjects[] = {{OID(3), 5}, {OID(4), 6}};
  for (const SubjectID& subject : subjects) {
    OConnectMessage message;
    message.subject = subject;
    observer.ConnectHandler(message, oSUCCESS);
  }
  EXPECT_EQ(oSUCCESS, observer.AssertReady());
  EXPECT_EQ(oSUCCESS, observer.DeassertReady(subjects[1]));
  EXPECT_EQ(oNOT_FOUND, observer.AssertReady(kSecond));
  ASSERT_EQ(3U, system.posted.size());
  EXPECT_TRUE(system.posted[0].to == subjects[0]);
  EXPECT_TRUE(std::get<OReadyMessage>(system.posted[0].message).isAssert);
  EXPECT_TRUE(system.posted[2].to == subjects[1]);
  EXPECT_FALSE(std::get<OReadyMessage>(system.posted[2].message).isAssert);
  EXPECT_TRUE(std::get<OReadyMessage>(system.posted[2].message).sender == kFirst);
}

}  // namespace
}  // namespace kelpie::openr
