// SPDX-License-Identifier: Apache-2.0
// The match at one time: where each robot is and believes to be, how its joints stand, what it
// decided. Between two messages places and joints are interpolated. Parts that are not in memory
// yet, or that no log holds, are undefined.
import { flagAt, listAt, numberAt, numbersAt, structureAt } from "../reading/access";
import type { Structure } from "../reading/decoder";
import type { Around, Message, Stream } from "../reading/stream";
import { headTowards, type Stance } from "./body";
import {
  MapFrame,
  between,
  pointAt,
  poseAt,
  poseBetween,
  type Point,
  type Pose,
  type Team,
} from "./field";
import { robotKey, type Match, type RobotStreams } from "./match";

export interface RobotMoment {
  key: string;
  team: Team;
  player: number;
  truth: Pose | undefined;
  belief: Pose | undefined; // on the red team's field
  stance: Stance;
  joints: number[] | undefined;
  output: Structure | undefined;
  outputTime: number | undefined;
  input: Structure | undefined; // the last whole one
  inputTime: number | undefined;
  game: Structure | undefined;
}
export interface Moment {
  time: number; // us
  complete: boolean; // nothing is still being read
  robots: RobotMoment[];
  ball: Point | undefined;
  ballVelocity: Point | undefined;
  score: [number, number] | undefined; // red, blue
  game: Structure | undefined;
  believed: boolean; // the ball is a robot's belief, as no log holds the truth
}

const STANDING: Stance = { shoulderHeight: 11, bodyTilt: 0.1, bodyRoll: 0 };
const JOINT_GAP = 150e3; // us; further apart the joints between cannot be told
const AWAY = 2000; // cm; a ball so far off has been taken away
const STEP_PERIOD = 0.6; // s of a step of the walk that is drawn where no joints are kept

class Reading {
  complete = true;

  around(stream: Stream | undefined, time: number): Around {
    const found = stream?.around(time);
    if (stream && !found) this.complete = false;
    return found ?? { before: undefined, after: undefined };
  }
}

function shareOf(before: Message, after: Message, time: number): number {
  return after.time > before.time ? (time - before.time) / (after.time - before.time) : 0;
}

interface TrueRobot {
  team: Team;
  player: number;
  pose: Pose;
  stance: Stance;
}

function stanceOf(from: Structure | undefined): Stance | undefined {
  const height = numberAt(from, "shoulderHeight");
  if (height === undefined || height === 0) return undefined;
  return {
    shoulderHeight: height,
    bodyTilt: numberAt(from, "bodyTilt") ?? 0,
    bodyRoll: numberAt(from, "bodyRoll") ?? 0,
  };
}

function trueRobots(truth: Structure | undefined): TrueRobot[] {
  return listAt(truth, "robots").flatMap((robot) => {
    const pose = poseAt(robot, "pose");
    return pose
      ? [
          {
            team: numberAt(robot, "team") === 1 ? 1 : 0,
            player: numberAt(robot, "player") ?? 1,
            pose,
            stance: stanceOf(structureAt(robot, "stance")) ?? STANDING,
          } as TrueRobot,
        ]
      : [];
  });
}

// Robots that were carried jump rather than slide.
function truePose(now: TrueRobot, then: TrueRobot | undefined, share: number): Pose {
  const jump = then ? Math.hypot(then.pose.x - now.pose.x, then.pose.y - now.pose.y) : 0;
  return then && jump < 40 ? poseBetween(now.pose, then.pose, share) : now.pose;
}

function stanceBetween(a: Stance, b: Stance | undefined, share: number): Stance {
  return b
    ? {
        shoulderHeight: between(a.shoulderHeight, b.shoulderHeight, share),
        bodyTilt: between(a.bodyTilt, b.bodyTilt, share),
        bodyRoll: between(a.bodyRoll, b.bodyRoll, share),
      }
    : a;
}

function jointsOf(message: Message | undefined): number[] | undefined {
  const angles = numbersAt(message?.value, "sensors.joints.angle");
  return angles.some((angle) => angle !== 0) ? angles : undefined;
}

