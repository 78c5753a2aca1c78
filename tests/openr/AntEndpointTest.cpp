// SPDX-License-Identifier: Apache-2.0
// One endpoint against a network that refuses, is late or silent, and goes away.
#include <gtest/gtest.h>

#include "FakeSystem.h"
#include "robot/agent/AntEndpoint.h"
#include "tests/host/FakeAnt.h"

namespace kelpie::agent {
namespace {

constexpr Port kPort = 3838;
constexpr Selector kHeardEntry = 11;
constexpr Selector kSentEntry = 13;
using host::Bytes;

class AntSystem : public openr::FakeSystem {
 public:
  antError antCall(antEnvMsg& message) override { return ant.call(message); }
  antError antSend(const antEnvMsg& message) override { return ant.send(message); }
  host::FakeAnt ant;
};

class AntEndpointTest : public testing::Test {
 protected:
  // Whatever happens, nothing waits for an answer after the start: the joints would wait with it.
  void TearDown() override { EXPECT_EQ(0, ant().lateCalls); }

  void begin(double seconds = 1.0) {
    char name[] = "IPStack";
    endpoint_.begin({openr::objectOf(1), antStackRef(name), kHeardEntry, kSentEntry},
                    TimeUs::fromSeconds(seconds));
    ant().started = true;
  }
  // The first opening failed, which was reported, so that from 1 s on all is asked by messages.
  void beginInVain() {
    ant().callsServed = 0;
    begin(-1.5);
    EXPECT_EQ(1, ant().calls);
    EXPECT_EQ(1U, system_.lines.size());
  }

  // Only what the endpoint does by itself; the answers wait.
  void tick(double seconds) { endpoint_.tick(TimeUs::fromSeconds(seconds)); }
  // And all that the network answers to it at once.
  void at(double seconds) {
    tick(seconds);
    takeAll();
  }
  // The next answer of the network goes to the endpoint; what it heard is returned.
  Bytes take() {
    if (ant().answers.empty()) {
      ADD_FAILURE() << "no answer";
      return {};
    }
    host::FakeAnt::Answer answer = ant().answers.front();
    ant().answers.pop_front();
    EXPECT_TRUE(answer.to.oid == openr::objectOf(1));
    if (answer.to.selector == kSentEntry) {
      endpoint_.sent(answer.reply.bytes.data());
      return {};
    }
    const Heard heard = endpoint_.heard(answer.reply.bytes.data());
    Bytes bytes(heard.bytes, heard.bytes + heard.size);
    if (heard.size > 0) endpoint_.listen();
    return bytes;
  }
  void takeAll() {
    while (!ant().answers.empty()) take();
  }
  // A silent network answers what it was asked for last.
  void answer() {
    EXPECT_EQ(1, ant().answerRequests());
    takeAll();
  }
  bool broadcast(const Bytes& bytes) { return endpoint_.broadcast(bytes.data(), bytes.size()); }
  host::FakeAnt& ant() { return system_.ant; }

