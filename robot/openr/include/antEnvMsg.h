// SPDX-License-Identifier: Apache-2.0
// Messages between an object and the robot's network (openr.md 5.7). Call waits for the answer,
// which is then in the message itself; Send returns at once, and a copy of the message with the
// answer comes to an Extra entry of the sender. `continuation` comes back as it was.
#pragma once

#include "OPENR/OPENR.h"
#include "antModuleRef.h"
#include "antSharedBuffer.h"

// Which network: "IPStack". The name is not const on the robot either.
class antStackRef {
 public:
  antStackRef() = default;
  explicit antStackRef(char* name) : oid_(name) {}
  bool IsValid() { return oid_.IsValid(); }
  OID& get_oid() { return oid_; }

 private:
  OID oid_;
  [[maybe_unused]] void* dispatcher_ = nullptr;
};

enum antEnvMsgInvocation { ANTENVMSG_SEND = 0, ANTENVMSG_CALL };

// Where a reply goes: an object and the number of its entry.
class antEnvMsgContInfo {
 public:
  antEnvMsgContInfo() = default;
  antEnvMsgContInfo(OID target, uint32 selector) : target_(target), selector_(selector) {}
  OID GetOID() { return target_; }
  uint32 GetSelector() { return selector_; }

 private:
  OID target_;
  uint32 selector_ = UNDEF;
};

struct antEnvMsg {
  Selector dstSelector = UNDEF;
  antModuleRef dstModule;  // none: the environment itself
  int32 dstOperation = 0;
  OID sender;
  int32 msgSize = 0;
  antEnvMsgInvocation invocationType = ANTENVMSG_SEND;
  antEnvMsgContInfo contInfo;
  void* continuation = nullptr;

  antEnvMsg() = default;
  explicit antEnvMsg(int32 operation) : dstOperation(operation) {}
  antEnvMsg(antModuleRef module, int32 operation) : dstModule(module), dstOperation(operation) {}

  // Sizes are of the whole message.
  antError Send(antStackRef target, OID& from, slongword selector, int size);
  antError Call(antStackRef target, int size);
  static antEnvMsg* Receive(ANTENVMSG message);
};

constexpr int32 antEnv_Operation_CreateEndpoint = -1;
constexpr int32 antEnv_Operation_CreateSharedBuffer = -2;
constexpr int32 antEnv_Operation_DestroySharedBuffer = -3;

struct antEnvCreateEndpointMsg : public antEnvMsg {
  antError error = ANT_FAIL;
  int32 protocol = 0;
  int32 poolSize = 0;
  antModuleRef moduleRef;

  antEnvCreateEndpointMsg(int32 kind, int32 bytes)
      : antEnvMsg(antEnv_Operation_CreateEndpoint), protocol(kind), poolSize(bytes) {}
};

struct antEnvCreateSharedBufferMsg : public antEnvMsg {
  antError error = ANT_FAIL;
  uint32 size = 0;
  antSharedBuffer buffer;

  explicit antEnvCreateSharedBufferMsg(uint32 bytes)
      : antEnvMsg(antEnv_Operation_CreateSharedBuffer), size(bytes) {}
};

// Gives back what was shared; it must not be mapped any more.
struct antEnvDestroySharedBufferMsg : public antEnvMsg {
  antError error = ANT_FAIL;
  antSharedBuffer buffer;

  explicit antEnvDestroySharedBufferMsg(antSharedBuffer& memory)
      : antEnvMsg(antEnv_Operation_DestroySharedBuffer), buffer(memory) {}
};
