// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/Experiment.h"

namespace kelpie::experiments {
namespace {

std::vector<Experiment> ofBelieving() {
  return {
      {"localise-observations",
       "the localiser on made landmark sightings (6 %, 2 deg, one in twenty false) and "
       "line points: "
       "mean errors of place and heading while walking, at four headings",
       20, localiseObservations},
      {"maximiser",
       "from a guess to the pose at which seen lines match best: the thesis' gradient ascent "
       "beside "
       "damped Gauss-Newton steps; share within 10 cm and 5 deg, evaluations, error",
       500, maximiser},
      {"stationary-map",
       "a robot that stands and looks about for five seconds: error of the pose by lines alone "
       "from "
       "a start within 40 cm and 20 deg, with the map and without, and by the search",
       200, stationaryMap},
      {"stationary-views",
       "the same from pixels with every artefact, eight seconds: lines alone, with the map and "
       "without",
       4, stationaryViews},
      {"global-localise",
       "the search over the field by lines alone: share of random poses found within 20 cm and 10 "
       "deg, the twin counting, then with landmarks",
       200, globalLocalise},
      {"mode-sampling",
       "the thesis' sampling of the match about each mode beside the fit, on the same walks: "
       "errors, and how far the estimate jumps in a frame",
       50, modeSampling},
      {"localise",
       "three minutes of chasing a ball from an unknown start, from pixels: errors of the believed "
       "pose after ten seconds, with lines, landmarks or both, and what they come from",
       8, localise},
      {"kidnap",
       "a playing robot carried to a random place every 20 s: time until it is within 30 cm and 15 "
       "deg for a second; the three noise methods on the same matches",
       8, kidnap},
      {"stuck",
       "walking freely and held (thesis 2004 figure 2.10): the way and standard deviation "
       "reported, "
       "hits and false alarms, turns with weak legs; after scrums, seconds until the pose is right",
       8, stuck},
      {"slam",
       "the 2004 localisation challenge from pixels: a minute to map sheets on the wall, landmarks "
       "hidden, robot carried away, two minutes for five points: points, errors of the map, ghosts",
       50, slam},
      {"ball",
       "the ball filter: errors of place and velocity standing and walking, the speed of a lying "
       "ball, where a rolling one will lie after half a second of sight",
       200, ballFilter},
      {"opponents",
       "four opponents wandering about: error, separation and share found of the four filters, of "
       "one robot alone and of a team of four that shares",
       20, opponents},
      {"team-ball",
       "four robots and one ball, a wrong pose in every second trial: error and standard deviation "
       "of the fused ball beside the surest robot's own",
       100, teamBall},
  };
}

std::vector<Experiment> ofSeeingAndPlaying() {
  return {
      {"score-empty-goal",
       "one robot, unknown start, ball at random, no opponent: share of trials with a goal within "
       "60 s, median time to it; every camera artefact on",
       20, scoreEmptyGoal},
      {"line-points",
       "points on lines, border and carpet in random views with every artefact: share that is "
       "true, error on the ground by distance, share of the visible crossings found",
       400, linePoints},
      {"projection",
       "a grid of ground discs rendered and found again in the image, against its projection: "
       "largest error in pixels, and on the ground at 1 m",
       500, projection},
      {"objects",
       "rendered random views with every artefact and spectators: recall, false percepts, errors "
       "of "
       "distance and heading by object and distance",
       6000, objects},
      {"doubts",
       "how well vision judges candidates for goals and robots: real ones lost against false ones "
       "left, with its own curves and with curves learned from the same views",
       6000, doubts},
      {"ring",
       "the ring learner on seeded sheets of six colours: largest error of F and of the centres, "
       "what is left on a white sheet, the simplex beside least squares, the genuine frames",
       2, ring},
      {"colour",
       "share of pixels that get their class: hand-labelled ones held out of training beside the "
       "2005 table and nine nearest neighbours; in rendered views with and without ring correction",
       60, colour},
      {"robots",
       "other robots in random views with spectators: recall to 200 cm, errors of heading and "
       "distance, false ones and wrong teams",
       400, robots},
      {"pink-patches",
       "pink sheets on the carpet in random views: recall, errors of heading and distance, false "
       "ones without a sheet",
       400, pinkPatches},
      {"obstacles-ahead",
       "dark pixels in the box ahead against a robot's true presence: hits and false alarms by "
       "threshold",
       3000, obstaclesAhead},
      {"walk-and-kick",
       "the actuator in the simulated body: true way over reported way in four directions; how far "
       "and how straight the ball goes from 25 places before the chest",
       1, walkAndKick},
      {"class-planes",
       "random views: size of their class planes, and vision on the images made again from them "
       "against vision on the views themselves",
       500, classPlanes},
      {"distances",
       "the distance models of vision against sizes measured on real robots in 2005, beside the "
       "team's own fits (reads ../shared/data/distance)",
       1, distances},
      {"field-edge",
       "where the carpet ends: the fit on points of which many are wrong (checklist E4), then "
       "vision on random views and on views of a corner, every camera artefact on",
       1000, fieldEdge},
  };
}

std::vector<Experiment> together() {
  std::vector<Experiment> all = ofSeeingAndPlaying();
  for (const Experiment& one : ofBelieving()) all.push_back(one);
  return all;
}

}  // namespace

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> kAll = together();
  return kAll;
}

}  // namespace kelpie::experiments
