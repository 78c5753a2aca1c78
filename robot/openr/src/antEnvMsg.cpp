// SPDX-License-Identifier: Apache-2.0
#include <antEnvMsg.h>

#include "robot/openr/System.h"

using kelpie::openr::currentSystem;

antError antEnvMsg::Send(antStackRef target, OID& from, slongword selector, int size) {
  if (!target.IsValid()) return ANT_FAIL;
  invocationType = ANTENVMSG_SEND;
  sender = from;
  msgSize = size;
  contInfo = antEnvMsgContInfo(from, static_cast<uint32>(selector));
  return currentSystem().antSend(*this);
}

antError antEnvMsg::Call(antStackRef target, int size) {
  if (!target.IsValid()) return ANT_FAIL;
  invocationType = ANTENVMSG_CALL;
  msgSize = size;
  return currentSystem().antCall(*this);
}

antEnvMsg* antEnvMsg::Receive(ANTENVMSG message) { return static_cast<antEnvMsg*>(message); }
