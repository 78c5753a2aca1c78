// SPDX-License-Identifier: Apache-2.0
// Which robots a match has and where their messages come from, of recorded logs or of one that is
// being played. What a log lacks is said in sentences; nothing that lacks stops the page.
import { numberAt } from "../reading/access";
import { Decoder, type MemberType } from "../reading/decoder";
import type { LogFile } from "../reading/logFile";
import type { Stream } from "../reading/stream";
import { TEAM_NAMES, fieldOf, type Field, type Team } from "./field";

export const INPUT_TOPICS = ["/frame/input", "/frame/plane", "/frame/picture"] as const;
export const OUTPUT_TOPIC = "/frame/output";

export interface RobotStreams {
  key: string; // "red-2"
  team: Team;
  player: number;
  log: number; // place among the session's logs; -1: live
  inputs: Stream[];
  output: Stream | undefined;
}
export interface Match {
  robots: RobotStreams[];
  truth: Stream | undefined;
  event: Stream | undefined;
  truthLog: number;
  field: Field | undefined;
  from: number; // us
  to: number;
  notes: string[];
}

export function robotKey(team: Team, player: number): string {
  return `${TEAM_NAMES[team]}-${player}`;
}

const CONFIG_WANTED = { team: true, player: true, field: true } as const;

export interface LogConfig {
  team: Team;
  player: number;
  field: Field | undefined;
}

export function configOf(type: MemberType, bytes: Uint8Array): LogConfig {
  const config = new Decoder(type, CONFIG_WANTED).decode(bytes);
  return {
    team: numberAt(config, "team") === 1 ? 1 : 0,
    player: numberAt(config, "player") ?? 1,
    field: fieldOf(config),
  };
}

// The configuration stands at the beginning of a log; undefined where it is not there.
export async function readConfig(log: LogFile): Promise<LogConfig | undefined> {
  const channel = log.channels.get("/config");
  const type = log.typeOf("/config");
  const first = log.chunks.findIndex((c) => channel && c.channels.has(channel.id));
  if (!channel || !type || first < 0) return undefined;
  const message = (await log.chunk(first)).messages.get(channel.id)?.[0];
  return message && configOf(type, message.bytes);
}

export function robotOf(log: LogFile, config: LogConfig, place: number): RobotStreams {
  return {
    key: robotKey(config.team, config.player),
    team: config.team,
    player: config.player,
    log: place,
    inputs: INPUT_TOPICS.flatMap((topic) => log.stream(topic) ?? []),
    output: log.stream(OUTPUT_TOPIC),
  };
}

export interface OpenLog {
  name: string;
  place: number;
  file: LogFile;
  config: LogConfig | undefined;
}

// The match of several logs: the world's truth is that of the first log that holds it.
export function matchOf(logs: OpenLog[]): Match {
  const withTruth = logs.find((log) => log.file.channels.has("/truth"));
  const robots = logs
    .filter(
      (log) =>
        log.file.channels.has(OUTPUT_TOPIC) ||
        INPUT_TOPICS.some((topic) => log.file.channels.has(topic)),
    )
    .flatMap((log) => (log.config ? [robotOf(log.file, log.config, log.place)] : []))
    .sort((a, b) => a.team - b.team || a.player - b.player);
  return {
    robots,
    truth: withTruth?.file.stream("/truth"),
    event: logs.find((log) => log.file.channels.has("/event"))?.file.stream("/event"),
    truthLog: withTruth?.place ?? -1,
    field: logs.find((log) => log.config?.field)?.config?.field,
    from: Math.min(...logs.map((log) => log.file.from)),
    to: Math.max(...logs.map((log) => log.file.to)),
    notes: lacksOf(logs),
  };
}

function lacksOf(logs: OpenLog[]): string[] {
  const notes: string[] = [];
  if (!logs.some((log) => log.file.channels.has("/truth")))
    notes.push(
      "No log says what really happened: robots and ball are drawn where they are " +
        "believed to be.",
    );
  for (const log of logs) notes.push(...lacksOfOne(log));
  return notes;
}

const USED: Record<string, string> = {
  "world.pose": "where the robot believes to be",
  "world.ball": "the ball it believes in",
  "command.trace": "the reasons of its decisions",
  "body.camera": "its camera",
};

function lacksOfOne({ name, file, config }: OpenLog): string[] {
  const hasTruth = file.channels.has("/truth");
  if (!config && !hasTruth) return [`${name} does not say whose log it is.`];
  const type = file.typeOf(OUTPUT_TOPIC);
  if (!type) return config ? [`${name} holds no outputs: no beliefs and no decisions.`] : [];
  const missing = Object.keys(USED).filter((path) => !hasMember(type, path));
  const notes =
    missing.length > 0
      ? [`${name} is of another version and lacks ${missing.map((m) => USED[m]).join(", ")}.`]
      : [];
  if (!INPUT_TOPICS.some((topic) => file.channels.has(topic)))
    notes.push(`${name} holds no inputs: no joints and no camera.`);
  return notes;
}

export function hasMember(type: MemberType, path: string): boolean {
  let members = type.members;
  for (const name of path.split(".")) {
    const member = members?.find((m) => m.name === name);
    if (!member) return false;
    members = member.type.members;
  }
  return true;
}
