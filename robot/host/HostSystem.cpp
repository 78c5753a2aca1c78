// SPDX-License-Identifier: Apache-2.0
#include "robot/host/HostSystem.h"

#include <memory>

namespace kelpie::host {
namespace {

// The third part of "Object.Service.DataType.S".
std::string dataType(const std::string& service) {
  const std::size_t end = service.rfind('.');
  const std::size_t start = service.rfind('.', end - 1);
  return service.substr(start + 1, end - start - 1);
}

bool isSubject(const std::string& service) { return service.back() == 'S'; }

bool wellFormed(const std::string& service) {
  std::size_t dots = 0;
  for (const char letter : service) dots += letter == '.' ? 1 : 0;
  return dots == 3 && (service.back() == 'S' || service.back() == 'O');
}

const char* levelName(int level) {
  constexpr const char* kNames[] = {"", "error: ", "warning: ", "info: "};
  return level >= 0 && level <= 3 ? kNames[level] : "";
}

void releaseRegions(openr::Message& message) {
  auto* notify = std::get_if<ONotifyMessage>(&message);
  if (notify == nullptr) return;
  for (int i = 0; i < notify->NumberOfData(); ++i) notify->data[i].srcRCR->RemoveReference();
  notify->Clear();
}

void hearAll(const WorldStep& step, const Network& network) {
  if (network.tick) network.tick(step.time);
  if (network.control && !step.control.bytes.empty()) network.control(step.control, step.time);
  if (!network.heard) return;
  for (const RadioPacket& packet : step.packets) network.heard(packet, step.time);
}

template <std::size_t N>
void copyName(char (&to)[N], const std::string& name) {
  std::snprintf(to, N, "%s", name.c_str());
}

}  // namespace

HostSystem::HostSystem(Source& source, const HostParams& params)
    : source_(source),
      params_(params),
      random_(params.seed),
      comm_(*this, params.sensorOrder, params.highPassRows) {}

HostSystem::~HostSystem() {
  for (Envelope& envelope : queue_) releaseRegions(envelope.message);
}

Expected<RunSummary> HostSystem::run(const openr::ObjectStub& object, const Network& network) {
  const openr::SystemScope scope(*this);
  const auto event = std::make_unique<WorldEvent>();
  Expected<bool> more = source_.next(*event);
  while (more && *more) {
    hearAll(event->step, network);
    const Status done = handle(*event, object, network);
    more = done ? source_.next(*event) : Expected<bool>(Error{done.error()});
    if (ended()) break;
  }
  const Status stopped = stopObjects();
  if (!more) return Error{more.error()};
  if (!stopped) return Error{stopped.error()};
  return summary_;
}

Status HostSystem::handle(const WorldEvent& event, const openr::ObjectStub& object,
                          const Network& network) {
  time_ = event.step.time;
  summary_.end = time_;
  if (event.step.sensorsPresent) setLatest(event.step.sensors.back());
  if (event.step.sensorsPresent) setBattery(event.step.batteryCurrent, event.step.batteryCharge);
  // The object is started when its joints can be read.
  if (objects_.empty() && event.step.sensorsPresent) {
    const Status booted = boot(object);
    if (!booted) return booted;
  }
  if (!objects_.empty()) {
    tellPower();
    const Status delivered = deliver(event);
    if (!delivered) return delivered;
  }
  Expected<AgentReply> reply = comm_.takeReply();
  if (!reply) return Error{reply.error()};
  if (network.sends && !network.sends(reply->packet)) reply->packet.bytes.clear();
  return source_.reply(*reply);
}

Status HostSystem::boot(const openr::ObjectStub& object) {
  objects_ = {comm_.stub(), object};
  Status status = lifeCycle(&OObject::Init, oreasonBOOT, "DoInit");
  if (!status) return status;
  connectServices();
  drain();
  status = lifeCycle(&OObject::Start, oreasonBOOT, "DoStart");
  drain();
  return status;
}

Status HostSystem::stopObjects() {
  Status status = lifeCycle(&OObject::Stop, oreasonSHUTDOWN, "DoStop");
  drain();
  const Status destroyed = lifeCycle(&OObject::Destroy, oreasonSHUTDOWN, "DoDestroy");
  return status ? destroyed : status;
}

// Runs the method of all objects before anything else; the first refusal is the result.
Status HostSystem::lifeCycle(LifeCycle method, OReason reason, const char* name) {
  Status result = Done{};
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    running_ = oidOf(i);
    status_ = oUNDEF;
    (objects_[i].object->*method)(OSystemEvent(reason, nullptr, 0));
    if (status_ != oSUCCESS && result) {
      result = Error{std::string(objects_[i].name) + "." + name + " failed with status " +
                     std::to_string(status_)};
    }
  }
  return result;
}

