// SPDX-License-Identifier: Apache-2.0
// Play, steps, speed and zoom of the time, as buttons.
import { button, make, text } from "../app/dom";
import { icon } from "../app/icons";
import { FRAME_US, type Cursor } from "../app/cursor";
import type { TimeAxis } from "../app/timeAxis";
import { clockOf } from "../model/words";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4, 8];

export class Transport {
  readonly element: HTMLElement;
  readonly end = make("div", { class: "end" });
  private readonly playing: HTMLButtonElement;
  private readonly time = make("output", { class: "time", "aria-label": "Time" });
  private shownPlaying = false;
  private readonly progress = make("span", { class: "progress" });

  constructor(
    private readonly cursor: Cursor,
    axis: TimeAxis,
    step: (forward: boolean) => void,
  ) {
    this.playing = button(icon("play"), "Play (space)", () => cursor.play(), "main");
    const speed = make(
      "select",
      { "aria-label": "Speed", title: "Speed" },
      ...SPEEDS.map((s) => make("option", { value: String(s), selected: s === 1 }, `${s}×`)),
    );
    speed.addEventListener("change", () => (cursor.speed = Number(speed.value)));
    this.element = make(
      "div",
      { class: "transport", role: "toolbar", "aria-label": "Time" },
      button(icon("first"), "To the beginning (Home)", () => cursor.seek(cursor.from)),
      button(icon("back"), "A second or event back ([)", () => step(false)),
      button(icon("frameBack"), "A frame back (left arrow)", () =>
        cursor.seek(cursor.time - FRAME_US),
      ),
      this.playing,
      button(icon("frameOn"), "A frame on (right arrow)", () =>
        cursor.seek(cursor.time + FRAME_US),
      ),
      button(icon("on"), "A second or event on (])", () => step(true)),
      button(icon("last"), "To the end (End)", () => cursor.seek(cursor.to)),
      speed,
      this.time,
      button("−", "Show more of the match (-)", () => axis.zoom(1.6, cursor.time)),
      button("+", "Show less of the match (+)", () => axis.zoom(1 / 1.6, cursor.time)),
      button("all", "Show the whole match (0)", () => axis.showAll()),
      this.progress,
      this.end,
    );
    cursor.onChange(() => this.show());
  }

  showProgress(done: number, all: number): void {
    text(this.progress, done < all ? `reading decisions ${Math.round((100 * done) / all)} %` : "");
  }

  private show(): void {
    const { time, to, playing } = this.cursor;
    text(this.time, `${clockOf(time / 1e6, true)} / ${clockOf(to / 1e6)}`);
    if (playing === this.shownPlaying) return;
    this.shownPlaying = playing;
    this.playing.replaceChildren(icon(playing ? "pause" : "play"));
    this.playing.setAttribute("aria-label", playing ? "Stop (space)" : "Play (space)");
  }
}
