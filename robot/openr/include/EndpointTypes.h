// SPDX-License-Identifier: Apache-2.0
// Kinds of endpoints (openr.md 5.7).
#pragma once

enum EndpointType {
  EndpointType_TCP = 1,
  EndpointType_UDP = 2,
  EndpointType_DNS = 4,
  EndpointType_IP = 7
};
