// SPDX-License-Identifier: Apache-2.0
// A match that is being played, as the messages come: robots appear with their configuration, and
// facts for lanes and time line are made of every message at once. Times are those of the match,
// which stand in the messages: the server's own clock is another.
import { Decoder, typeOf, type Wanted } from "../reading/decoder";
import type { LiveChannel } from "../reading/liveLink";
import { RingStream } from "../reading/ringStream";
import {
  INPUT_WANTED,
  NOTHING_BEFORE,
  OUTPUT_WANTED,
  addOutput,
  emptyRows,
  eventMark,
  inputMarks,
  outputMarks,
  possessionOf,
  type Before,
} from "./facts";
import type { FactStore } from "./factStore";
import {
  INPUT_TOPICS,
  OUTPUT_TOPIC,
  configOf,
  robotKey,
  type LogConfig,
  type Match,
  type RobotStreams,
} from "./match";

const PREFIX = "/live/";
export const LINE_TOPIC = "/live/log";
const FRAME = 33.4e3; // us
const INPUT_BYTES = 40e6; // of each robot: some hundred images

// "/live/red-1/frame/output" -> ["red-1", "/frame/output"].
export function partsOf(topic: string): [string, string] | undefined {
  const rest = topic.startsWith(PREFIX) ? topic.slice(PREFIX.length) : "";
  const slash = rest.indexOf("/");
  return slash > 0 ? [rest.slice(0, slash), rest.slice(slash)] : undefined;
}

export function wantedTopic(topic: string): boolean {
  const name = partsOf(topic)?.[1] ?? "";
  return (
    topic === LINE_TOPIC ||
    name === "/config" ||
    name === OUTPUT_TOPIC ||
    name === "/truth" ||
    name === "/event" ||
    (INPUT_TOPICS as readonly string[]).includes(name)
  );
}

interface Source {
  config: LogConfig | undefined;
  streams: Map<string, RingStream>;
  before: Before;
}

export class LiveMatch {
  readonly match: Match = {
    robots: [],
    truth: undefined,
    event: undefined,
    truthLog: -1,
    field: undefined,
    from: 0,
    to: 0,
    notes: [],
  };
  onRobots: () => void = () => undefined;
  onField: () => void = () => undefined;
  onLine: (line: string) => void = () => undefined;
  private readonly sources = new Map<string, Source>();
  private readonly decoders = new Map<string, Decoder>();
  private number = 0; // of the next piece of facts
  private begun = false;

  constructor(private readonly facts: FactStore) {}

  addChannel(channel: LiveChannel): void {
    const parts = partsOf(channel.topic);
    if (!parts || channel.encoding !== "ros1" || parts[1] === "/config") return;
    const [name, topic] = parts;
    const source = this.source(name);
    if (source.streams.has(topic)) return;
    const bytes = topic.startsWith("/frame/") && topic !== OUTPUT_TOPIC ? INPUT_BYTES : 24e6;
    const stream = new RingStream(topic, typeOf(channel.schema), bytes);
    source.streams.set(topic, stream);
    if (topic === "/truth") this.match.truth = stream;
    if (topic === "/event") this.match.event = stream;
    this.addRobot(name);
  }

  private source(name: string): Source {
    let source = this.sources.get(name);
    if (!source)
      this.sources.set(
        name,
        (source = { config: undefined, streams: new Map(), before: { ...NOTHING_BEFORE } }),
      );
    return source;
  }

  addMessage(channel: LiveChannel, bytes: Uint8Array): void {
    if (channel.topic === LINE_TOPIC) return this.addLine(bytes);
    const parts = partsOf(channel.topic);
    if (!parts) return;
    const [name, topic] = parts;
    const source = this.source(name);
    if (topic === "/config") return this.addConfig(name, channel, bytes);
    const stream = source.streams.get(topic);
    const time = stream && this.timeOf(stream, bytes);
    if (!stream || time === undefined) return;
    stream.add(time, bytes);
    this.match.from = this.begun ? Math.min(this.match.from, time) : time;
    this.begun = true;
    this.match.to = Math.max(this.match.to, time);
    this.addFacts(source, topic, stream, bytes, time);
    if (++this.number % 2000 === 0) this.forget();
  }

  private addLine(bytes: Uint8Array): void {
    try {
      const line = JSON.parse(new TextDecoder().decode(bytes)) as { line?: string };
      if (line.line) this.onLine(line.line);
    } catch {
      this.onLine("A line of the match cannot be read.");
    }
  }

  private addConfig(name: string, channel: LiveChannel, bytes: Uint8Array): void {
    const source = this.source(name);
    source.config = configOf(typeOf(channel.schema), bytes);
    if (!this.match.field && source.config.field) {
      this.match.field = source.config.field;
      this.onField();
    }
    this.addRobot(name);
  }

  // Known when its configuration has come; its streams may come before or later.
  private addRobot(name: string): void {
    const { config, streams } = this.source(name);
    if (!config) return;
    const robot: RobotStreams = {
      key: robotKey(config.team, config.player),
      team: config.team,
      player: config.player,
      log: -1,
      inputs: INPUT_TOPICS.flatMap((topic) => streams.get(topic) ?? []),
      output: streams.get(OUTPUT_TOPIC),
    };
    this.match.robots = [...this.match.robots.filter((r) => r.key !== robot.key), robot].sort(
      (a, b) => a.team - b.team || a.player - b.player,
    );
    this.onRobots();
  }

  private decoder(stream: RingStream, wanted: Wanted, use: string): Decoder {
    const key = `${use} ${stream.topic}`;
    let decoder = this.decoders.get(key);
    if (!decoder || !sameType(decoder, stream))
      this.decoders.set(key, (decoder = new Decoder(stream.type, wanted)));
    return decoder;
  }

  private timeOf(stream: RingStream, bytes: Uint8Array): number | undefined {
    const time = this.decoder(stream, { time: true }, "time").decode(bytes)["time"];
    return typeof time === "number" ? time : undefined;
  }

  private addFacts(
    source: Source,
    topic: string,
    stream: RingStream,
    bytes: Uint8Array,
    time: number,
  ): void {
    const decode = (wanted: Wanted) => this.decoder(stream, wanted, "facts").decode(bytes);
    if (topic === "/event") this.facts.addMarks([eventMark(decode(true), time)]);
    if (topic === "/truth")
      this.facts.addPossession(this.number, [
        { from: time, to: time + 2 * FRAME, team: possessionOf(decode(true)) },
      ]);
    const robot = source.config;
    if (!robot) return;
    if (topic === OUTPUT_TOPIC) {
      const output = decode(OUTPUT_WANTED);
      const rows = emptyRows();
      addOutput(rows, output, time, time + FRAME);
      this.facts.appendRows(robotKey(robot.team, robot.player), rows);
      this.facts.addMarks(outputMarks(output, time, robot.team, robot.player, source.before));
    } else if (topic === "/frame/input") {
      this.facts.addMarks(
        inputMarks(decode(INPUT_WANTED), time, robot.team, robot.player, source.before),
      );
    }
  }

  private forget(): void {
    const oldest = Math.min(...this.match.robots.map((r) => r.output?.from ?? Infinity));
    if (!Number.isFinite(oldest)) return;
    this.match.from = oldest;
    this.facts.forgetBefore(oldest);
  }
}

function sameType(decoder: Decoder, stream: RingStream): boolean {
  return decoder.type === stream.type;
}
