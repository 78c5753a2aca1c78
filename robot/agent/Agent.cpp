// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/Agent.h"

#include <MCOOP.h>
#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>

#include "entry.h"
#include "robot/body/Lights.h"
// After entry.h, which its macros need.
#include <OPENR/core_macro.h>

namespace kelpie::agent {
namespace {

TimeUs now() {
  SystemTime time;
  GetSystemTime(&time);
  return {static_cast<std::int64_t>(time.seconds) * 1000000 +
          static_cast<std::int64_t>(time.useconds)};
}

// OPEN-R gives what was notified as const, but its vectors have no accessors for that.
template <class Vector>
Vector& vectorOf(const ONotifyEvent& event) {
  return *static_cast<Vector*>(const_cast<void*>(event.Data(0)));
}

// How many did not open; each is reported.
template <std::size_t N>
std::size_t openAll(const std::array<const char*, N>& locators, std::array<OPrimitiveID, N>& ids) {
  std::size_t lacking = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const OStatus status = OPENR::OpenPrimitive(locators[i], &ids[i]);
    if (status == oSUCCESS) continue;
    OSYSLOG1((osyslogERROR, "%s cannot be opened: %u", locators[i], unsigned(status)));
    ids[i] = oprimitiveID_UNDEF;
    ++lacking;
  }
  return lacking;
}

}  // namespace

// The macros of OPEN-R delete nothing, since an object lives as long as its robot.
Agent::~Agent() {
  for (OSubject* one : subject) delete one;
  for (OObserver* one : observer) delete one;
}

OStatus Agent::DoInit(const OSystemEvent&) {
  NEW_ALL_SUBJECT_AND_OBSERVER;
  REGISTER_ALL_ENTRY;
  SET_ALL_READY_AND_NOTIFY_ENTRY;
  openPrimitives();
  setCamera(playing().cameraSettings());
  return newVectors();
}

// The motors have no power before the loops order it.
OStatus Agent::DoStart(const OSystemEvent&) {
  OStatus status = limp();
  if (status == oSUCCESS) status = readPose();
  if (status == oSUCCESS) status = watchPower();
  if (status != oSUCCESS) return status;
  radio_.begin(myOID_, now());  // may wait: no sensors come yet
  ENABLE_ALL_SUBJECT;
  ASSERT_READY_TO_ALL_OBSERVER;
  return oSUCCESS;
}

OStatus Agent::DoStop(const OSystemEvent&) {
  limp();
  setPower(false);
  DISABLE_ALL_SUBJECT;
  DEASSERT_READY_TO_ALL_OBSERVER;
  return oSUCCESS;
}

OStatus Agent::DoDestroy(const OSystemEvent&) {
  DELETE_ALL_SUBJECT_AND_OBSERVER;
  for (CommandVector& vector : vectors_) {
    if (vector.region == nullptr) continue;
    vector.region->RemoveReference();
    vector.region = nullptr;
    OPENR::DeleteCommandVectorData(vector.memory);
  }
  return oSUCCESS;
}

// Without a joint or the camera it cannot play; without a light, an ear, a paw or another sensor it
// can, and shows that something is amiss.
void Agent::openPrimitives() {
  const std::size_t joints = openAll(openr::kJointLocators, ids_.joints);
  std::array<OPrimitiveID, 1> camera{};
  crippled_ = joints + openAll(std::array{openr::kCameraLocator}, camera) > 0;
  ids_.camera = camera[0];
  const std::size_t sensors = openAll(openr::kSensorLocators, ids_.sensors);
  const std::size_t leds = openAll(openr::kLedLocators, ids_.leds);
  lacks_ = sensors + leds + openAll(openr::kEarLocators, ids_.ears) > 0;
  crippledLoops_.setFault(body::kCrippledFault);
  if (crippled_) OSYSLOG1((osyslogERROR, "a joint or the camera is lacking: it does not play"));
}