function latest(messages: (Message | undefined)[]): Message | undefined {
  return messages.reduce((a, b) => (!a || (b && b.time > a.time) ? b : a), undefined);
}
function earliest(messages: (Message | undefined)[]): Message | undefined {
  return messages.reduce((a, b) => (!a || (b && b.time < a.time) ? b : a), undefined);
}

interface Joints {
  angles: number[] | undefined;
  near: boolean; // of messages that lie close together
  before: Message | undefined; // the last whole input
  game: Structure | undefined;
}

function jointsAt(robot: RobotStreams, time: number, reading: Reading): Joints {
  const pairs = robot.inputs.map((stream) => reading.around(stream, time));
  const before = latest(pairs.map((p) => p.before).filter((m) => jointsOf(m)));
  const after = earliest(pairs.map((p) => p.after).filter((m) => jointsOf(m)));
  const game = structureAt(latest(pairs.map((p) => p.before))?.value, "game");
  const from = jointsOf(before);
  const to = jointsOf(after);
  if (!before || !from || !after || !to) return { angles: from ?? to, near: false, before, game };
  const share = shareOf(before, after, time);
  const angles = from.map((angle, i) => between(angle, to[i] ?? angle, share));
  return { angles, near: after.time - before.time < JOINT_GAP, before, game };
}

// A trot by the time, where the joints of most frames are not kept: diagonal legs together.
function walking(joints: number[], time: number, speed: number, turn: number): number[] {
  const stride = Math.min(0.35, 0.012 * speed + 0.08 * Math.abs(turn));
  if (stride < 0.04) return joints;
  const phase = (2 * Math.PI * time) / 1e6 / STEP_PERIOD;
  const moved = joints.slice();
  for (let leg = 0; leg < 4; ++leg) {
    const swing = phase + (leg === 0 || leg === 3 ? 0 : Math.PI);
    moved[4 + 3 * leg] = (moved[4 + 3 * leg] ?? 0) + stride * Math.sin(swing);
    moved[6 + 3 * leg] = (moved[6 + 3 * leg] ?? 0) + stride * Math.max(0, Math.cos(swing));
  }
  return moved;
}

function poseOfOutput(output: Structure | undefined, map: MapFrame | undefined) {
  const pose = poseAt(output, "world.pose");
  return pose && map ? map.pose(pose) : undefined;
}

function shownJoints(
  joints: Joints,
  output: Structure | undefined,
  stance: Stance,
  time: number,
): number[] | undefined {
  if (!joints.angles || joints.near) return joints.angles;
  const axes = numbersAt(output, "body.camera.axes");
  const looked = axes.some((a) => a !== 0)
    ? headTowards(joints.angles, stance, axes)
    : joints.angles;
  if ((numberAt(output, "command.motion") ?? 0) !== 0) return looked;
  const speed = Math.hypot(
    numberAt(output, "command.walk.forward") ?? 0,
    numberAt(output, "command.walk.left") ?? 0,
  );
  return walking(looked, time, speed, numberAt(output, "command.walk.turn") ?? 0);
}

function robotAt(
  robot: RobotStreams,
  map: MapFrame | undefined,
  time: number,
  reading: Reading,
): RobotMoment {
  const { before, after } = reading.around(robot.output, time);
  const output = before?.value;
  const here = poseOfOutput(output, map);
  const there = poseOfOutput(after?.value, map);
  const near = here && there && Math.hypot(here.x - there.x, here.y - there.y) < 20;
  const belief =
    here && near && before && after ? poseBetween(here, there, shareOf(before, after, time)) : here;
  const joints = jointsAt(robot, time, reading);
  const stance = stanceOf(structureAt(joints.before?.value, "stance")) ?? STANDING;
  return {
    key: robot.key,
    team: robot.team,
    player: robot.player,
    truth: undefined,
    belief,
    stance,
    joints: shownJoints(joints, output, stance, time),
    output,
    outputTime: before?.time,
    input: joints.before?.value,
    inputTime: joints.before?.time,
    game: joints.game,
  };
}

