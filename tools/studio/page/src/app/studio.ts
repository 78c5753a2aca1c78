// SPDX-License-Identifier: Apache-2.0
// Puts the page together: one cursor, one match, and the panels that show the match at the time of
// the cursor. Data flow forward: streams, moment, panels.
import { FieldView } from "../drawing/fieldView";
import { VIEWS, type ViewName } from "../drawing/views";
import { LAYERS, type Layer } from "../drawing/beliefs";
import type { Body } from "../model/body";
import { FactStore } from "../model/factStore";
import type { Match } from "../model/match";
import { loadMoment, momentAt, type Moment } from "../model/moment";
import { CameraPanel } from "../panels/cameraPanel";
import { Help } from "../panels/help";
import { Lanes, type LaneRobot } from "../panels/lanes";
import { FieldControls } from "../panels/layersPanel";
import type { Notes } from "../panels/notes";
import { ReasonPanel, RobotList } from "../panels/robotPanel";
import { Tabs } from "../panels/tabs";
import { TimeLine, stepTime } from "../panels/timeLine";
import { TitleBar } from "../panels/titleBar";
import { Transport } from "../panels/transport";
import { readHash, writeHash } from "./address";
import { Cursor, FRAME_US } from "./cursor";
import { byId, make } from "./dom";
import { listenToKeys } from "./keys";
import { Theme } from "./theme";
import { TimeAxis } from "./timeAxis";

const NO_FIELD = "No log describes a field: nothing can be drawn of it.";

const PANELS_EVERY = 110; // ms while time runs: nobody reads faster, and text costs much to draw

export class Studio {
  readonly cursor: Cursor;
  readonly axis: TimeAxis;
  readonly field: FieldView | undefined;
  readonly lanes: Lanes;
  readonly timeLine: TimeLine;
  readonly transport: Transport;
  readonly camera = new CameraPanel();
  readonly tabs: Tabs;
  readonly title: TitleBar;
  selected = "";
  readonly extraLanes: LaneRobot[] = []; // of the second log of a comparison
  onShown: () => void = () => undefined;
  onTheme: (dark: boolean) => void = () => undefined;
  moment: Moment | undefined;
  seekMs = 0;
  private readonly help = new Help();
  private readonly reasons = new ReasonPanel();
  private readonly list = new RobotList((key) => this.select(key));
  private readonly controls: FieldControls;
  private readonly theme: Theme;
  private panelsAt = 0;
  private asked = 0;
  private hashTimer = 0;

  constructor(
    readonly match: Match,
    body: Body,
    readonly notes: Notes,
    readonly facts = new FactStore(),
  ) {
    this.cursor = new Cursor(match.from, match.to);
    this.axis = new TimeAxis(match.from, match.to);
    this.timeLine = new TimeLine(this.cursor, this.axis, this.facts);
    this.lanes = new Lanes(this.cursor, this.axis, this.facts, (key) => this.select(key));
    this.tabs = new Tabs(() => this.keepAddress());
    this.transport = new Transport(this.cursor, this.axis, (forward) => this.step(forward));
    this.controls = new FieldControls(
      (view) => this.view(view),
      (layer, on) => this.layer(layer, on),
    );
    this.title = new TitleBar(
      byId("title"),
      () => this.help.toggle(),
      () => this.theme.toggle(),
    );
    this.field = match.field ? this.makeField(match, body) : undefined;
    if (!this.field) notes.say(NO_FIELD);
    this.theme = new Theme((dark) => this.themeChanged(dark));
    this.assemble();
    this.bindKeys();
    this.cursor.onChange((time) => this.timeChanged(time));
    this.applyAddress();
    window.addEventListener("hashchange", () => this.applyAddress());
  }

  private makeField(match: Match, body: Body): FieldView {
    const box = byId("field");
    const canvas = make("canvas", {
      class: "scene",
      tabindex: "0",
      role: "img",
      "aria-label": "Field with robots and ball",
    });
    const over = make("div", { class: "over" });
    const frame = make("div", { class: "eye-frame", hidden: true });
    box.append(canvas, over, frame, this.controls.element);
    const view = new FieldView(canvas, over, match.field!, body, (key) => this.select(key));
    view.views.onTakenOver = () => this.showControls();
    const resize = () => view.stage.resize(box.clientWidth, box.clientHeight);
    new ResizeObserver(resize).observe(box);
    resize();
    return view;
  }

  private assemble(): void {
    byId("side").append(this.list.element, this.camera.element, this.reasons.element);
    this.tabs.add("Decisions", this.lanes.element);
    this.transport.end.append(this.tabs.element);
    byId("dock").append(this.transport.element, this.timeLine.element, this.tabs.panels);
    document.body.append(this.help.element);
    this.showControls();
  }

