// SPDX-License-Identifier: Apache-2.0
// Moments of play as rows of a table, from which the value is learnt: what the moment is to a team
// (Features) and how its stretch of play ended. Two rows a moment, one for each team.
#pragma once

#include <ostream>

#include "tools/league/value/PlayedTruth.h"
#include "tools/league/value/State.h"

namespace kelpie::value {

struct Row {
  double seconds = 0.0;
  TeamColour team = TeamColour::red;
  double left = 0.0;  // s until the stretch ends
  int ends = 0;       // 1: by this team's goal; -1: by the other's; 0: by neither
  Features features;
};

// Moments that are `apart` s from each other.
std::vector<Row> rowsOf(const PlayedTruth& match, const body::FieldDescription& field,
                        double apart);

void writeHead(std::ostream& out);
// `match`: a word that tells it from others.
void writeRows(const std::vector<Row>& rows, const std::string& match, std::ostream& out);

}  // namespace kelpie::value
