// SPDX-License-Identifier: Apache-2.0
// A lane for each robot with what it decided: role, player, skill, motion. The chosen robot's lane
// is taller and written on. Pointing at a decision tells its reason, a click goes there.
import { atNextPicture, fitCanvas, inks, make } from "../app/dom";
import type { Cursor } from "../app/cursor";
import type { TimeAxis } from "../app/timeAxis";
import type { FactStore } from "../model/factStore";
import { ROWS, type Row, type Segment } from "../model/facts";
import { TEAM_NAMES, type Team } from "../model/field";
import { clockOf } from "../model/words";
import { GUTTER, placeNeedle, zoomByWheel } from "./timeLine";

const LOW = 4; // px a row
const HIGH = 16;
const GAP = 4;
const INKS = ["ink", "dim", "line", "red", "blue", "accent", "panel", "lane"] as const;

export interface LaneRobot {
  key: string;
  team: Team;
  player: number;
  name?: string; // what stands behind team and number
}

export class Lanes {
  readonly element: HTMLElement;
  selected = "";
  chosen: Segment | undefined; // what is pointed at
  private readonly canvas: HTMLCanvasElement;
  private readonly tip: HTMLElement;
  private readonly needle = make("div", { class: "needle" });
  private readonly drawing = atNextPicture(() => this.draw());
  readonly redraw = this.drawing.now;
  readonly redrawSoon = this.drawing.soon;
  private robots: LaneRobot[] = [];

  constructor(
    private readonly cursor: Cursor,
    private readonly axis: TimeAxis,
    private readonly facts: FactStore,
    private readonly pick: (key: string) => void,
  ) {
    this.canvas = make("canvas", { class: "line" });
    this.tip = make("div", { class: "tip reason", hidden: true, role: "tooltip", id: "reason" });
    this.element = make(
      "div",
      {
        class: "lanes",
        tabindex: "0",
        role: "group",
        "aria-label":
          "Decisions of the robots; arrow keys up and down choose a robot, " +
          "Page Up and Page Down go to the decision before and after",
        "aria-describedby": "reason",
      },
      make("div", { class: "lane-area" }, this.canvas, this.needle),
    );
    document.body.append(this.tip);
    this.listen();
    cursor.onChange((time) => placeNeedle(this.needle, this.axis, time, this.width));
    axis.onChange(() => this.redraw());
    new ResizeObserver(() => this.redraw()).observe(this.element);
  }

  setRobots(robots: LaneRobot[]): void {
    this.robots = robots;
    this.redraw();
  }

  private listen(): void {
    this.element.addEventListener("pointermove", (e) => this.hover(e));
    this.element.addEventListener("pointerleave", () => this.hideTip());
    this.element.addEventListener("click", (e) => this.click(e));
    this.element.addEventListener("keydown", (e) => this.key(e));
    this.element.addEventListener(
      "wheel",
      (e) => {
        if (e.ctrlKey || e.altKey || this.element.scrollHeight <= this.element.clientHeight + 1)
          zoomByWheel(e, this.axis, this.width, this.left);
      },
      { passive: false },
    );
  }

  private get left(): number {
    return this.element.getBoundingClientRect().left + GUTTER;
  }
  private get width(): number {
    return this.element.clientWidth - GUTTER - 8;
  }

  private rowHeight(robot: LaneRobot): number {
    return robot.key === this.selected ? HIGH : LOW;
  }

  private *places(): Generator<{ robot: LaneRobot; top: number; row: number }> {
    let top = 4;
    for (const robot of this.robots) {
      const row = this.rowHeight(robot);
      yield { robot, top, row };
      top += ROWS.length * row + GAP;
    }
  }

  // Which robot, row and decision are at a place of the screen.
  at(clientX: number, clientY: number) {
    const y = clientY - this.canvas.getBoundingClientRect().top;
    for (const { robot, top, row } of this.places()) {
      if (y < top || y >= top + ROWS.length * row) continue;
      const name = ROWS[Math.floor((y - top) / row)]!;
      const time = this.axis.time(clientX - this.left, this.width);
      const segment = segmentAt(this.facts.rowsOf(robot.key)[name], time);
      return { robot, name, time, segment };
    }
    return undefined;
  }

  private hover(e: PointerEvent): void {
    const found = this.at(e.clientX, e.clientY);
    if (!found?.segment || e.clientX < this.left) return this.hideTip();
    this.tell(found.robot, found.name, found.segment, e.clientX, e.clientY);
  }

  private tell(robot: LaneRobot, name: Row, segment: Segment, x: number, y: number): void {
    this.chosen = segment;
    const who =
      `${TEAM_NAMES[robot.team]} ${robot.player}, ${name}, ` +
      `${clockOf(segment.from / 1e6, true)} for ` +
      `${((segment.to - segment.from) / 1e6).toFixed(1)} s`;
    this.tip.replaceChildren(make("small", {}, who), make("p", {}, segment.why));
    this.tip.hidden = false;
    this.tip.style.left = `${Math.min(x + 12, innerWidth - this.tip.offsetWidth - 8)}px`;
    this.tip.style.top = `${Math.max(4, y - this.tip.offsetHeight - 12)}px`;
  }

  private hideTip(): void {
    this.tip.hidden = true;
    this.chosen = undefined;
  }

  private click(e: MouseEvent): void {
    const found = this.at(e.clientX, e.clientY);
    if (!found) return;
    this.pick(found.robot.key);
    if (e.clientX < this.left) return;
    this.cursor.seek(found.segment ? Math.max(found.segment.from, this.axis.from) : found.time);
  }

