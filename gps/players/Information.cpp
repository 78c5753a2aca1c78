// SPDX-License-Identifier: Apache-2.0
#include "gps/players/Information.h"

namespace kelpie::gps {

Information informationOf(const Place& place) {
  const Matrix2 inverse = place.covariance.inverse();
  const Vector2 vector = inverse * place.mean;
  return {rowsOf(inverse), {vector(0), vector(1)}};
}

Place placeOf(const Information& information) {
  const Matrix2 covariance = matrixOf(information.matrix).inverse();
  return {covariance * Vector2(information.vector[0], information.vector[1]), covariance};
}

void add(const Information& more, Information& sum) {
  for (std::size_t i = 0; i < 4; ++i) sum.matrix[i] += more.matrix[i];
  for (std::size_t i = 0; i < 2; ++i) sum.vector[i] += more.vector[i];
}

}  // namespace kelpie::gps
