// SPDX-License-Identifier: Apache-2.0
// Colours and shapes that the scenes are made of. Lengths are metres, points in whatever frame the
// entity that they go into names.
#pragma once

#include <string>
#include <vector>

#include "foxglove/Scene.pb.h"
#include "robot/core/Time.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Percepts.h"

namespace kelpie::viewer {

foxglove::Color colour(double r, double g, double b, double a = 1.0);
foxglove::Color colourOf(TeamColour team);
foxglove::Color colourOf(LandmarkKind kind);
foxglove::Color colourOf(LinePointKind kind);
foxglove::Color ballColour();
foxglove::Color white();

// One that stays until another of its name replaces it.
foxglove::SceneEntity entity(TimeUs time, const std::string& frame, const std::string& id);

void addBox(foxglove::SceneEntity& to, const foxglove::Pose& pose, const foxglove::Vector3& size,
            const foxglove::Color& colour);
// A bar of square section from one point to another.
void addBar(foxglove::SceneEntity& to, const foxglove::Vector3& from, const foxglove::Vector3& end,
            double thickness, const foxglove::Color& colour);
void addBall(foxglove::SceneEntity& to, const foxglove::Vector3& middle, double radius,
             const foxglove::Color& colour);
void addCylinder(foxglove::SceneEntity& to, const foxglove::Vector3& middle, double radius,
                 double height, const foxglove::Color& colour);
void addLines(foxglove::SceneEntity& to, foxglove::LinePrimitive::Type type, double thickness,
              const std::vector<foxglove::Vector3>& points, const foxglove::Color& colour);
void addArrow(foxglove::SceneEntity& to, const foxglove::Pose& pose, double length,
              const foxglove::Color& colour);
// Words that face who looks.
void addText(foxglove::SceneEntity& to, const foxglove::Vector3& where, double size,
             const std::string& text, const foxglove::Color& colour);

}  // namespace kelpie::viewer
