// SPDX-License-Identifier: Apache-2.0
// A network of the robot for tests: it can refuse, be silent, answers a Send or a Receive only when
// the test says so, and can lose its endpoints. What it is asked for besides it answers at once,
// and it counts who waits for that, at the start, where that is allowed, and afterwards. Who waits
// for an answer that does not come goes on without one.
#pragma once

#include <UDPEndpointMsg.h>

#include <algorithm>
#include <cstring>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "robot/openr/System.h"

namespace kelpie::host {

using Bytes = std::vector<std::uint8_t>;

class FakeAnt {
 public:
  bool refusesMemory = false;
  bool refusesEndpoints = false;
  bool refusesPorts = false;
  bool refusesMessages = false;
  bool silent = false;                                // about all that it is asked for
  int callsServed = std::numeric_limits<int>::max();  // those after them fail
  bool started = false;                               // whoever asks; the tests tell when
  int calls = 0;                                      // that waited for their answer, at the start
  int lateCalls = 0;                                  // and afterwards
  int opened = 0;                                     // endpoints, ever
  std::vector<Bytes> broadcasts;
  Port lastPort = 0;  // that was sent to

  antError call(antEnvMsg& message) {
    ++(started ? lateCalls : calls);
    return silent || calls > callsServed ? ANT_FAIL : serve(message);
  }

  antError send(const antEnvMsg& message) {
    if (refusesMessages) return ANT_FAIL;
    openr::AntReply copy;
    const auto bytes = static_cast<std::size_t>(message.msgSize);
    copy.bytes.resize(bytes / sizeof(std::max_align_t) + 1);
    std::memcpy(copy.bytes.data(), &message, bytes);
    waiting_.push_back(copy);
    if (!silent) answerRequests();
    return ANT_SUCCESS;
  }

  // All but Sends and Receives.
  int answerRequests() {
    int count = 0;
    for (;; ++count) {
      const auto place = std::find_if(waiting_.begin(), waiting_.end(), [](openr::AntReply& one) {
        const int32 asked = head(one).dstOperation;
        return asked != UDPEndpoint_Operation_Send && asked != UDPEndpoint_Operation_Receive;
      });
      if (place == waiting_.end()) return count;
      (void)serve(head(*place));
      reply(place);
    }
  }

  // A datagram comes in; false when nobody receives at the port.
  bool comes(Port port, const Bytes& datagram, UDPEndpointError error = UDP_SUCCESS) {
    const auto place = std::find_if(waiting_.begin(), waiting_.end(), [&](openr::AntReply& one) {
      return head(one).dstOperation == UDPEndpoint_Operation_Receive && portOf(head(one)) == port;
    });
    if (place == waiting_.end()) return false;
    auto& message = static_cast<UDPEndpointReceiveMsg&>(head(*place));
    const std::size_t size = std::min(datagram.size(), static_cast<std::size_t>(message.size));
    std::memcpy(message.buffer, datagram.data(), size);
    message.size = static_cast<int>(size);
    answer(place, error);
    return true;
  }

  // Every Send that waits gets its answer, and so counts as heard by the others.
  int answerSends(UDPEndpointError error = UDP_SUCCESS) {
    int count = 0;
    for (;; ++count) {
      const auto place = std::find_if(waiting_.begin(), waiting_.end(), [&](openr::AntReply& one) {
        return head(one).dstOperation == UDPEndpoint_Operation_Send;
      });
      if (place == waiting_.end()) return count;
      const auto& message = static_cast<UDPEndpointSendMsg&>(head(*place));
      lastPort = message.port;
      if (error == UDP_SUCCESS)
        broadcasts.emplace_back(message.buffer, message.buffer + message.size);
      answer(place, error);
    }
  }

  // The network goes away: every Send and Receive that waits is answered so.
  void lose() {
    while (!waiting_.empty()) answer(waiting_.begin(), UDP_CONNECTION_CLOSED);
  }

