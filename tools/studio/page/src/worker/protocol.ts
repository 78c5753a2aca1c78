// SPDX-License-Identifier: Apache-2.0
// What the page asks the worker that reads whole logs in the background, and what that answers.
import type { Mark, Possession, Rows } from "../model/facts";

export interface WorkerLog {
  url: string;
  bytes: number;
}
export type Question =
  | { ask: "facts"; logs: WorkerLog[]; truthLog: number; near: number }
  | { ask: "near"; time: number; busy: boolean } // busy: the page needs the machine
  | { ask: "series"; id: number; log: number; topic: string; path: string }
  | { ask: "compare"; a: number; b: number };

export type Answer =
  | { is: "robotFacts"; robot: string; chunk: number; rows: Rows; marks: Mark[] }
  | { is: "worldFacts"; chunk: number; marks: Mark[]; possession: Possession[] }
  | { is: "progress"; done: number; all: number }
  | { is: "series"; id: number; times: Float64Array; values: Float64Array; done: boolean }
  | { is: "compared"; times: number[]; frames: number; onlyOne: number }
  | { is: "failed"; sentence: string };