// CameraSettings has OPEN-R's own numbers.
static_assert(longword(WhiteBalance::indoor) == ocamparamWB_INDOOR_MODE &&
              longword(WhiteBalance::outdoor) == ocamparamWB_OUTDOOR_MODE &&
              longword(WhiteBalance::fluorescent) == ocamparamWB_FL_MODE);
static_assert(longword(CameraGain::low) == ocamparamGAIN_LOW &&
              longword(CameraGain::mid) == ocamparamGAIN_MID &&
              longword(CameraGain::high) == ocamparamGAIN_HIGH);
static_assert(longword(Shutter::slow) == ocamparamSHUTTER_SLOW &&
              longword(Shutter::mid) == ocamparamSHUTTER_MID &&
              longword(Shutter::fast) == ocamparamSHUTTER_FAST);

// At the start, and when the loops ask for another setting.
void Agent::setCamera(const CameraSettings& wanted) {
  cameraSet_ = wanted;
  if (ids_.camera == oprimitiveID_UNDEF) return;
  const OPrimitiveRequest requests[] = {oprmreqCAM_SET_WHITE_BALANCE, oprmreqCAM_SET_GAIN,
                                        oprmreqCAM_SET_SHUTTER_SPEED};
  OPrimitiveControl_CameraParam values[] = {
      OPrimitiveControl_CameraParam(longword(wanted.whiteBalance)),
      OPrimitiveControl_CameraParam(longword(wanted.gain)),
      OPrimitiveControl_CameraParam(longword(wanted.shutter))};
  for (std::size_t i = 0; i < std::size(values); ++i) {
    const OStatus status =
        OPENR::ControlPrimitive(ids_.camera, requests[i], &values[i], sizeof values[i], nullptr, 0);
    if (status == oSUCCESS) continue;
    OSYSLOG1(
        (osyslogWARNING, "camera setting %u refused: %u", unsigned(requests[i]), unsigned(status)));
  }
}

OStatus Agent::newVectors() {
  for (CommandVector& vector : vectors_) {
    const OStatus status = OPENR::NewCommandVectorData(kCommandCount, &vector.memory, &vector.data);
    if (status != oSUCCESS) return status;
    const ODataVectorInfo& info = vector.data->vectorInfo;
    const auto offset = static_cast<offset_t>(info.offset);
    vector.region = new RCRegion(info.memRegionID, offset, vector.data, info.totalSize);
    places_ = prepareCommands(*vector.data, ids_);
  }
  return oSUCCESS;
}

// No joint is held.
OStatus Agent::limp() {
  gains_ = {};
  return OPENR::DisableJointGain(oprimitiveID_UNDEF);
}

// Why it does not play, and that it plays again. A start is nothing to tell of.
void Agent::tell(Rest rest) {
  if (rest == reported_ || rest == Rest::starting || rest == Rest::unasked) return;
  OSYSLOG1((osyslogINFO, "motors: %s", body::nameOf(rest)));
  reported_ = rest;
}

// Gains go before the power does, and come after it.
void Agent::obey(const MotorsOut& motors, body::LegGain legs) {
  tell(motors.reported);
  if (motors.order.power) setPower(true);
  for (std::size_t i = 0; i < kJointCount; ++i) setGain(i, motors.order.strength[i], legs);
  if (!motors.order.power) setPower(false);
  if (motors.order.shutDown) shutDown();
}

void Agent::setPower(bool on) {
  if (on == power_) return;
  const OStatus status = OPENR::SetMotorPower(on ? opowerON : opowerOFF);
  if (status != oSUCCESS)
    OSYSLOG1(
        (osyslogERROR, "motors: power %s is refused: %u", on ? "on" : "off", unsigned(status)));
  if (status == oSUCCESS) power_ = on;
  sent_ = taken_ = false;
}