// What CONNECT.CFG does on the robot. Here data types tell unmistakably who belongs together.
void HostSystem::connectServices() {
  for (const Service& subject : services_) {
    if (!isSubject(subject.name)) continue;
    for (const Service& observer : services_) {
      const bool fits = !isSubject(observer.name) && !(subject.entry.oid == observer.entry.oid) &&
                        dataType(subject.name) == dataType(observer.name);
      if (fits) connect(subject, observer);
    }
  }
}

void HostSystem::connect(const Service& subject, const Service& observer) {
  const openr::ObjectStub& from = *stubOf(subject.entry.oid);
  const openr::ObjectStub& to = *stubOf(observer.entry.oid);
  OControlMessage control;
  const Selector observerIndex = observer.entry.selector - to.connect(0);
  control.command = objcommCMD_ADDOBSERVER;
  control.observerID.Set(observer.entry.oid, to.notify(observerIndex));
  copyName(control.subName, observer.name);
  post(subject.entry, control);
  OConnectMessage connected;
  const Selector subjectIndex = subject.entry.selector - from.control(0);
  connected.entry.Set(subject.entry.oid, from.ready(subjectIndex));
  copyName(connected.subName, subject.name);
  post(observer.entry, connected);
}

const openr::ObjectStub* HostSystem::stubOf(OID oid) const {
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    if (oidOf(i) == oid) return &objects_[i];
  }
  return nullptr;
}

Status HostSystem::deliver(const WorldEvent& event) {
  running_ = oidOf(0);
  const Status done = comm_.outputsDone(event.step.vectorsDone);
  if (!done) return done;
  drain();
  if (event.step.sensorsPresent) {
    ++summary_.sensorMessages;
    running_ = oidOf(0);
    comm_.sendSensors(event.step.firstTick, event.step.sensors);
    drain();
  }
  if (event.step.imagePresent) deliverImage(event.image);
  return Done{};
}

void HostSystem::deliverImage(const Image& image) {
  const std::uint32_t number = summary_.images + summary_.droppedImages;
  if (random_.chance(params_.dropRate)) {
    ++summary_.droppedImages;
    return;
  }
  ++summary_.images;
  running_ = oidOf(0);
  comm_.sendImage(image, number);
  drain();
}

void HostSystem::drain() {
  while (!queue_.empty()) {
    Envelope envelope = queue_.front();
    queue_.pop_front();
    deliver(envelope);
  }
}

void HostSystem::deliver(Envelope& envelope) {
  const openr::ObjectStub* stub = stubOf(envelope.to.oid);
  for (std::size_t i = 0; stub != nullptr && i < stub->entryCount; ++i) {
    if (stub->entries[i].selector != envelope.to.selector) continue;
    running_ = envelope.to.oid;
    stub->entries[i].method(*stub->object, envelope.message);
  }
  releaseRegions(envelope.message);
}

void HostSystem::post(const OServiceEntry& to, const openr::Message& message) {
  queue_.push_back({to, message});
}

OStatus HostSystem::registerService(const OServiceEntry& entry, const char* name) {
  if (name == nullptr || !wellFormed(name)) return oINVALID_ARG;
  if (stubOf(entry.oid) == nullptr) return oNOT_FOUND;
  services_.push_back({entry, name});
  return oSUCCESS;
}

SystemTime HostSystem::time() const {
  constexpr std::int64_t kSecond = 1000000;
  return {static_cast<longword>(time_.us / kSecond), static_cast<longword>(time_.us % kSecond)};
}

void HostSystem::print(int level, const char* line) {
  if (params_.printTo == nullptr) return;
  const openr::ObjectStub* stub = stubOf(running_);
  std::fprintf(params_.printTo, "%.3f s %s: %s%s\n", time_.seconds(),
               stub == nullptr ? "system" : stub->name, levelName(level), line);
}

}  // namespace kelpie::host
