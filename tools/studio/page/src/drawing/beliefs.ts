// SPDX-License-Identifier: Apache-2.0
// What robots believe, drawn flat on the carpet: hypotheses as ellipses, ball with its way,
// opponents, obstacles, line points, and where who holds the ball aims.
import names from "kelpie:names";
import { flagAt, listAt, numberAt, numbersAt, structureAt } from "../reading/access";
import type { Structure } from "../reading/decoder";
import { MapFrame, fieldFromRobot, pointAt, poseAt, type Field, type Point } from "../model/field";
import type { RobotMoment } from "../model/moment";
import { TEAM_COLOURS } from "./robots";
import type { Ribbons } from "./ribbons";

export const LAYERS = {
  robots: "Robots as they are",
  ghosts: "Robots as they believe to be",
  names: "Names",
  hypotheses: "Hypotheses of the pose",
  ball: "Ball believed, its way",
  opponents: "Opponents believed",
  obstacles: "Obstacle map",
  points: "Line points seen",
  aim: "Aim and gap",
  wish: "Where it wants to go",
  frustum: "What its camera sees",
  arrows: "Direction of attack",
  shadows: "Shadows of the sun (slow)",
} as const;
export type Layer = keyof typeof LAYERS;

const BALL_COLOUR = 0xff8a1f;
const OBSTACLE_COLOUR = 0xd24dff;
const POINT_COLOURS = [0xfff27a, 0x9df0ff, 0x9dff9d];
const CELL = 10; // cm, side of a cell of the obstacle map (robot/core/types/ObstacleCells.h)
const FULL_CELL = 8; // points of a cell that is drawn without transparency

export function drawBeliefs(
  robot: RobotMoment,
  field: Field,
  on: ReadonlySet<Layer>,
  ink: Ribbons,
): void {
  const world = structureAt(robot.output, "world");
  if (!world) return;
  const map = new MapFrame(field, robot.team);
  if (on.has("obstacles")) obstacles(world, map, ink);
  if (on.has("hypotheses")) hypotheses(world, map, robot, ink);
  if (on.has("opponents")) opponents(world, map, robot, ink);
  if (on.has("points")) linePoints(robot, ink);
  if (on.has("ball")) ball(structureAt(world, "ball"), map, ink);
  if (on.has("aim")) aim(robot, map, field, ink);
  if (on.has("wish")) wish(robot, map, ink);
}

function hypotheses(world: Structure, map: MapFrame, robot: RobotMoment, ink: Ribbons): void {
  const colour = TEAM_COLOURS[robot.team];
  const modes = listAt(world, "modes");
  const shown =
    modes.length > 0
      ? modes
      : [{ weight: 1, pose: world["pose"]!, covariance: world["covariance"] ?? [] }];
  for (const mode of shown) {
    const own = poseAt(mode, "pose");
    if (!own) continue;
    const pose = map.pose(own);
    const c = numbersAt(mode, "covariance");
    const alpha = Math.min(1, 0.25 + (numberAt(mode, "weight") ?? 0));
    ink.ellipse(pose, c[0] ?? 0, c[1] ?? 0, c[4] ?? 0, 1.2, colour, alpha);
    ink.arrow(
      pose,
      { x: pose.x + 22 * Math.cos(pose.heading), y: pose.y + 22 * Math.sin(pose.heading) },
      1.6,
      colour,
      alpha,
    );
  }
}

function opponents(world: Structure, map: MapFrame, robot: RobotMoment, ink: Ribbons): void {
  const colour = TEAM_COLOURS[robot.team === 0 ? 1 : 0];
  for (const opponent of listAt(world, "opponents")) {
    const place = pointAt(opponent, "position");
    const c = numbersAt(opponent, "covariance");
    if (!place) continue;
    const middle = map.point(place);
    const faint = Math.max(0.25, 1 - (numberAt(opponent, "secondsSinceSeen") ?? 0) / 5);
    ink.ellipse(middle, c[0] ?? 0, c[1] ?? 0, c[3] ?? 0, 1.2, colour, faint);
    ink.ring(middle, 2, 1.6, colour, faint);
  }
}