  struct Answer {
    OServiceEntry to;
    openr::AntReply reply;
  };
  std::deque<Answer> answers;
  std::size_t waiting() const { return waiting_.size(); }
  std::size_t endpoints() const { return endpoints_.size(); }  // that are not closed
  std::size_t memory() const { return memory_.size(); }        // buffers that are shared

 private:
  struct Endpoint {
    antModuleRef module;
    Port port = 0;
  };
  using Waiting = std::deque<openr::AntReply>;
  using Memory = std::unique_ptr<std::uint8_t[]>;

  template <class Message>
  static Message& as(antEnvMsg& message) {
    return static_cast<Message&>(message);
  }
  static antEnvMsg& head(openr::AntReply& one) { return *antEnvMsg::Receive(one.bytes.data()); }

  antError serve(antEnvMsg& message) {
    switch (message.dstOperation) {
      case antEnv_Operation_CreateSharedBuffer:
        return share(as<antEnvCreateSharedBufferMsg>(message));
      case antEnv_Operation_DestroySharedBuffer:
        return unshare(as<antEnvDestroySharedBufferMsg>(message));
      case antEnv_Operation_CreateEndpoint: return create(as<antEnvCreateEndpointMsg>(message));
      case UDPEndpoint_Operation_Bind: return bind(as<UDPEndpointBindMsg>(message));
      case UDPEndpoint_Operation_Close: return close(as<UDPEndpointCloseMsg>(message));
      default: return ANT_FAIL;
    }
  }
  antError share(antEnvCreateSharedBufferMsg& message) {
    if (refusesMemory) return ANT_FAIL;
    memory_.push_back(std::make_unique<std::uint8_t[]>(message.size));
    message.buffer = antSharedBuffer(memory_.back().get(), message.size);
    return message.error = ANT_SUCCESS;
  }
  antError unshare(antEnvDestroySharedBufferMsg& message) {
    (void)message.buffer.Map();
    const auto place = std::find_if(memory_.begin(), memory_.end(), [&](const Memory& one) {
      return one.get() == message.buffer.GetAddress();
    });
    if (place == memory_.end()) return ANT_FAIL;
    memory_.erase(place);
    return message.error = ANT_SUCCESS;
  }
  antError create(antEnvCreateEndpointMsg& message) {
    if (refusesEndpoints) return ANT_FAIL;
    message.moduleRef = antModuleRef(this, static_cast<uint32>(++opened));
    endpoints_.push_back({message.moduleRef, 0});
    return message.error = ANT_SUCCESS;
  }
  std::vector<Endpoint>::iterator endpointOf(const antEnvMsg& message) {
    return std::find_if(endpoints_.begin(), endpoints_.end(),
                        [&](const Endpoint& one) { return one.module == message.dstModule; });
  }
  antError bind(UDPEndpointBindMsg& message) {
    const auto place = endpointOf(message);
    message.error = refusesPorts || place == endpoints_.end() ? UDP_ADDRESSINUSE : UDP_SUCCESS;
    if (message.error == UDP_SUCCESS) place->port = message.port;
    return ANT_SUCCESS;
  }
  antError close(UDPEndpointCloseMsg& message) {
    const auto place = endpointOf(message);
    message.error = place == endpoints_.end() ? UDP_CONNECTION_CLOSED : UDP_SUCCESS;
    if (message.error == UDP_SUCCESS) endpoints_.erase(place);
    return ANT_SUCCESS;
  }
  Port portOf(const antEnvMsg& message) const {
    for (const Endpoint& one : endpoints_)
      if (one.module == message.dstModule) return one.port;
    return 0;
  }
  void answer(Waiting::iterator place, UDPEndpointError error) {
    as<UDPEndpointBaseMsg>(head(*place)).error = error;
    reply(place);
  }
  void reply(Waiting::iterator place) {
    antEnvMsgContInfo to = head(*place).contInfo;
    answers.push_back({{to.GetOID(), to.GetSelector()}, *place});
    waiting_.erase(place);
  }

  std::vector<Memory> memory_;
  std::vector<Endpoint> endpoints_;
  Waiting waiting_;
};

}  // namespace kelpie::host