  private bindKeys(): void {
    const to = (time: () => number) => () => this.cursor.seek(time());
    const numbers = Object.fromEntries(
      [1, 2, 3, 4, 5, 6, 7, 8].map((n) => [
        String(n),
        () => this.select(this.moment?.robots[n - 1]?.key ?? this.selected),
      ]),
    );
    listenToKeys({
      ...numbers,
      " ": () => this.cursor.play(),
      ArrowLeft: to(() => this.cursor.time - FRAME_US),
      ArrowRight: to(() => this.cursor.time + FRAME_US),
      "[": () => this.step(false),
      "]": () => this.step(true),
      Home: to(() => this.cursor.from),
      End: () => this.toEnd(),
      v: () =>
        this.view(VIEWS[(VIEWS.indexOf(this.field?.views.mode ?? "orbit") + 1) % VIEWS.length]!),
      l: () => this.controls.element.querySelector("summary")?.click(),
      d: () => this.toDifference(),
      t: () => void this.theme.toggle(),
      "+": () => this.axis.zoom(1 / 1.6, this.cursor.time),
      "-": () => this.axis.zoom(1.6, this.cursor.time),
      "0": () => this.axis.showAll(),
      Escape: () => this.select(""),
      "?": () => this.help.toggle(),
    });
  }

  onEnd: () => void = () => undefined; // of a live match
  private toEnd(): void {
    this.onEnd();
    this.cursor.seek(this.cursor.to);
  }

  private toDifference(): void {
    const [first] = this.timeLine.differences;
    if (first !== undefined) this.cursor.seek(first);
  }

  step(forward: boolean): void {
    this.cursor.seek(stepTime(this.cursor.time, forward, this.facts.marks));
  }

  select(key: string): void {
    this.selected = key;
    this.lanes.selected = key;
    if (this.field) this.field.selected = key;
    this.lanes.redraw();
    this.timeChanged(this.cursor.time);
  }

  view(mode: ViewName): void {
    if ((mode === "follow" || mode === "eye") && this.selected === "")
      this.select(this.moment?.robots[0]?.key ?? "");
    this.field?.setView(mode);
    this.showControls();
    this.keepAddress();
  }

  private layer(layer: Layer, on: boolean): void {
    this.field?.setLayer(layer, on);
    this.keepAddress();
  }

  private showControls(): void {
    if (!this.field) return;
    this.controls.show(this.field.views.mode, this.field.layers);
    document.querySelector<HTMLElement>(".eye-frame")!.hidden = this.field.views.mode !== "eye";
  }

  private themeChanged(dark: boolean): void {
    this.field?.stage.setDark(dark);
    this.lanes?.redraw();
    this.timeLine?.redraw();
    this.tabs?.themeChanged();
    this.onTheme(dark);
  }

  // Shows what is in memory at once and reads what is not; of many wishes only the last is shown.
  timeChanged(time: number): void {
    const asked = ++this.asked;
    const moment = momentAt(this.match, time);
    if (moment.complete || !this.moment) this.show(moment);
    if (moment.complete) return this.loadAhead(time);
    const began = performance.now();
    void loadMoment(this.match, time)
      .then(() => {
        if (asked !== this.asked) return;
        this.seekMs = performance.now() - began;
        this.show(momentAt(this.match, this.cursor.time));
      })
      .catch((error: unknown) =>
        this.notes.say(
          `A part of a log cannot be read: ${
            error instanceof Error ? error.message : String(error)
          }`,
          "error",
        ),
      );
  }

  private aheadOf = 0;
  private loadAhead(time: number): void {
    if (!this.cursor.playing || Math.abs(time - this.aheadOf) < 3e5) return;
    this.aheadOf = time;
    void loadMoment(this.match, time + 1.2e6 * this.cursor.speed).catch(() => undefined);
  }

  private show(moment: Moment): void {
    this.moment = moment;
    this.field?.show(moment);
    this.onShown();
    this.keepAddress();
    const now = performance.now();
    if (this.cursor.moving && now - this.panelsAt < PANELS_EVERY) return;
    this.panelsAt = now;
    this.showPanels(moment);
  }

  private showPanels(moment: Moment): void {
    const robot = moment.robots.find((r) => r.key === this.selected);
    this.title.show(moment);
    this.list.show(moment.robots, this.selected);
    this.reasons.show(robot);
    this.camera.show(
      this.match.robots.find((r) => r.key === this.selected),
      moment.time,
    );
  }

  robotsChanged(): void {
    const keys = new Map((this.moment?.robots ?? this.match.robots).map((r) => [r.key, r]));
    this.lanes.setRobots([
      ...[...keys.values()].map(({ key, team, player }) => ({ key, team, player })),
      ...this.extraLanes,
    ]);
  }

  private applyAddress(): void {
    const kept = readHash(location.hash);
    if (kept.layers && this.field) {
      this.field.layers.clear();
      for (const layer of kept.layers) if (layer in LAYERS) this.field.layers.add(layer as Layer);
    }
    const key = kept.robot ?? (this.selected || this.match.robots[0]?.key || "");
    this.selected = this.lanes.selected = key;
    if (this.field) this.field.selected = key;
    if (kept.view && VIEWS.includes(kept.view as ViewName))
      this.field?.setView(kept.view as ViewName);
    this.showControls();
    if (kept.tab) this.tabs.choose(kept.tab);
    this.cursor.set(kept.time !== undefined ? kept.time * 1e6 : this.cursor.time);
  }

  private keepAddress(): void {
    if (this.hashTimer !== 0) return;
    this.hashTimer = window.setTimeout(() => {
      this.hashTimer = 0;
      const hash = writeHash({
        time: this.cursor.time / 1e6,
        robot: this.selected,
        view: this.field?.views.mode ?? "",
        layers: [...(this.field?.layers ?? [])],
        tab: this.tabs.chosen,
      });
      history.replaceState(null, "", hash);
    }, 500);
  }
}
