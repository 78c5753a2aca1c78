// SPDX-License-Identifier: Apache-2.0
// The dispatcher with an object that only writes down what happens to it.
#include <OPENR/OPENRAPI.h>
#include <gtest/gtest.h>

#include "FakeWorld.h"
#include "robot/host/HostSystem.h"

namespace kelpie::host {
namespace {

// Observes the sensors and reads a joint in DoStart.
class Recorder : public OObject {
 public:
  OStatus DoInit(const OSystemEvent& event) override {
    calls.push_back(event.Reason() == oreasonBOOT ? "init" : "?");
    observer.SetNotifyEntry({myOID_, 5});
    RegisterServiceEntry({myOID_, 4}, "Recorder.Sensor.OSensorFrameVectorData.O");
    return initStatus;
  }
  OStatus DoStart(const OSystemEvent&) override {
    calls.push_back("start");
    OPrimitiveID pan = 0;
    OPENR::OpenPrimitive("PRM:/r1/c1/c2-Joint2:12", &pan);
    OJointValue value;
    jointStatus = OPENR::GetJointValue(pan, &value);
    connectedAtStart = observer.NumberOfSubjects();
    observer.AssertReady();
    return oSUCCESS;
  }
  OStatus DoStop(const OSystemEvent& event) override {
    calls.push_back(event.Reason() == oreasonSHUTDOWN ? "stop" : "?");
    observer.DeassertReady();
    return oSUCCESS;
  }
  OStatus DoDestroy(const OSystemEvent&) override {
    calls.push_back("destroy");
    return oSUCCESS;
  }

  openr::ObjectStub stub();

  OObserver observer;
  OStatus initStatus = oSUCCESS;
  OStatus jointStatus = oUNDEF;
  int connectedAtStart = 0;
  bool assertsAgain = true;
  std::vector<std::string> calls;
};

void connect(OObject& self, const openr::Message& message) {
  auto& recorder = static_cast<Recorder&>(self);
  recorder.calls.push_back("connect");
  recorder.observer.ConnectHandler(std::get<OConnectMessage>(message), oSUCCESS);
}

void notify(OObject& self, const openr::Message& message) {
  auto& recorder = static_cast<Recorder&>(self);
  const auto& content = std::get<ONotifyMessage>(message);
  recorder.calls.push_back("sensors " +
                           std::to_string(content.data[0].srcRCR->NumberOfReference()));
  if (recorder.assertsAgain) recorder.observer.AssertReady();
}

openr::ObjectStub Recorder::stub() {
  static constexpr openr::ObjectEntry kEntries[] = {{4, connect}, {5, notify}};
  return {this, "Recorder", 0, 1, kEntries, std::size(kEntries)};
}

using Calls = std::vector<std::string>;

TEST(HostSystemTest, LifeCycleRunsInOrderAroundTheMessages) {
  FakeSource source;
  source.addSensors(2);
  source.steps[1].vectorsDone = 0;
  Recorder recorder;
  HostSystem system(source, {});
  ASSERT_TRUE(system.run(recorder.stub(), {}));
  EXPECT_EQ((Calls{"init", "connect", "start", "sensors 2", "sensors 2", "stop", "destroy"}),
            recorder.calls);
  EXPECT_EQ(1, recorder.connectedAtStart);
  EXPECT_EQ(oSUCCESS, recorder.jointStatus);
}

TEST(HostSystemTest, ObserverThatDoesNotAssertGetsNoMore) {
  FakeSource source;
  source.addSensors(3);
  for (WorldStep& step : source.steps) step.vectorsDone = 0;
  Recorder recorder;
  recorder.assertsAgain = false;
  HostSystem system(source, {});
  ASSERT_TRUE(system.run(recorder.stub(), {}));
  EXPECT_EQ((Calls{"init", "connect", "start", "sensors 2", "stop", "destroy"}), recorder.calls);
}

TEST(HostSystemTest, ObjectThatRefusesToStartIsNamed) {
  FakeSource source;
  source.addSensors(1);
  Recorder recorder;
  recorder.initStatus = oNOT_FOUND;
  HostSystem system(source, {});
  EXPECT_EQ("Recorder.DoInit failed with status 6", system.run(recorder.stub(), {}).error());
  EXPECT_EQ((Calls{"init", "stop", "destroy"}), recorder.calls);
  EXPECT_TRUE(source.replies.empty());
}

TEST(HostSystemTest, ServicesNeedFourPartsInTheirName) {
  class Nameless : public OObject {
   public:
    OStatus DoInit(const OSystemEvent&) override {
      return RegisterServiceEntry({myOID_, 4}, "Nameless.Sensor.O");
    }
  } object;
  FakeSource source;
  source.addSensors(1);
  HostSystem system(source, {});
  EXPECT_EQ("Nameless.DoInit failed with status 4",
            system.run({&object, "Nameless", 0, 1, nullptr, 0}, {}).error());
}

TEST(HostSystemTest, WorldThatSaysGoodbyeAtOnceStartsNothing) {
  FakeSource source;
  Recorder recorder;
  HostSystem system(source, {});
  const auto summary = system.run(recorder.stub(), {});
  ASSERT_TRUE(summary);
  EXPECT_EQ(0U, summary->sensorMessages);
  EXPECT_TRUE(recorder.calls.empty());
}

}  // namespace
}  // namespace kelpie::host
