// SPDX-License-Identifier: Apache-2.0
// The value of a moment of play to a team: how likely it is to score within the model's horizon.
// The model is a file that learn.py writes: a base and for each feature a curve, which together are
// the logarithm of the odds. A curve has its values at a few places, runs straight between them and
// level outside. What two features do together that each alone does not, such a model cannot say.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tools/league/value/State.h"

namespace kelpie::value {

struct Curve {
  std::size_t feature = 0;   // its place in the list of Features
  std::vector<double> at;    // rising
  std::vector<double> adds;  // to the logarithm of the odds, as many
};

struct Model {
  double horizon = 10.0;  // s
  double base = 0.0;      // logarithm of the odds
  std::vector<Curve> curves;
};

// Two models of one thing. A horizon of a few seconds tells what a kick gained; one of half a
// minute tells how a match goes, with less luck in it: added up, both are expected goals.
struct Models {
  Model near;
  Model far;
};

// The folder of those of the source tree, near.json and far.json.
std::string modelFolder();
// Error in one line: no file, no model, a feature that is not known, a curve that is none.
Expected<Models> readModels(const std::string& folder);
Expected<Model> readModel(const std::string& path);
Expected<Model> modelFrom(const std::string& text);

double heightOf(const Curve& curve, double x);
// 0 to 1.
double valueOf(const Model& model, const Features& features);

// Of both teams at one moment, by TeamColour.
using TeamValues = std::array<double, 2>;
TeamValues valuesOf(const Model& model, const sim::TruthFrame& truth,
                    const body::FieldDescription& field);

}  // namespace kelpie::value
