// SPDX-License-Identifier: Apache-2.0
#include "tools/league/value/Value.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tools/cli/DataFolder.h"

namespace kelpie::value {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kFeatures = decltype(Features::fields())::kCount;
constexpr double kSteepest = 50.0;  // of a logarithm of odds: beyond, exp says no more

std::size_t featureNamed(const std::string& name) {
  std::size_t i = 0, found = kFeatures;
  forEachFieldOf<Features>([&](const auto& f) {
    if (name == f.name) found = i;
    ++i;
  });
  return found;
}

bool areFinite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

bool rise(const std::vector<double>& values) {
  return std::adjacent_find(values.begin(), values.end(),
                            [](double a, double b) { return a >= b; }) == values.end();
}

// Of nlohmann's exceptions when a key is missing or of another type.
Expected<Curve> curveFrom(const Json& json) {
  const auto name = json.at("feature").get<std::string>();
  Curve curve{featureNamed(name), json.at("at").get<std::vector<double>>(),
              json.at("adds").get<std::vector<double>>()};
  if (curve.feature == kFeatures) return Error{"there is no feature '" + name + "'"};
  const bool whole = !curve.at.empty() && curve.at.size() == curve.adds.size();
  if (!whole || !areFinite(curve.at) || !areFinite(curve.adds) || !rise(curve.at))
    return Error{"the curve of " + name + " is none"};
  return curve;
}

Expected<Model> modelOf(const Json& json) {
  if (json.at("kelpie_value").get<int>() != 1) return Error{"model of another version"};
  Model model;
  model.horizon = json.at("horizon_s").get<double>();
  model.base = json.at("base").get<double>();
  if (!(model.horizon > 0.0) || !std::isfinite(model.horizon) || !std::isfinite(model.base))
    return Error{"a horizon or a base that cannot be"};
  for (const Json& each : json.at("curves")) {
    auto curve = curveFrom(each);
    if (!curve) return Error{curve.error()};
    model.curves.push_back(std::move(*curve));
  }
  return model;
}

std::array<double, kFeatures> numbersOf(const Features& features) {
  std::array<double, kFeatures> numbers{};
  std::size_t i = 0;
  forEachField(features, [&](const auto&, double value) { numbers[i++] = value; });
  return numbers;
}

}  // namespace

std::string modelFolder() { return cli::dataFolder() + "/tools/league/value"; }

Expected<Models> readModels(const std::string& folder) {
  auto near = readModel(folder + "/near.json");
  if (!near) return Error{near.error()};
  auto far = readModel(folder + "/far.json");
  if (!far) return Error{far.error()};
  return Models{std::move(*near), std::move(*far)};
}

Expected<Model> modelFrom(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  try {
    return modelOf(json);
  } catch (const Json::exception&) {
    return Error{"not a model of the value of play"};
  }
}

Expected<Model> readModel(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{path + ": cannot be read"};
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  auto model = modelFrom(text);
  return model ? model : Error{path + ": " + model.error()};
}

double heightOf(const Curve& curve, double x) {
  const auto above = std::upper_bound(curve.at.begin(), curve.at.end(), x);
  const auto i = static_cast<std::size_t>(above - curve.at.begin());
  if (i == 0) return curve.adds.front();
  if (i == curve.at.size()) return curve.adds.back();
  const double share = (x - curve.at[i - 1]) / (curve.at[i] - curve.at[i - 1]);
  return curve.adds[i - 1] + share * (curve.adds[i] - curve.adds[i - 1]);
}

double valueOf(const Model& model, const Features& features) {
  const auto numbers = numbersOf(features);
  double odds = model.base;
  for (const Curve& curve : model.curves) odds += heightOf(curve, numbers[curve.feature]);
  return 1.0 / (1.0 + maths::exp(-maths::clamp(odds, -kSteepest, kSteepest)));
}

TeamValues valuesOf(const Model& model, const sim::TruthFrame& truth,
                    const body::FieldDescription& field) {
  TeamValues values{};
  for (const TeamColour team : {TeamColour::red, TeamColour::blue})
    values[static_cast<std::size_t>(team)] =
        valueOf(model, featuresOf(stateOf(truth, team, field), field));
  return values;
}

}  // namespace kelpie::value
