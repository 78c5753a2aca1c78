// SPDX-License-Identifier: Apache-2.0
// Reads whole logs in the background, so that the page stays quick: facts for lanes and time line,
// nearest to the cursor first, numbers for plots, and the comparison of two logs.
import { LogFile } from "../reading/logFile";
import { HttpFile } from "../reading/httpFile";
import { Decoder, Types, type Structure, type Wanted } from "../reading/decoder";
import { INPUT_TOPICS, OUTPUT_TOPIC, readConfig, robotKey, type LogConfig } from "../model/match";
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
  putPossession,
  type Mark,
  type Possession,
} from "../model/facts";
import type { Team } from "../model/field";
import type { Chunk, RawMessage } from "../reading/chunk";
import { compareLogs } from "./compare";
import { readSeries } from "./series";
import type { Answer, Question, WorkerLog } from "./protocol";

interface Task {
  log: number;
  chunk: number;
  from: number;
}

const FRAME_END = 33.4e3; // us, of a frame that is followed by another

const HOLD = 350; // ms after the cursor went elsewhere
const BUSY_PAUSE = 25;

const types = new Types();
const opened = new Map<number, Promise<LogFile>>();
const configs = new Map<number, LogConfig | undefined>();
const decoders = new Map<string, Decoder>();
let logs: WorkerLog[] = [];
let truthLog = -1;
let near = 0;
let pause = 0; // ms between two parts of a log
let holdUntil = 0; // while the page reads for itself
let tasks: Task[] = [];
let all = 0;

function tell(answer: Answer, parts: Transferable[] = []): void {
  self.postMessage(answer, { transfer: parts });
}

function open(place: number): Promise<LogFile> {
  let file = opened.get(place);
  if (!file) {
    const { url, bytes } = logs[place]!;
    opened.set(place, (file = LogFile.open(new HttpFile(url, bytes), types)));
  }
  return file;
}

function decoderOf(place: number, log: LogFile, topic: string, wanted: Wanted): Decoder {
  const key = `${place} ${topic}`;
  let decoder = decoders.get(key);
  if (!decoder) decoders.set(key, (decoder = new Decoder(log.typeOf(topic)!, wanted)));
  return decoder;
}

function messagesOf(log: LogFile, chunk: Chunk, topic: string): RawMessage[] {
  const channel = log.channels.get(topic);
  return (channel && chunk.messages.get(channel.id)) ?? [];
}

// The second log of the same robot, in a comparison, has a lane of its own.
function keyOf(place: number, team: Team, player: number): string {
  const key = robotKey(team, player);
  const before = [...configs].some(
    ([other, config]) => other < place && config?.team === team && config.player === player,
  );
  return before ? `${key} b` : key;
}

function robotFacts(place: number, log: LogFile, index: number, chunk: Chunk): void {
  const config = configs.get(place);
  if (!config) return;
  const { team, player } = config;
  const rows = emptyRows();
  const marks: Mark[] = [];
  const before = { ...NOTHING_BEFORE };
  const outputs = messagesOf(log, chunk, OUTPUT_TOPIC);
  const decoder =
    outputs.length > 0 ? decoderOf(place, log, OUTPUT_TOPIC, OUTPUT_WANTED) : undefined;
  outputs.forEach(({ time, bytes }, i) => {
    const output = decoder!.decode(bytes);
    addOutput(rows, output, time, outputs[i + 1]?.time ?? time + FRAME_END);
    marks.push(...outputMarks(output, time, team, player, before));
  });
  for (const topic of INPUT_TOPICS.slice(0, 2))
    for (const { time, bytes } of messagesOf(log, chunk, topic))
      marks.push(
        ...inputMarks(
          decoderOf(place, log, topic, INPUT_WANTED).decode(bytes),
          time,
          team,
          player,
          before,
        ),
      );
  tell({ is: "robotFacts", robot: keyOf(place, team, player), chunk: index, rows, marks });
}

function worldFacts(place: number, log: LogFile, index: number, chunk: Chunk): void {
  const possession: Possession[] = [];
  const truths = messagesOf(log, chunk, "/truth");
  truths.forEach(({ time, bytes }, i) => {
    const truth: Structure = decoderOf(place, log, "/truth", true).decode(bytes);
    putPossession(
      possession,
      time,
      truths[i + 1]?.time ?? time + 2 * FRAME_END,
      possessionOf(truth),
    );
  });
  const marks = messagesOf(log, chunk, "/event").map(({ time, bytes }) =>
    eventMark(decoderOf(place, log, "/event", true).decode(bytes), time),
  );
  tell({ is: "worldFacts", chunk: index, marks, possession });
}

async function work(task: Task): Promise<void> {
  const log = await open(task.log);
  const chunk = await log.chunk(task.chunk);
  robotFacts(task.log, log, task.chunk, chunk);
  if (task.log === truthLog) worldFacts(task.log, log, task.chunk, chunk);
}

function takeNearest(): Task {
  let best = 0;
  for (let i = 1; i < tasks.length; ++i)
    if (Math.abs(tasks[i]!.from - near) < Math.abs(tasks[best]!.from - near)) best = i;
  return tasks.splice(best, 1)[0]!;
}

async function readFacts(): Promise<void> {
  for (const place of logs.keys()) {
    try {
      const log = await open(place);
      configs.set(place, await readConfig(log));
      log.chunks.forEach((c, chunk) => tasks.push({ log: place, chunk, from: c.from }));
    } catch (error) {
      tell({ is: "failed", sentence: `Log ${place + 1} cannot be read: ${wordsOf(error)}` });
    }
  }
  all = tasks.length;
  while (tasks.length > 0) {
    const wait = Math.max(pause, holdUntil - performance.now());
    if (wait > 0) await new Promise((done) => setTimeout(done, wait));
    try {
      await work(takeNearest());
    } catch (error) {
      tell({ is: "failed", sentence: `A part of a log cannot be read: ${wordsOf(error)}` });
    }
    if (tasks.length % 8 === 0) tell({ is: "progress", done: all - tasks.length, all });
  }
}

function wordsOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

async function answer(question: Question): Promise<void> {
  if (question.ask === "near") {
    near = question.time;
    pause = question.busy ? BUSY_PAUSE : 0;
    holdUntil = performance.now() + HOLD;
  }
  if (question.ask === "facts") {
    ({ logs, truthLog, near } = question);
    await readFacts();
  }
  if (question.ask === "series")
    await readSeries(
      await open(question.log),
      question.topic,
      question.path,
      (times, values, done) =>
        tell({ is: "series", id: question.id, times, values, done }, [times.buffer, values.buffer]),
    );
  if (question.ask === "compare")
    tell({
      is: "compared",
      ...(await compareLogs(await open(question.a), await open(question.b))),
    });
}

self.addEventListener("message", (event: MessageEvent<Question>) => {
  answer(event.data).catch((error) => tell({ is: "failed", sentence: wordsOf(error) }));
});
