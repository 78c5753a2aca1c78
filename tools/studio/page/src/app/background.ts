// SPDX-License-Identifier: Apache-2.0
// Asks the worker for the facts of all logs and gives them to the panels as they come.
import type { Answer, Question } from "../worker/protocol";
import type { SessionLog } from "../model/session";
import { addPlots } from "./plotting";
import type { Studio } from "./studio";

export type SeriesListener = (times: Float64Array, values: Float64Array, done: boolean) => void;

export class Background {
  factsDone = false;
  private readonly worker: Worker;
  private readonly series = new Map<number, SeriesListener>();
  private nextId = 0;
  onCompared: (times: number[], frames: number, onlyOne: number) => void = () => undefined;

  constructor(private readonly studio: Studio) {
    this.worker = new Worker(new URL("../worker/scan.ts", import.meta.url), { type: "module" });
    this.worker.addEventListener("message", (e: MessageEvent<Answer>) => this.take(e.data));
    this.worker.addEventListener("error", (e) =>
      studio.notes.say(`Decisions cannot be read in the background: ${e.message}`, "error"),
    );
  }

  ask(question: Question): void {
    this.worker.postMessage(question);
  }

  askSeries(log: number, topic: string, path: string, listener: SeriesListener): void {
    const id = ++this.nextId;
    this.series.set(id, listener);
    this.ask({ ask: "series", id, log, topic, path });
  }

  private take(answer: Answer): void {
    const { facts, lanes, timeLine, notes, transport } = this.studio;
    if (answer.is === "robotFacts") {
      facts.addRows(answer.robot, answer.chunk, answer.rows);
      facts.addMarks(answer.marks);
      lanes.redrawSoon();
    } else if (answer.is === "worldFacts") {
      facts.addMarks(answer.marks);
      facts.addPossession(answer.chunk, answer.possession);
      timeLine.redrawSoon();
    } else if (answer.is === "progress") {
      transport.showProgress(answer.done, answer.all);
      this.factsDone = answer.done === answer.all;
      timeLine.redrawSoon();
    } else if (answer.is === "series") {
      this.series.get(answer.id)?.(answer.times, answer.values, answer.done);
      if (answer.done) this.series.delete(answer.id);
    } else if (answer.is === "compared") {
      this.onCompared(answer.times, answer.frames, answer.onlyOne);
    } else notes.say(answer.sentence, "error");
  }
}

export function startFacts(studio: Studio, logs: SessionLog[], truthLog: number): Background {
  const background = new Background(studio);
  let near = studio.cursor.time;
  let busy = false;
  background.ask({
    ask: "facts",
    truthLog,
    near,
    logs: logs.map(({ url, bytes }) => ({ url: new URL(url, location.href).href, bytes })),
  });
  studio.cursor.onChange((time) => {
    const far = Math.abs(time - near) >= 2e6;
    if (background.factsDone || (!far && busy === studio.cursor.playing)) return;
    near = time;
    busy = studio.cursor.playing;
    background.ask({ ask: "near", time, busy });
  });
  addPlots(studio, background);
  studio.robotsChanged();
  return background;
}
