// SPDX-License-Identifier: Apache-2.0
// The kinds of scenes that are recorded: how random views of a kind are drawn, and which of them
// show what it is about. Judged by the truth alone, never by vision.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tools/experiments/views/Objects.h"
#include "tools/experiments/views/View.h"

namespace kelpie::recorded {

struct Candidate {
  const experiments::View& view;
  const std::vector<experiments::TrueObject>& objects;
};

struct Kind {
  const char* name;
  std::uint64_t seed;
  std::array<int, 2> planes;  // in nominal and in randomised worlds
  std::array<int, 2> frames;
  void (*draw)(experiments::ViewParams& params);
  bool (*fits)(const Candidate& candidate);
};

const std::vector<Kind>& kinds();

// `randomised`: the seed of its worlds; 0 is the nominal one.
experiments::ViewParams paramsFor(const Kind& kind, std::uint64_t randomised);

// As scenes.toml names it.
std::string nameOf(const experiments::TrueObject& object);

}  // namespace kelpie::recorded
