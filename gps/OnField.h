// SPDX-License-Identifier: Apache-2.0
// Gaussians over places on the field: from the robot's frame with the pose's own uncertainty, and
// their product, which is how independent witnesses add up.
#pragma once

#include "gps/Gaussian.h"

namespace kelpie::gps {

struct Place {
  Vector2 mean = Vector2::Zero();
  Matrix2 covariance = Matrix2::Identity();
};

// A point in the robot's frame as it lies on the field if that pose is true: its covariance is
// R C R' with R = R(h - 90 deg), and J = [I | R(h) point] tells how it moves with the pose.
struct PlaceFromPose {
  Place place;
  Eigen::Matrix<double, 2, 3> jacobian;
};
PlaceFromPose placeFrom(const Pose2& pose, Point2<Robot> point, const Matrix2& covariance);

// The same of a pose that is uncertain: R C R' + J P J', thesis 2004 equation 3.12.
Place placeOnField(const PoseMode& pose, Point2<Robot> point, const Matrix2& covariance);

// The covariance from row by row; symmetric part.
Matrix2 matrixOf(const std::array<double, 4>& rows);
std::array<double, 4> rowsOf(const Matrix2& matrix);

// The product of two Gaussians, in covariance form (checklist B-2.1.3.1).
Place productOf(const Place& a, const Place& b);

// Squared Mahalanobis distance of two independent places.
double mahalanobisSquared(const Place& a, const Place& b);

// Finite, symmetric enough and positive, and no diagonal element below `min` or above `max`.
bool soundCovariance(const std::array<double, 4>& rows, double min, double max);

inline Point2<Field> pointOf(const Vector2& v) { return {v(0), v(1)}; }
inline Vector2 vectorOf(Point2<Field> p) { return {p.x, p.y}; }

}  // namespace kelpie::gps