function withTruth(robots: RobotMoment[], truth: Around, share: number): RobotMoment[] {
  const now = trueRobots(truth.before?.value ?? truth.after?.value);
  const then = trueRobots(truth.after?.value);
  for (const robot of now) {
    const key = robotKey(robot.team, robot.player);
    const next = then.find((r) => r.team === robot.team && r.player === robot.player);
    let shown = robots.find((r) => r.key === key);
    if (!shown) robots.push((shown = unlogged(key, robot)));
    shown.truth = truePose(robot, next, share);
    shown.stance = stanceBetween(robot.stance, next?.stance, share);
  }
  return robots;
}

function unlogged(key: string, robot: TrueRobot): RobotMoment {
  return {
    key,
    team: robot.team,
    player: robot.player,
    truth: undefined,
    belief: undefined,
    stance: robot.stance,
    joints: undefined,
    output: undefined,
    outputTime: undefined,
    input: undefined,
    inputTime: undefined,
    game: undefined,
  };
}

interface ShownBall {
  ball: Point | undefined;
  velocity: Point | undefined;
  believed: boolean;
}

function ballOf(truth: Around, share: number): ShownBall | undefined {
  const now = pointAt((truth.before ?? truth.after)?.value, "ball");
  const then = pointAt(truth.after?.value, "ball");
  const velocity = pointAt((truth.before ?? truth.after)?.value, "ballVelocity");
  if (!now) return undefined;
  if (Math.hypot(now.x, now.y) > AWAY) return { ball: undefined, velocity, believed: false };
  const near = then && Math.hypot(then.x - now.x, then.y - now.y) < 80;
  const ball = near ? { x: between(now.x, then.x, share), y: between(now.y, then.y, share) } : now;
  return { ball, velocity, believed: false };
}

// The ball of the robot that saw it last.
function believedBall(robots: RobotMoment[], match: Match): ShownBall {
  let best: ShownBall = { ball: undefined, velocity: undefined, believed: true };
  let age = Infinity;
  for (const robot of robots) {
    const ball = structureAt(robot.output, "world.ball");
    const place = pointAt(ball, "position");
    const unseen = numberAt(ball, "secondsSinceSeen") ?? Infinity;
    if (!match.field || !place || !flagAt(ball, "present") || unseen >= age) continue;
    const map = new MapFrame(match.field, robot.team);
    const velocity = pointAt(ball, "velocity");
    age = unseen;
    best = {
      ball: map.point(place),
      velocity: velocity && map.direction(velocity),
      believed: true,
    };
  }
  return best;
}

function scoreOf(truth: Around, game: Structure | undefined, team: Team | undefined) {
  const red = numberAt((truth.before ?? truth.after)?.value, "redScore");
  const blue = numberAt((truth.before ?? truth.after)?.value, "blueScore");
  if (red !== undefined && blue !== undefined) return [red, blue] as [number, number];
  const own = numberAt(game, "ownScore");
  const other = numberAt(game, "opponentScore");
  if (own === undefined || other === undefined) return undefined;
  return (team === 1 ? [other, own] : [own, other]) as [number, number];
}

export function momentAt(match: Match, time: number): Moment {
  const reading = new Reading();
  const robots = match.robots.map((robot) =>
    robotAt(robot, match.field && new MapFrame(match.field, robot.team), time, reading),
  );
  const truth = reading.around(match.truth, time);
  const share = truth.before && truth.after ? shareOf(truth.before, truth.after, time) : 0;
  withTruth(robots, truth, share);
  robots.sort((a, b) => a.team - b.team || a.player - b.player);
  const { ball, velocity, believed } = ballOf(truth, share) ?? believedBall(robots, match);
  const speaker = robots.find((r) => r.game);
  return {
    time,
    complete: reading.complete,
    robots,
    ball,
    ballVelocity: velocity,
    believed,
    score: scoreOf(truth, speaker?.game, speaker?.team),
    game: speaker?.game,
  };
}

// Reads what a moment needs.
export async function loadMoment(match: Match, time: number): Promise<void> {
  const streams = [match.truth, ...match.robots.flatMap((r) => [r.output, ...r.inputs])];
  await Promise.all(streams.map((stream) => stream?.load(time)));
}