// Sent only when it changes. No gain comes before a target has been taken.
void Agent::setGain(std::size_t joint, double strength, body::LegGain legs) {
  SentGain& now = gains_[joint];
  const OPrimitiveID id = ids_.joints[joint];
  if (strength <= 0.0 || !taken_) {
    if (now.on) OPENR::DisableJointGain(id);
    now.on = false;
    return;
  }
  const body::JointGain gain =
      body::withShare(body::gainOf(static_cast<Joint>(joint), legs), strength);
  if (now.on && now.gain == gain) return;
  OStatus status = now.on ? oSUCCESS : OPENR::EnableJointGain(id);
  const body::JointGain& shift = body::kGainShift;
  if (status == oSUCCESS)
    status = OPENR::SetJointGain(id, gain.p, gain.i, gain.d, shift.p, shift.i, shift.d);
  const bool refused = status != oSUCCESS;
  if (refused) OPENR::DisableJointGain(id);
  if (refused && !now.refused)
    OSYSLOG1(
        (osyslogERROR, "gain of %s refused: %u", openr::kJointLocators[joint], unsigned(status)));
  now = {!refused, refused, gain};
}

std::uint32_t Agent::held() const {
  std::uint32_t joints = 0;
  for (std::size_t i = 0; i < kJointCount; ++i) joints |= gains_[i].on ? 1U << i : 0U;
  return joints;
}

// As Sony's PowerMonitor: nobody listens to the power any more, and the pause switch starts the
// robot again. What is refused is asked for again each second.
void Agent::shutDown() {
  constexpr std::int64_t kAgain = 1000000;  // us
  if (now() < shutDownAgain_) return;
  if (!shutDown_) OPENR::UnobservePowerStatus(OServiceEntry(myOID_, Extra_Entry[entryNotifyPower]));
  shutDown_ = true;
  shutDownAgain_ = {now().us + kAgain};
  const OStatus status = OPENR::Shutdown(OBootCondition(obcbPAUSE_SW));
  if (status != oSUCCESS) OSYSLOG1((osyslogERROR, "shutdown refused: %u", unsigned(status)));
}

void Agent::ReadyEffector(const OReadyEvent& event) {
  if (event.IsAssert() && sent_) taken_ = true;
}

// One question at the start, which waits for another object's answer; from then on the system tells
// of each change of a bit, of the capacity and of the temperature (openr-measured.md 2).
OStatus Agent::watchPower() {
  OPowerStatus power;
  if (OPENR::GetPowerStatus(&power) == oSUCCESS) takePower(power);
  power.Set(orsbALL, obsbALL, opsoREMAINING_CAPACITY_NOTIFY_EVERY_CHANGE,
            opsoTEMPERATURE_NOTIFY_EVERY_CHANGE, opsoTIME_DIF_NOT_NOTIFY, opsoVOLUME_NOT_NOTIFY);
  const OServiceEntry entry(myOID_, Extra_Entry[entryNotifyPower]);
  const OStatus status = OPENR::ObservePowerStatus(power, entry);
  if (status != oSUCCESS)
    OSYSLOG1((osyslogERROR, "the battery cannot be watched: %u", unsigned(status)));
  return status;
}

void Agent::NotifyPower(void* message) {
  takePower(static_cast<const OPowerStatusMessage*>(message)->powerStatus);
}

void Agent::takePower(const OPowerStatus& status) {
  const PowerReport report = reportOf(status);
  motionInput_.batteryCurrent = report.current;
  motionInput_.batteryCharge = report.charge;
  // The robot cuts the power for a jam. The gains do not outlive that for sure, and must not.
  if (!report.motorPower && motorPower_) {
    limp();
    power_ = sent_ = taken_ = false;
  }
  motorPower_ = report.motorPower;
  playing().power(report);
}

void Agent::NotifyControl(void* message) { radio_.controlHeard(message, now(), loops_); }
void Agent::NotifyTeam(void* message) { radio_.teamHeard(message, now(), loops_); }

// The joints are held where they are until the loops order something else.
OStatus Agent::readPose() {
  JointFrame pose;
  for (std::size_t i = 0; i < kJointCount; ++i) {
    OJointValue value;
    if (ids_.joints[i] == oprimitiveID_UNDEF) continue;
    const OStatus status = OPENR::GetJointValue(ids_.joints[i], &value);
    if (status != oSUCCESS) return status;
    pose.target.angle[i] = sensedAngle(static_cast<Joint>(i), value.value);
  }
  held_.fill(pose);
  return oSUCCESS;
}

