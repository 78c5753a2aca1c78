// SPDX-License-Identifier: Apache-2.0
// The time line: marks of what happened, who has the ball, and the cursor. By keyboard it is a
// slider; marks differ by shape as well as by colour.
import { atNextPicture, fitCanvas, inks, make } from "../app/dom";
import type { Cursor } from "../app/cursor";
import { FRAME_US } from "../app/cursor";
import type { TimeAxis } from "../app/timeAxis";
import type { FactStore } from "../model/factStore";
import type { Mark, MarkKind } from "../model/facts";
import { clockOf } from "../model/words";

export const GUTTER = 92; // px, of names left of lanes and time line
const HEIGHT = 46;
const INKS = ["ink", "dim", "line", "red", "blue", "accent", "panel", "goal", "warn"] as const;
const LEVEL: Record<MarkKind, number> = {
  goal: 10,
  error: 10,
  fall: 10,
  carry: 10,
  referee: 10,
  kick: 21,
  grab: 21,
};

export class TimeLine {
  readonly element: HTMLElement;
  differences: readonly number[] = [];
  private readonly canvas: HTMLCanvasElement;
  private readonly tip: HTMLElement;
  private readonly needle = make("div", { class: "needle" });
  private readonly drawing = atNextPicture(() => this.draw());
  readonly redraw = this.drawing.now;
  readonly redrawSoon = this.drawing.soon;
  private dragging = false;

  constructor(
    private readonly cursor: Cursor,
    private readonly axis: TimeAxis,
    private readonly facts: FactStore,
  ) {
    this.canvas = make("canvas", { class: "line" });
    this.tip = make("div", { class: "tip", hidden: true });
    this.element = make(
      "div",
      {
        class: "timeline",
        tabindex: "0",
        role: "slider",
        "aria-label": "Time of the match",
        "aria-valuemin": "0",
      },
      this.canvas,
      this.needle,
      this.tip,
    );
    this.listen();
    cursor.onChange(() => this.changed());
    axis.onChange(() => this.redraw());
    new ResizeObserver(() => this.redraw()).observe(this.element);
  }

  private listen(): void {
    this.element.addEventListener("pointerdown", (e) => {
      this.dragging = true;
      this.element.setPointerCapture(e.pointerId);
      this.seekTo(e);
    });
    this.element.addEventListener("pointermove", (e) =>
      this.dragging ? this.seekTo(e) : this.hover(e),
    );
    this.element.addEventListener("pointerup", () => (this.dragging = false));
    this.element.addEventListener("pointerleave", () => (this.tip.hidden = true));
    this.element.addEventListener(
      "wheel",
      (e) => zoomByWheel(e, this.axis, this.width, this.left),
      { passive: false },
    );
  }

  private get left(): number {
    return this.element.getBoundingClientRect().left + GUTTER;
  }
  private get width(): number {
    return this.element.clientWidth - GUTTER - 8;
  }

  private seekTo(e: PointerEvent): void {
    this.cursor.seek(this.axis.time(e.clientX - this.left, this.width));
  }

  private hover(e: PointerEvent): void {
    const x = e.clientX - this.left;
    const mark = nearest(this.facts.marks, (m) => Math.abs(this.axis.x(m.time, this.width) - x), 6);
    const time = this.axis.time(x, this.width);
    this.tip.hidden = x < 0;
    this.tip.textContent = mark
      ? `${clockOf(mark.time / 1e6, true)}  ${mark.text}`
      : clockOf(time / 1e6, true);
    this.tip.style.left = `${Math.min(
      Math.max(GUTTER, e.clientX - this.element.getBoundingClientRect().left),
      this.element.clientWidth - 190,
    )}px`;
  }

  private changed(): void {
    const { time, from, to } = this.cursor;
    this.element.setAttribute("aria-valuemax", ((to - from) / 1e6).toFixed(2));
    this.element.setAttribute("aria-valuenow", ((time - from) / 1e6).toFixed(2));
    this.element.setAttribute(
      "aria-valuetext",
      `${clockOf(time / 1e6, true)} of ${clockOf(to / 1e6)}`,
    );
    this.axis.keep(time);
    placeNeedle(this.needle, this.axis, time, this.width);
  }

  private draw(): void {
    placeNeedle(this.needle, this.axis, this.cursor.time, this.width);
    const c = fitCanvas(this.canvas, this.element.clientWidth, HEIGHT);
    const ink = inks(INKS);
    c.clearRect(0, 0, this.element.clientWidth, HEIGHT);
    c.save();
    c.translate(GUTTER, 0);
    this.drawPossession(c, ink);
    drawTicks(c, this.axis, this.width, HEIGHT, ink);
    c.fillStyle = ink["warn"]!;
    for (const time of this.differences) c.fillRect(this.axis.x(time, this.width), 0, 1, 6);
    for (const mark of this.facts.marks) this.drawMark(c, mark, ink);
    c.restore();
    c.font = "11px system-ui, sans-serif";
    c.fillStyle = ink["dim"]!;
    c.fillText("Events", 10, 13);
    c.fillText("Ball with", 10, 32);
  }

