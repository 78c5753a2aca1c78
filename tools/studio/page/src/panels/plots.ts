// SPDX-License-Identifier: Apache-2.0
// Numbers of messages over the time of the match. Any number of any topic can be looked for by
// words of its path; it is read in the background and drawn as it comes.
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { atNextPicture, inks, make, text } from "../app/dom";
import type { Cursor } from "../app/cursor";
import type { TimeAxis } from "../app/timeAxis";
import { found } from "../model/schemaTree";

export interface Plottable {
  source: string; // "red-2"
  topic: string;
  path: string;
}
export type ReadSeries = (
  what: Plottable,
  take: (times: Float64Array, values: Float64Array, done: boolean) => void,
) => void;

interface Series extends Plottable {
  times: number[];
  values: number[];
}
const MOST_FOUND = 60;
const STROKES = ["#e0342b", "#2f6fe4", "#1a9c6b", "#c07a00", "#8a4fd0", "#008b9c"];
const DASHES = [[], [6, 3], [2, 3], [8, 3, 2, 3], [], [6, 3]];

export class Plots {
  readonly element: HTMLElement;
  private readonly search = make("input", {
    type: "search",
    "aria-label": "Find a number",
    placeholder: "find a number: ball distance",
  });
  private readonly source = make("select", { "aria-label": "Whose" });
  private readonly list = make("div", { class: "found", role: "listbox", "aria-label": "Numbers" });
  private readonly chart = make("div", { class: "chart", role: "img", "aria-label": "Plot" });
  private readonly chosen = make("div", { class: "chosen" });
  private readonly value = make("output", { class: "said", "aria-label": "Values at this time" });
  private plot: uPlot | undefined;
  private series: Series[] = [];
  private readonly drawing = atNextPicture(() => this.draw());

  constructor(
    private readonly sources: () => Map<string, string[]>,
    private readonly read: ReadSeries,
    private readonly cursor: Cursor,
    private readonly axis: TimeAxis,
  ) {
    this.search.addEventListener("input", () => this.fill());
    this.source.addEventListener("change", () => this.fill());
    this.element = make(
      "div",
      { class: "plots" },
      make(
        "div",
        { class: "choose" },
        make("div", { class: "tools" }, this.source, this.search),
        this.list,
      ),
      make("div", { class: "drawn" }, this.chosen, this.chart, this.value),
    );
    cursor.onChange(() => this.moved());
    axis.onChange(() => this.zoom());
    new ResizeObserver(() => this.drawing.now()).observe(this.chart);
    this.fillSources();
  }

  fillSources(): void {
    const names = [...this.sources().keys()];
    if (names.length === this.source.options.length) return;
    this.source.replaceChildren(...names.map((name) => make("option", { value: name }, name)));
    this.fill();
  }

  // Paths are "topic path".
  private fill(): void {
    const paths = this.sources().get(this.source.value) ?? [];
    const shown = found(paths, this.search.value, MOST_FOUND);
    this.list.replaceChildren(
      ...shown.map((path) => {
        const [topic, name] = path.split(" ") as [string, string];
        return make(
          "button",
          {
            type: "button",
            role: "option",
            "aria-selected": "false",
            click: () => this.add({ source: this.source.value, topic, path: name }),
          },
          make("small", {}, `${topic} `),
          name,
        );
      }),
    );
    if (shown.length === 0)
      this.list.append(make("p", { class: "said" }, "No number is called so."));
  }

  add(what: Plottable): void {
    if (
      this.series.length >= STROKES.length ||
      this.series.some((s) => s.source === what.source && s.path === what.path)
    )
      return;
    const series: Series = { ...what, times: [], values: [] };
    this.series.push(series);
    this.showChosen();
    this.read(what, (times, values, done) => {
      for (const time of times) series.times.push(time / 1e6);
      for (const value of values) series.values.push(value);
      if (done) this.drawing.now();
      else this.drawing.soon();
    });
  }

  // Of a live match: read anew what there is.
  refresh(): void {
    for (const series of this.series) {
      series.times = [];
      series.values = [];
      this.read(series, (times, values) => {
        series.times = Array.from(times, (t) => t / 1e6);
        series.values = Array.from(values);
      });
    }
    if (this.series.length > 0) this.drawing.now();
  }

  private showChosen(): void {
    this.chosen.replaceChildren(
      ...this.series.map((series, i) => {
        const name = `${series.source} ${series.path}`;
        const swatch = make("span", { class: "swatch" });
        swatch.style.background = STROKES[i]!;
        return make(
          "button",
          {
            type: "button",
            title: `Remove ${name}`,
            "aria-label": `Remove ${name}`,
            click: () => this.remove(series),
          },
          swatch,
          name,
          " ×",
        );
      }),
    );
  }

  private remove(series: Series): void {
    this.series = this.series.filter((s) => s !== series);
    this.showChosen();
    this.drawing.now();
  }

  get points(): number {
    return this.series.reduce((sum, s) => sum + s.times.length, 0);
  }

  themeChanged(): void {
    this.drawing.now();
  }

  private draw(): void {
    this.plot?.destroy();
    this.plot = undefined;
    if (this.series.length === 0 || this.chart.clientWidth < 50) return;
    const ink = inks(["dim", "line"]);
    const axes = {
      stroke: ink["dim"]!,
      grid: { stroke: ink["line"]!, width: 1 },
      ticks: { stroke: ink["line"]! },
    };
    const options: uPlot.Options = {
      width: this.chart.clientWidth,
      height: Math.max(60, this.chart.clientHeight),
      legend: { show: false },
      cursor: { drag: { x: false, y: false } },
      scales: { x: { time: false, range: () => [this.axis.from / 1e6, this.axis.to / 1e6] } },
      axes: [
        { ...axes, values: (_, s) => s.map((v) => `${v} s`) },
        { ...axes, size: 56 },
      ],
      series: [
        {},
        ...this.series.map((series, i) => ({
          label: series.path,
          stroke: STROKES[i]!,
          width: 1.3,
          dash: DASHES[i]!,
          spanGaps: true,
        })),
      ],
      hooks: { draw: [(plot) => this.drawNow(plot)] },
    };
    const tables = this.series.map((s) => [s.times, s.values] as uPlot.AlignedData);
    this.plot = new uPlot(options, uPlot.join(tables), this.chart);
    this.plot.over.addEventListener("click", (e) =>
      this.cursor.seek(this.plot!.posToVal(e.offsetX, "x") * 1e6),
    );
    this.moved();
  }

  private drawNow(plot: uPlot): void {
    const x = plot.valToPos(this.cursor.time / 1e6, "x", true);
    plot.ctx.fillStyle = inks(["accent"])["accent"]!;
    plot.ctx.fillRect(x, plot.bbox.top, 2, plot.bbox.height);
  }

  private zoom(): void {
    this.plot?.setScale("x", { min: this.axis.from / 1e6, max: this.axis.to / 1e6 });
  }

  private moved(): void {
    if (!this.plot || this.chart.clientWidth === 0) return;
    this.plot.redraw(false);
    const now = this.cursor.time / 1e6;
    text(
      this.value,
      this.series
        .map((s) => {
          const value = s.values[lastAt(s.times, now)];
          return `${s.path}: ${value === undefined ? "?" : Number(value.toPrecision(5))}`;
        })
        .join("   "),
    );
  }
}

function lastAt(times: readonly number[], time: number): number {
  let low = 0;
  let high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle]! <= time) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}
