// SPDX-License-Identifier: Apache-2.0
// What the SDK's stub generator writes from stub.cfg, by hand for the host, with its names
// (openr-measured.md 1): the agent's services.
#pragma once

constexpr const char* objectName = "Agent";
constexpr int numOfSubject = 1;
constexpr int numOfObserver = 2;

constexpr int sbjEffector = 0;
constexpr int obsSensor = 0;
constexpr int obsFbkImageSensor = 1;

constexpr const char* subjectService[numOfSubject] = {"Agent.Effector.OCommandVectorData.S"};
constexpr const char* observerService[numOfObserver] = {
    "Agent.Sensor.OSensorFrameVectorData.O",
    "Agent.FbkImageSensor.OFbkImageVectorData.O",
};