  private drawPossession(c: CanvasRenderingContext2D, ink: Record<string, string>): void {
    for (const { from, to, team } of this.facts.possession) {
      if (team < 0 || to < this.axis.from || from > this.axis.to) continue;
      const x = this.axis.x(from, this.width);
      c.fillStyle = ink[team === 0 ? "red" : "blue"]!;
      // Red in the upper half, blue in the lower one: the place says it, too.
      c.fillRect(x, team === 0 ? 26 : 30, Math.max(1, this.axis.x(to, this.width) - x), 4);
    }
  }

  private drawMark(c: CanvasRenderingContext2D, mark: Mark, ink: Record<string, string>): void {
    const x = this.axis.x(mark.time, this.width);
    if (x < -6 || x > this.width + 6) return;
    c.fillStyle = c.strokeStyle =
      mark.kind === "error"
        ? ink["warn"]!
        : mark.team >= 0
          ? ink[mark.team === 0 ? "red" : "blue"]!
          : ink["dim"]!;
    drawSign(c, mark.kind, x, LEVEL[mark.kind]);
  }
}

// The cursor is an element of its own, so that no canvas is drawn anew while time runs.
export function placeNeedle(
  needle: HTMLElement,
  axis: TimeAxis,
  time: number,
  width: number,
): void {
  const x = axis.x(time, width);
  needle.hidden = x < 0 || x > width;
  needle.style.transform = `translateX(${(GUTTER + x).toFixed(1)}px)`;
}

function drawSign(c: CanvasRenderingContext2D, kind: MarkKind, x: number, y: number): void {
  c.beginPath();
  if (kind === "goal") {
    c.arc(x, y, 5, 0, 7);
    c.fill();
    c.fillRect(x - 0.5, y, 1, 30);
  } else if (kind === "kick") {
    c.moveTo(x - 3, y - 3), c.lineTo(x + 3, y), c.lineTo(x - 3, y + 3);
    c.fill();
  } else if (kind === "grab") {
    c.strokeRect(x - 2, y - 2, 4, 4);
  } else if (kind === "referee") {
    c.fillRect(x - 0.5, y - 6, 1, 12);
  } else if (kind === "fall") {
    c.moveTo(x - 4, y - 3), c.lineTo(x + 4, y - 3), c.lineTo(x, y + 4);
    c.fill();
  } else if (kind === "carry") {
    c.moveTo(x, y - 5), c.lineTo(x + 4, y), c.lineTo(x, y + 5), c.lineTo(x - 4, y);
    c.fill();
  } else {
    c.moveTo(x - 4, y - 4), c.lineTo(x + 4, y + 4), c.moveTo(x + 4, y - 4), c.lineTo(x - 4, y + 4);
    c.lineWidth = 2;
    c.stroke();
    c.lineWidth = 1;
  }
}

export function drawTicks(
  c: CanvasRenderingContext2D,
  axis: TimeAxis,
  width: number,
  height: number,
  ink: Record<string, string>,
): void {
  const span = (axis.to - axis.from) / 1e6;
  const step = [0.1, 0.5, 1, 2, 5, 10, 30, 60, 120].find((s) => (s / span) * width > 56) ?? 300;
  c.font = "10px system-ui, sans-serif";
  for (let s = Math.ceil(axis.from / 1e6 / step) * step; s <= axis.to / 1e6; s += step) {
    const x = axis.x(s * 1e6, width);
    c.fillStyle = ink["line"]!;
    c.fillRect(x, 0, 1, height - 10);
    c.fillStyle = ink["dim"]!;
    c.fillText(clockOf(s + 1e-6, step < 1), x + 3, height - 2);
  }
}

export function zoomByWheel(e: WheelEvent, axis: TimeAxis, width: number, left: number): void {
  e.preventDefault();
  if (e.shiftKey || Math.abs(e.deltaX) > Math.abs(e.deltaY))
    axis.move(((axis.to - axis.from) * (e.deltaX || e.deltaY)) / 1000);
  else axis.zoom(Math.exp(e.deltaY / 400), axis.time(e.clientX - left, width));
}

function nearest<T>(items: readonly T[], away: (item: T) => number, most: number): T | undefined {
  let best: T | undefined;
  let least = most;
  for (const item of items) {
    const distance = away(item);
    if (distance < least) (best = item), (least = distance);
  }
  return best;
}

// The next mark or second from a time, forward or back.
export function stepTime(time: number, forward: boolean, marks: readonly Mark[]): number {
  const second = time + (forward ? 1e6 : -1e6);
  const margin = FRAME_US / 2;
  const found = marks.filter((m) =>
    forward ? m.time > time + margin && m.time < second : m.time < time - margin && m.time > second,
  );
  const mark = forward ? found[0] : found[found.length - 1];
  return mark ? mark.time : second;
}