function obstacles(world: Structure, map: MapFrame, ink: Ribbons): void {
  for (const cell of listAt(world, "obstacles")) {
    const place = pointAt(cell, "position");
    const points = (numberAt(cell, "own") ?? 0) + (numberAt(cell, "heard") ?? 0);
    if (place)
      ink.square(
        map.point(place),
        CELL - 1,
        OBSTACLE_COLOUR,
        Math.min(0.5, 0.08 + (0.5 * points) / FULL_CELL),
      );
  }
}

function linePoints(robot: RobotMoment, ink: Ribbons): void {
  const pose = robot.belief;
  if (!pose) return;
  for (const point of listAt(robot.output, "percepts.linePoints")) {
    const place = pointAt(point, "position");
    if (place)
      ink.square(
        fieldFromRobot(pose, place),
        2.2,
        POINT_COLOURS[numberAt(point, "kind") ?? 0] ?? 0xffffff,
        0.9,
      );
  }
}

function ball(believed: Structure | undefined, map: MapFrame, ink: Ribbons): void {
  const place = pointAt(believed, "position");
  if (!place || !flagAt(believed, "present")) return;
  const middle = map.point(place);
  const c = numbersAt(believed, "fieldCovariance");
  const faint = Math.max(0.3, 1 - (numberAt(believed, "secondsSinceSeen") ?? 0) / 6);
  ink.ellipse(middle, c[0] ?? 20, c[1] ?? 0, c[3] ?? 20, 1, BALL_COLOUR, faint);
  ink.ring(middle, names.numbers["kBallRadius"]!, 1.2, BALL_COLOUR, faint);
  const velocity = pointAt(believed, "velocity");
  const stop = pointAt(believed, "stoppingPoint");
  if (!velocity || Math.hypot(velocity.x, velocity.y) < 5) return;
  const way = map.direction(velocity);
  ink.arrow(middle, { x: middle.x + way.x, y: middle.y + way.y }, 1.6, BALL_COLOUR, faint);
  if (!stop) return;
  ink.dashes(middle, map.point(stop), 0.9, BALL_COLOUR, faint);
  ink.ring(map.point(stop), 3, 1, BALL_COLOUR, faint);
}

// Who has the ball in its hold looks for a gap in the goal's mouth: the wedge of the widest gap it
// sees, and the line to the middle of the opponents' goal, by its own pose.
function aim(robot: RobotMoment, map: MapFrame, field: Field, ink: Ribbons): void {
  const holds = names.enums["Grabs"]?.[numberAt(robot.output, "command.team.grabs") ?? 0];
  const pose = robot.truth ?? robot.belief;
  if (!pose || holds === undefined || holds === "no") return;
  const goal = map.point({ x: field.width / 2, y: field.length });
  ink.dashes(pose, goal, 1.2, 0xffffff, 0.8);
  for (const gap of listAt(robot.output, "percepts.gaps")) {
    const left = numberAt(gap, "left");
    const right = numberAt(gap, "right");
    if (left === undefined || right === undefined) continue;
    const away = Math.hypot(goal.x - pose.x, goal.y - pose.y);
    const at = (turn: number) => ({
      x: pose.x + away * Math.cos(pose.heading + turn),
      y: pose.y + away * Math.sin(pose.heading + turn),
    });
    ink.triangle(pose, at(left), at(right), 0x7dff8a, 0.35);
    ink.line(pose, at((left + right) / 2), 1.6, 0x7dff8a, 0.95);
  }
}

function wish(robot: RobotMoment, map: MapFrame, ink: Ribbons): void {
  const wanted = pointAt(robot.output, "command.team.wanted");
  const pose: Point | undefined = robot.truth ?? robot.belief;
  if (!wanted || !pose || !flagAt(robot.output, "command.team.wants")) return;
  const place = map.point(wanted);
  ink.dashes(pose, place, 0.8, TEAM_COLOURS[robot.team], 0.7);
  ink.ring(place, 4, 1, TEAM_COLOURS[robot.team], 0.9);
}
