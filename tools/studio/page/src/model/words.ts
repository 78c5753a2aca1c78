// SPDX-License-Identifier: Apache-2.0
// Decisions and calls as sentences. Numbers of a reason stand in for its {} as a person wants to
// know them; where one is missing stands a question mark.
import names from "kelpie:names";
import { flagAt, listAt, numberAt, numbersAt, textAt } from "../reading/access";
import type { Structure } from "../reading/decoder";
import { TEAM_NAMES } from "./field";

export interface Decision {
  layer: string;
  module: string;
  branch: string;
  reason: string; // with its numbers
  pattern: string; // without
}

// 83.4 -> "83", 8.26 -> "8.3", 0.127 -> "0.13".
export function shortNumber(value: number): string {
  const size = Math.abs(value);
  const decimals = size >= 9.95 ? 0 : size >= 0.995 ? 1 : 2;
  const text = value.toFixed(decimals);
  const short = decimals > 0 ? text.replace(/\.?0+$/, "") : text;
  return short === "-0" ? "0" : short;
}

export function reasonOf(pattern: string, numbers: number[]): string {
  let next = 0;
  return pattern.replace(/\{\}/g, () => {
    const value = numbers[next++];
    return value === undefined ? "?" : shortNumber(value);
  });
}

export function decisionsOf(command: Structure | undefined): Decision[] {
  return listAt(command, "trace").map((step) => {
    const pattern = textAt(step, "reason");
    return {
      layer: names.enums["TraceLayer"]![numberAt(step, "layer") ?? 0] ?? "skill",
      module: textAt(step, "module").split(" ")[0]!,
      branch: textAt(step, "branch"),
      reason: reasonOf(pattern, numbersAt(step, "numbers")),
      pattern,
    };
  });
}

export function sentenceOf(decision: Decision): string {
  const who = `The ${decision.layer}${decision.module ? ` ${decision.module}` : ""}`;
  const why = decision.reason ? `: ${decision.reason}` : "";
  return `${who} chose ${decision.branch || "?"}${why}.`;
}

const FALLBACKS: Record<string, string> = {
  notLoaded: "The behaviours did not load.",
  scriptError: "The behaviours stopped with an error.",
  badCommand: "The behaviours' Command could not be used.",
  timeLimit: "The behaviours took too long.",
};

// Who decided in place of the behaviours; empty where they did.
export function fallbackOf(command: Structure | undefined): string {
  const name = names.enums["Fallback"]![numberAt(command, "fallback") ?? 0] ?? "none";
  return name === "none" ? "" : (FALLBACKS[name] ?? "The behaviours failed.");
}

export function motionName(number: number | undefined): string {
  return names.motions[number ?? 0]?.name ?? "unknown";
}

export function motionUse(number: number | undefined): string {
  return names.motions[number ?? 0]?.use ?? "rest";
}

export function roleName(number: number | undefined): string {
  return names.enums["Role"]![number ?? 0] ?? "none";
}

// What the legs do: a special motion's name, or how the robot walks.
export function legsOf(command: Structure | undefined): string {
  const motion = numberAt(command, "motion") ?? 0;
  if (motion !== 0) return motionName(motion);
  const forward = numberAt(command, "walk.forward") ?? 0;
  const left = numberAt(command, "walk.left") ?? 0;
  const turn = numberAt(command, "walk.turn") ?? 0;
  if (Math.hypot(forward, left) > 2)
    return forward < -2 && Math.abs(left) < -forward
      ? "walk back"
      : Math.abs(left) > Math.abs(forward)
        ? "walk aside"
        : "walk";
  return Math.abs(turn) > 0.1 ? "turn" : "stand";
}

export function eventKind(event: Structure): string {
  return names.enums["EventKind"]![numberAt(event, "kind") ?? -1] ?? "unknown";
}

export function robotWords(team: number, player: number): string {
  return `${TEAM_NAMES[team === 1 ? 1 : 0]} ${player}`;
}

export function eventSentence(event: Structure): string {
  const reason = textAt(event, "reason");
  const what = eventWords(event, reason);
  return what + (reason === "" || reason === "own goal" ? "." : `: ${reason}.`);
}

function eventWords(event: Structure, reason: string): string {
  const team = TEAM_NAMES[numberAt(event, "team") === 1 ? 1 : 0];
  const player = numberAt(event, "player") ?? 0;
  const robot = `${team} ${player}`;
  switch (eventKind(event)) {
    case "start":
      return "The match begins";
    case "goal":
      return reason === "own goal"
        ? `Own goal for ${team}`
        : `Goal of ${team}${player > 0 ? ` by player ${player}` : ""}`;
    case "out":
      return `The ball is out${player > 0 ? `, touched last by ${robot}` : ""}`;
    case "end":
      return "The match is over";
    case "ready":
      return `Ready for the kick-off of ${team}`;
    case "set":
      return "Set: all stand where they may";
    case "play":
      return "Play";
    case "half":
      return "The first half is over";
    case "penalty":
      return `${robot} is taken off`;
    case "back":
      return `${robot} comes back`;
    case "stuck":
      return "The ball is put elsewhere";
    case "placed":
      return `${robot} is put where it may stand`;
    case "taken":
      return "Somebody takes the ball away";
    case "returned":
      return "The ball is back";
    case "carried":
      return `${robot} is carried elsewhere`;
    default:
      return "An unknown event";
  }
}

export function stateName(game: Structure | undefined): string {
  if (flagAt(game, "penalised")) return "penalised";
  return names.enums["PlayState"]![numberAt(game, "state") ?? -1] ?? "unknown";
}

// "1:05" of seconds or, with tenths, "1:05.3".
export function clockOf(seconds: number, tenths = false): string {
  const whole = Math.max(0, tenths ? Math.floor(seconds * 10) / 10 : Math.floor(seconds));
  const minutes = Math.floor(whole / 60);
  const rest = whole - 60 * minutes;
  const text = tenths ? rest.toFixed(1).padStart(4, "0") : String(rest).padStart(2, "0");
  return `${minutes}:${text}`;
}
