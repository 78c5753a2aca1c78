// SPDX-License-Identifier: Apache-2.0
// What lanes and time line show of a log: segments in which a robot decided the same, and marks.
// Made chunk by chunk in any order, from the few members that are needed.
import names from "kelpie:names";
import { numberAt, structureAt } from "../reading/access";
import type { Structure, Wanted } from "../reading/decoder";
import type { Team } from "./field";
import {
  decisionsOf,
  eventKind,
  eventSentence,
  fallbackOf,
  legsOf,
  motionName,
  motionUse,
  robotWords,
  roleName,
  sentenceOf,
  type Decision,
} from "./words";

export const ROWS = ["role", "player", "skill", "motion"] as const;
export type Row = (typeof ROWS)[number];
export interface Segment {
  from: number; // us
  to: number;
  label: string;
  why: string; // a sentence, of its first frame
}
export type Rows = Record<Row, Segment[]>;
export const MARKS = ["goal", "kick", "grab", "referee", "fall", "carry", "error"] as const;
export type MarkKind = (typeof MARKS)[number];
export interface Mark {
  time: number;
  kind: MarkKind;
  team: Team | -1;
  text: string;
}
export interface Possession {
  from: number;
  to: number;
  team: Team | -1;
}

export const OUTPUT_WANTED: Wanted = {
  command: { walk: true, motion: true, team: { role: true }, fallback: true, trace: true },
};
export const INPUT_WANTED: Wanted = { motion: { running: true, feeling: true } };

export function emptyRows(): Rows {
  return { role: [], player: [], skill: [], motion: [] };
}

const NEXT_FRAME = 120e3; // us; further apart two frames do not touch

function put(list: Segment[], time: number, end: number, label: string, why: string): void {
  const last = list[list.length - 1];
  if (last && last.label === label && time - last.to < NEXT_FRAME) last.to = end;
  else list.push({ from: time, to: end, label, why });
}

function lineOf(decision: Decision | undefined): string {
  return decision ? `${decision.module}: ${decision.branch}` : "";
}

// One frame's output, of a robot.
export function addOutput(rows: Rows, output: Structure, time: number, end: number): void {
  const command = structureAt(output, "command");
  const trace = decisionsOf(command);
  const instead = fallbackOf(command);
  const player = trace.find((d) => d.layer === "player");
  const skills = trace.filter((d) => d.layer === "skill");
  const skill = skills[0] ?? trace[trace.length - 1];
  const role = roleName(numberAt(command, "team.role"));
  const roleStep = trace.find((d) => d.layer === "role");
  const why = (d: Decision | undefined) => instead || (d ? sentenceOf(d) : "No reason is given.");
  const whole = trace.map(sentenceOf).join(" ") || instead || "No reason is given.";
  put(rows.role, time, end, role, roleStep ? why(roleStep) : why(player));
  put(rows.player, time, end, instead ? "fallback" : (player?.branch ?? ""), why(player));
  put(rows.skill, time, end, instead ? "fallback" : lineOf(skill), whole);
  const legs = legsOf(command);
  put(rows.motion, time, end, legs, `The legs ${legs.includes("_") ? "play " : ""}${legs}.`);
}

export interface Before {
  motion: number;
  fallback: string;
  fallen: number;
}
export const NOTHING_BEFORE: Before = { motion: 0, fallback: "", fallen: 0 };

const MARK_OF_USE: Record<string, MarkKind> = { kick: "kick", grab: "grab" };

// Marks of what begins in this frame: kicks, grabs, errors of the script.
export function outputMarks(
  output: Structure,
  time: number,
  team: Team,
  player: number,
  before: Before,
): Mark[] {
  const command = structureAt(output, "command");
  const motion = numberAt(command, "motion") ?? 0;
  const fallback = fallbackOf(command);
  const who = robotWords(team, player);
  const marks: Mark[] = [];
  const kind = MARK_OF_USE[motionUse(motion)];
  if (kind && motion !== before.motion)
    marks.push({ time, kind, team, text: `${who}: ${motionName(motion)}` });
  if (fallback !== "" && fallback !== before.fallback)
    marks.push({ time, kind: "error", team, text: `${who}: ${fallback}` });
  before.motion = motion;
  before.fallback = fallback;
  return marks;
}

export function inputMarks(
  input: Structure,
  time: number,
  team: Team,
  player: number,
  before: Before,
): Mark[] {
  const fallen = numberAt(input, "motion.feeling.fallen") ?? 0;
  const side = names.enums["FallSide"]![fallen] ?? "";
  const marks: Mark[] =
    fallen !== 0 && before.fallen === 0
      ? [{ time, kind: "fall", team, text: `${robotWords(team, player)} has fallen: ${side}` }]
      : [];
  before.fallen = fallen;
  return marks;
}

export function eventMark(event: Structure, time: number): Mark {
  const kind = eventKind(event);
  const mark: MarkKind =
    kind === "goal"
      ? "goal"
      : kind === "carried" || kind === "taken" || kind === "returned"
        ? "carry"
        : "referee";
  const team = numberAt(event, "team");
  const ofTeam = kind === "goal" || kind === "penalty" || kind === "back" || kind === "ready";
  return { time, kind: mark, team: ofTeam ? (team === 1 ? 1 : 0) : -1, text: eventSentence(event) };
}

const REACH = 30; // cm from the neck's base, within which a robot has the ball

// Whose robot is nearest to the ball, and near enough to play it.
export function possessionOf(truth: Structure): Team | -1 {
  const x = numberAt(truth, "ball.x") ?? 1e6;
  const y = numberAt(truth, "ball.y") ?? 1e6;
  let best = REACH;
  let team: Team | -1 = -1;
  for (const robot of (truth["robots"] ?? []) as Structure[]) {
    const away = Math.hypot(
      (numberAt(robot, "pose.position.x") ?? 0) - x,
      (numberAt(robot, "pose.position.y") ?? 0) - y,
    );
    if (away < best) (best = away), (team = numberAt(robot, "team") === 1 ? 1 : 0);
  }
  return team;
}

export function putPossession(
  list: Possession[],
  time: number,
  end: number,
  team: Team | -1,
): void {
  const last = list[list.length - 1];
  if (last && last.team === team && time - last.to < 400e3) last.to = end;
  else list.push({ from: time, to: end, team });
}