  AntSystem system_;
  openr::SystemScope scope_{system_};
  AntEndpoint endpoint_{{kPort, 64}};
};

TEST_F(AntEndpointTest, IsOpenWhenItHasBegunWithoutAnAnswerToAMessage) {
  begin();
  EXPECT_TRUE(endpoint_.open());
  EXPECT_EQ(4, ant().calls) << "memory twice, an endpoint, a port";
  EXPECT_EQ(1U, ant().waiting()) << "the first Receive";
  EXPECT_TRUE(ant().answers.empty());
  EXPECT_TRUE(system_.lines.empty());
  EXPECT_TRUE(broadcast({1}));
}

TEST_F(AntEndpointTest, BegunAgainWhileItIsOpenItStaysAsItIs) {
  begin();
  begin(2.0);
  EXPECT_TRUE(endpoint_.open());
  EXPECT_EQ(1, ant().opened);
  EXPECT_TRUE(ant().comes(kPort, {1}));
  EXPECT_EQ(Bytes{1}, take());
}

TEST_F(AntEndpointTest, HearsDatagramAfterDatagram) {
  begin();
  ASSERT_TRUE(endpoint_.open());
  for (std::uint8_t i = 1; i < 5; ++i) {
    ASSERT_TRUE(ant().comes(kPort, {i, 7}));
    EXPECT_EQ((Bytes{i, 7}), take());
  }
  EXPECT_FALSE(ant().comes(kPort + 1, {9}));
}

TEST_F(AntEndpointTest, BroadcastsToItsPortOneAtATime) {
  begin();
  EXPECT_TRUE(broadcast({1, 2, 3}));
  EXPECT_FALSE(broadcast({4})) << "the first is under way";
  EXPECT_EQ(1, ant().answerSends());
  EXPECT_EQ(kPort, ant().lastPort);
  take();
  EXPECT_TRUE(broadcast({5}));
  ant().answerSends();
  EXPECT_EQ((std::vector<Bytes>{{1, 2, 3}, {5}}), ant().broadcasts);
}

TEST_F(AntEndpointTest, WhatIsTooLongIsNotSent) {
  begin();
  EXPECT_FALSE(broadcast(Bytes(65)));
  EXPECT_TRUE(broadcast(Bytes(64)));
}

TEST_F(AntEndpointTest, ARefusalIsReportedOnceAndTriedAgainAfterTwoSeconds) {
  bool* const refusals[] = {&ant().refusesMessages, &ant().refusesMemory, &ant().refusesEndpoints,
                            &ant().refusesPorts};
  for (bool* refusal : refusals) *refusal = true;
  begin();
  EXPECT_EQ(1U, system_.lines.size());
  double now = 3.1;
  for (bool* refusal : refusals) {
    for (int i = 0; i < 3; ++i, now += 2.1) at(now);
    EXPECT_FALSE(endpoint_.open());
    *refusal = false;
  }
  EXPECT_EQ(1U, system_.lines.size());
  at(now - 1.0);
  EXPECT_FALSE(endpoint_.open()) << "not before its time";
  at(now);
  EXPECT_TRUE(endpoint_.open());
  EXPECT_EQ(2U, system_.lines.size()) << "that it is open again";
  EXPECT_TRUE(ant().comes(kPort, {1}));
  EXPECT_EQ(1U, ant().endpoints()) << "those without a port were closed";
}

TEST_F(AntEndpointTest, ItAsksForOneThingAfterTheOther) {
  beginInVain();
  ant().silent = true;
  tick(1.0);
  for (int answers = 0; answers < 4; ++answers) {  // memory twice, an endpoint, a port
    EXPECT_FALSE(endpoint_.open());
    EXPECT_EQ(1U, ant().waiting());
    answer();
    tick(1.1);
  }
  EXPECT_TRUE(endpoint_.open());
  EXPECT_EQ(2U, ant().memory());
  EXPECT_TRUE(ant().comes(kPort, {1}));
  EXPECT_EQ(2U, system_.lines.size()) << "that it is open again";
}

// The first opening fails after some Calls.
class CallsInVain : public AntEndpointTest, public testing::WithParamInterface<int> {};

TEST_P(CallsInVain, AreReportedAndFollowedByMessagesAfterTwoSeconds) {
  ant().callsServed = GetParam();
  begin();
  EXPECT_EQ(GetParam() + 1, ant().calls);
  EXPECT_EQ(1U, system_.lines.size());
  at(2.9);
  EXPECT_FALSE(endpoint_.open()) << "not before its time";
  at(3.1);
  EXPECT_TRUE(endpoint_.open());
  EXPECT_EQ(2U, system_.lines.size()) << "that it is open again";
  EXPECT_EQ(2U, ant().memory());
  EXPECT_EQ(1U, ant().endpoints()) << "the one without a port was closed";
  ASSERT_TRUE(ant().comes(kPort, {1}));
  EXPECT_EQ(Bytes{1}, take());
}

INSTANTIATE_TEST_SUITE_P(AfterAnswers, CallsInVain, testing::Range(0, 4));

// The network falls silent after some answers.
class SilentAnt : public AntEndpointTest, public testing::WithParamInterface<int> {};

TEST_P(SilentAnt, IsGivenUpAfterASecondAndAskedAgainAfterTwo) {
  beginInVain();
  ant().silent = true;
  tick(1.0);
  for (int i = 0; i < GetParam(); ++i) answer();
  tick(1.9);
  tick(2.1);
  EXPECT_EQ(1U, system_.lines.size()) << "told before";
  tick(3.9);
  ant().silent = false;
  ant().answerRequests();
  takeAll();
  EXPECT_FALSE(endpoint_.open()) << "all that was late";
  at(4.2);
  EXPECT_TRUE(endpoint_.open());
  EXPECT_EQ(2U, system_.lines.size());
  EXPECT_EQ(2U, ant().memory()) << "what came late was given back";
  EXPECT_EQ(1U, ant().endpoints());
}

INSTANTIATE_TEST_SUITE_P(AfterAnswers, SilentAnt, testing::Range(0, 4));

TEST_P(SilentAnt, MayAnswerWhenItWasAskedAgain) {
  beginInVain();
  ant().silent = true;
  tick(1.0);
  for (int i = 0; i < GetParam(); ++i) answer();
  tick(2.1);
  tick(4.2);
  ant().silent = false;
  ant().answerRequests();
  takeAll();
  EXPECT_TRUE(endpoint_.open());
  EXPECT_EQ(2U, ant().memory());
  EXPECT_EQ(1U, ant().endpoints());
  ASSERT_TRUE(ant().comes(kPort, {1}));
  EXPECT_EQ(Bytes{1}, take());
}

TEST_F(AntEndpointTest, WhatIsBusyOrTooLongLeavesItOpen) {
  begin();
  for (const UDPEndpointError error : {UDP_MESSAGE_TOO_LONG, UDP_WOULDBLOCK, UDP_CONNECTION_BUSY}) {
    ASSERT_TRUE(ant().comes(kPort, {1}, error));
    EXPECT_TRUE(take().empty());
    EXPECT_TRUE(broadcast({1}));
    ant().answerSends(error);
    take();
  }
  EXPECT_TRUE(endpoint_.open());
  EXPECT_EQ(1, ant().opened);
  EXPECT_TRUE(ant().comes(kPort, {2}));
  EXPECT_EQ(Bytes{2}, take());
}

TEST_F(AntEndpointTest, OpensAgainAfterTheNetworkWasLost) {
  begin();
  broadcast({1});
  ant().lose();
  takeAll();
  EXPECT_FALSE(endpoint_.open());
  EXPECT_FALSE(broadcast({2}));
  at(2.9);
  EXPECT_FALSE(endpoint_.open());
  at(3.1);
  EXPECT_TRUE(endpoint_.open());
  EXPECT_EQ(2, ant().opened);
  EXPECT_TRUE(broadcast({3}));
  EXPECT_TRUE(ant().comes(kPort, {4}));
  EXPECT_EQ(Bytes{4}, take());
}

TEST_F(AntEndpointTest, ALateAnswerIsLate) {
  begin();
  broadcast({1});
  at(1.9);
  EXPECT_TRUE(endpoint_.open());
  EXPECT_TRUE(system_.lines.empty());
  at(2.2);  // more than a second without an answer
  EXPECT_FALSE(endpoint_.open());
  EXPECT_EQ(1U, system_.lines.size());
  at(4.3);
  ASSERT_TRUE(endpoint_.open());
  EXPECT_TRUE(broadcast({2}));
  ant().answerSends();
  take();
  EXPECT_FALSE(broadcast({3})) << "the answer was to the first";
  take();
  EXPECT_TRUE(broadcast({3}));
}

TEST_F(AntEndpointTest, ALateDatagramOfAClosedEndpointIsNotHeard) {
  begin();
  ant().comes(kPort, {1});  // answered, not yet delivered
  broadcast({1});
  tick(2.2);
  tick(4.3);
  EXPECT_TRUE(take().empty());
  takeAll();
  ASSERT_TRUE(endpoint_.open());
  EXPECT_TRUE(ant().comes(kPort, {2}));
}

TEST_F(AntEndpointTest, ACloseWithoutAnAnswerDelaysNothing) {
  begin();
  ant().lose();
  ant().silent = true;
  takeAll();
  EXPECT_EQ(1U, ant().waiting()) << "the close";
  tick(2.1);
  tick(2.9);
  EXPECT_EQ(1U, ant().waiting());
  tick(3.1);
  EXPECT_EQ(2U, ant().waiting());
  ant().silent = false;
  ant().answerRequests();
  takeAll();
  EXPECT_TRUE(endpoint_.open());
  EXPECT_EQ(2U, system_.lines.size()) << "that it is deaf, that it is open again";
}

TEST_F(AntEndpointTest, ACloseThatIsRefusedIsNotAskedTwice) {
  begin();
  ant().lose();
  ant().refusesMessages = true;
  takeAll();
  ant().refusesMessages = false;
  at(3.1);
  EXPECT_TRUE(endpoint_.open());
}

TEST_F(AntEndpointTest, WithoutANetworkItIsSilent) {
  openr::FakeSystem none;
  const openr::SystemScope scope(none);
  begin();
  for (double now = 1.0; now < 20.0; now += 0.5) at(now);
  EXPECT_FALSE(endpoint_.open());
  EXPECT_EQ(1U, none.lines.size());
}

}  // namespace
}  // namespace kelpie::agent