void Agent::NotifySensor(const ONotifyEvent& event) {
  auto& vector = vectorOf<OSensorFrameVectorData>(event);
  if (readSensors(vector)) {
    motionInput_.time = lastTick(vector);
    if (!crippled_) beforeMotion();
    play();
  }
  radio_.tick(now());
  observer[event.ObsIndex()]->AssertReady();
}

void Agent::play() {
  const CameraSettings wanted = playing().cameraSettings();
  if (wanted != cameraSet_) setCamera(wanted);
  motionInput_.held = held();
  const MotionOutput& output = playing().motion(motionInput_);
  obey(playing().motors(), {output.status.lowGain, output.status.legGain});
  // At the start, or when the joints ran dry: a second vector ahead.
  if (inFlight() == 0) sendHeld();
  send(output.joints);
}

bool Agent::readSensors(OSensorFrameVectorData& vector) {
  if (!sensorReader_.matched()) {
    const std::size_t lacking = sensorReader_.match(vector, ids_);
    if (lacking > 0 && sensorReader_.matched())
      OSYSLOG1((osyslogERROR, "%u sensors do not report", unsigned(lacking)));
  }
  if (sensorReader_.read(vector, motionInput_.sensors)) return true;
  OSYSLOG1((osyslogERROR, "a sensor vector unlike the others is left out"));
  return false;
}

// Sensor ticks are regular, their messages may be late: the least late one tells when tick 0 was.
// It counts for less with the time, since the clock of the ticks and the system's part, and a count
// that began again is another one.
TimeUs Agent::lastTick(OSensorFrameVectorData& vector) {
  const auto first = static_cast<std::int64_t>(vector.GetInfo(0)->frameNumber);
  const std::int64_t last = first + static_cast<std::int64_t>(kTicksPerMessage) - 1;
  const TimeUs zero = {now().us - last * kTickUs};
  constexpr std::int64_t kParts = 3;               // us in a message: 100 of a million
  constexpr std::int64_t kAnotherCount = 1000000;  // us, later than any message
  const std::int64_t later = zero.us - tickZero_.us;
  const bool another = !clockKnown_ || later > kAnotherCount;
  tickZero_.us += another || later < kParts ? later : kParts;
  clockKnown_ = true;
  return {tickZero_.us + last * kTickUs};
}

void Agent::sendHeld() {
  held_.fill(held_.back());
  send(std::array<JointFrame, kTicksPerMessage>(held_));
}

void Agent::send(const std::array<JointFrame, kTicksPerMessage>& frames) {
  held_ = frames;
  if (lacks_)
    for (JointFrame& frame : held_) frame.leds |= body::kLightLacks;
  for (CommandVector& vector : vectors_) {
    if (vector.region->NumberOfReference() != 1) continue;
    writeCommands(held_, places_, *vector.data);
    subject[sbjEffector]->SetData(vector.region);
    subject[sbjEffector]->NotifyObservers();
    sent_ = power_;
    return;
  }
  OSYSLOG1((osyslogWARNING, "no free command vector: 32 ms of joint targets are lost"));
}

std::size_t Agent::inFlight() const {
  std::size_t count = 0;
  for (const CommandVector& vector : vectors_) {
    if (vector.region->NumberOfReference() > 1) ++count;
  }
  return count;
}

void Agent::NotifyImage(const ONotifyEvent& event) {
  auto& vector = vectorOf<OFbkImageVectorData>(event);
  if (crippled_) {
    observer[event.ObsIndex()]->AssertReady();
    return;
  }
  if (readImage(vector, image_)) {
    loops_.camera(image_, {now().us - kExposureUs / 2},
                  static_cast<std::uint32_t>(vector.GetInfo(ofbkimageLAYER_H)->frameNumber));
  } else {
    OSYSLOG1((osyslogERROR, "an image of another type or size is left out"));
  }
  radio_.send(loops_);
  frameDone();
  observer[event.ObsIndex()]->AssertReady();
}

}  // namespace kelpie::agent