  private key(e: KeyboardEvent): void {
    const index = this.robots.findIndex((r) => r.key === this.selected);
    if (e.key === "ArrowDown" || e.key === "ArrowUp") {
      const next = this.robots[index + (e.key === "ArrowDown" ? 1 : -1)];
      if (next) this.pick(next.key);
    } else if (e.key === "PageDown" || e.key === "PageUp") {
      this.stepDecision(e.key === "PageDown", this.robots[index]);
    } else return;
    e.preventDefault();
    e.stopPropagation();
  }

  private stepDecision(forward: boolean, robot: LaneRobot | undefined): void {
    if (!robot) return;
    const list = this.facts.rowsOf(robot.key).skill;
    const time = this.cursor.time;
    const next = forward
      ? list.find((s) => s.from > time + 1)
      : [...list].reverse().find((s) => s.from < time - 1);
    if (!next) return;
    this.cursor.seek(next.from);
    const place = [...this.places()].find((p) => p.robot === robot)!;
    const box = this.canvas.getBoundingClientRect();
    this.tell(
      robot,
      "skill",
      next,
      this.left + this.axis.x(next.from, this.width),
      box.top + place.top,
    );
  }

  private draw(): void {
    const places = [...this.places()];
    const last = places[places.length - 1];
    const height = last ? last.top + ROWS.length * last.row + GAP : 20;
    this.canvas.style.height = `${height}px`;
    const c = fitCanvas(this.canvas, this.element.clientWidth, height);
    const ink = inks(INKS);
    c.clearRect(0, 0, this.element.clientWidth, height);
    for (const { robot, top, row } of places) this.drawLane(c, robot, top, row, ink);
    placeNeedle(this.needle, this.axis, this.cursor.time, this.width);
  }

  private drawLane(
    c: CanvasRenderingContext2D,
    robot: LaneRobot,
    top: number,
    row: number,
    ink: Record<string, string>,
  ): void {
    const name = `${TEAM_NAMES[robot.team]} ${robot.player}${robot.name ?? ""}`;
    c.fillStyle = ink["lane"]!;
    c.fillRect(GUTTER, top, this.width, ROWS.length * row);
    c.fillStyle = ink[robot.team === 0 ? "red" : "blue"]!;
    c.fillRect(2, top, 3, ROWS.length * row);
    c.font = `${robot.key === this.selected ? "600 " : ""}12px system-ui, sans-serif`;
    c.fillStyle = ink["ink"]!;
    c.fillText(name, 10, top + (row === HIGH ? 13 : (ROWS.length * LOW) / 2 + 4));
    const rows = this.facts.rowsOf(robot.key);
    c.save();
    c.beginPath();
    c.rect(GUTTER, top, this.width, ROWS.length * row);
    c.clip();
    ROWS.forEach((kind, i) => this.drawRow(c, rows[kind], top + i * row, row, ink));
    c.restore();
    if (row !== HIGH) return;
    c.font = "10px system-ui, sans-serif";
    c.fillStyle = ink["dim"]!;
    ROWS.slice(1).forEach((kind, i) => c.fillText(kind, 10, top + (i + 1) * row + 12));
  }

  private drawRow(
    c: CanvasRenderingContext2D,
    list: readonly Segment[],
    top: number,
    row: number,
    ink: Record<string, string>,
  ): void {
    c.font = "11px system-ui, sans-serif";
    for (let i = Math.max(0, firstEnding(list, this.axis.from)); i < list.length; ++i) {
      const segment = list[i]!;
      if (segment.from > this.axis.to) break;
      const x = GUTTER + this.axis.x(segment.from, this.width);
      const wide = Math.max(0.6, this.axis.x(segment.to, this.width) + GUTTER - x);
      c.fillStyle = colourOf(segment.label);
      c.fillRect(x, top + 0.5, wide - (wide > 3 ? 0.7 : 0), row - 1);
      if (row === HIGH && wide > 26)
        write(c, segment.label, Math.max(x, GUTTER), top, x + wide, ink);
    }
  }
}

function write(
  c: CanvasRenderingContext2D,
  label: string,
  x: number,
  top: number,
  end: number,
  ink: Record<string, string>,
): void {
  const room = Math.floor((end - x - 6) / 5.6);
  if (room < 3) return;
  c.fillStyle = ink["ink"]!;
  c.fillText(label.length > room ? `${label.slice(0, room - 1)}…` : label, x + 4, top + 12);
}

// The same label has the same colour everywhere, in both themes.
const hues = new Map<string, string>();
export function colourOf(label: string): string {
  let colour = hues.get(label);
  if (colour) return colour;
  if (label === "" || label === "none" || label === "stand") colour = "hsl(220 8% 55% / 0.25)";
  else {
    let hash = 2166136261;
    for (const letter of label) hash = Math.imul(hash ^ letter.charCodeAt(0), 16777619) >>> 0;
    colour = `hsl(${hash % 360} ${48 + ((hash >> 9) % 25)}% 55% / 0.62)`;
  }
  hues.set(label, colour);
  return colour;
}

function firstEnding(list: readonly Segment[], time: number): number {
  let low = 0;
  let high = list.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (list[middle]!.to < time) low = middle + 1;
    else high = middle;
  }
  return low;
}

export function segmentAt(list: readonly Segment[], time: number): Segment | undefined {
  const segment = list[firstEnding(list, time)];
  return segment && segment.from <= time ? segment : undefined;
}
