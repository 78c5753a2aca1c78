// SPDX-License-Identifier: Apache-2.0
// What the chosen robot's camera saw, with what vision made of it. Frames whose image the log does
// not keep show the last one that it has, with its age. Refused candidates tell their reason.
import { fitCanvas, make, text } from "../app/dom";
import { numberAt } from "../reading/access";
import type { Structure } from "../reading/decoder";
import type { Message } from "../reading/stream";
import type { RobotStreams } from "../model/match";
import { drawBox, drawPercepts, words, type Box } from "../drawing/percepts";
import { HEIGHT, WIDTH, pictureKind, pictureOf } from "../drawing/pictures";

const OLDEST = 6e6; // us; an image that is older says nothing of now
type Plane = "image" | "classes";

interface Refused {
  kind: string;
  reason: string;
  box: [number, number, number, number];
}

export class CameraPanel {
  readonly element: HTMLElement;
  overlays = true;
  boxes: Box[] = [];
  private plane: Plane = "image";
  private showRefused = false;
  private refused: Refused[] = [];
  private readonly canvas: HTMLCanvasElement;
  private readonly caption = make("span", { class: "caption" });
  private readonly said = make("p", { class: "said", role: "status" });
  private drawnKey = "";
  private output: Structure | undefined;
  private picture: CanvasImageSource | undefined;
  private pending: (() => Promise<void>) | undefined;
  private busy = false;
  private robot: RobotStreams | undefined;

  constructor() {
    this.canvas = make("canvas", { class: "camera", role: "img", "aria-label": "Camera image" });
    this.canvas.addEventListener("pointermove", (e) => this.hover(e));
    this.element = make(
      "section",
      { class: "panel", "aria-label": "Camera" },
      make("div", { class: "head" }, make("h2", {}, "Camera"), this.caption),
      this.canvas,
      this.said,
      this.choices(),
    );
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  private choices(): HTMLElement {
    const box = (label: string, on: boolean, act: (on: boolean) => void) => {
      const input = make("input", { type: "checkbox" });
      input.checked = on;
      input.addEventListener("change", () => act(input.checked));
      return make("label", {}, input, label);
    };
    return make(
      "div",
      { class: "choices" },
      box("Percepts", true, (on) => {
        this.overlays = on;
        this.draw();
      }),
      box("Colour classes", false, (on) => this.choose(on ? "classes" : "image")),
      box("Refused", false, (on) => {
        this.showRefused = on;
        this.again();
      }),
    );
  }

  private choose(plane: Plane): void {
    this.plane = plane;
    this.again();
  }

  private again(): void {
    this.drawnKey = "";
    if (this.robot) this.show(this.robot, this.time);
  }
  private time = 0;

  show(robot: RobotStreams | undefined, time: number): void {
    this.robot = robot;
    this.time = time;
    if (!robot) return this.nothing("No robot with a log is chosen.");
    const message = lastPicture(robot, time);
    if (!message)
      return this.nothing(
        robot.inputs.length === 0
          ? "This log holds no camera images."
          : "No image of this time is kept.",
      );
    const age = (time - message.time) / 1e6;
    text(
      this.caption,
      `${robot.key.replace("-", " ")}, frame ` +
        `${numberAt(message.value, "frame") ?? "?"}` +
        (age > 0.05 ? `, ${age.toFixed(1)} s ago` : ""),
    );
    const key = `${robot.key} ${message.time} ${this.plane} ${this.showRefused}`;
    if (key === this.drawnKey) return;
    this.drawnKey = key;
    this.pending = () => this.load(robot, message);
    void this.work();
  }

  // One picture is made at a time, and of those that wait only the newest.
  private async work(): Promise<void> {
    if (this.busy) return;
    this.busy = true;
    while (this.pending) {
      const next = this.pending;
      this.pending = undefined;
      await next();
    }
    this.busy = false;
  }

  private async load(robot: RobotStreams, message: Message): Promise<void> {
    await robot.output?.load(message.time);
    const found = robot.output?.around(message.time + 1)?.before;
    const same = found && numberAt(found.value, "frame") === numberAt(message.value, "frame");
    this.output = same ? found.value : undefined;
    const ownClasses = this.plane === "classes" && pictureKind(message.value) !== "classes";
    const classes = ownClasses
      ? await fetchPicture(`/api/classes/${robot.log}`, message.time)
      : undefined;
    text(this.said, ownClasses && !classes ? "No colour classes of this image." : "");
    this.picture = classes ?? (await pictureOf(message.value));
    this.refused = this.showRefused ? await fetchRefused(robot.log, message.time) : [];
    if (this.showRefused && this.refused.length === 0)
      text(this.said, "No refused candidates are known of this image.");
    this.draw();
  }

  private nothing(sentence: string): void {
    this.picture = undefined;
    this.output = undefined;
    this.drawnKey = "";
    this.boxes = [];
    text(this.caption, "");
    text(this.said, sentence);
    this.draw();
  }

  private draw(): void {
    const width = this.canvas.clientWidth;
    const height = (width * HEIGHT) / WIDTH;
    const c = fitCanvas(this.canvas, width, height);
    this.canvas.style.height = `${height}px`;
    c.fillStyle = "#14181f";
    c.fillRect(0, 0, width, height);
    if (!this.picture) return;
    const scale = width / WIDTH;
    c.scale(scale, scale);
    c.imageSmoothingEnabled = scale < 1.2;
    c.drawImage(this.picture, 0, 0, WIDTH, HEIGHT);
    this.boxes = this.overlays ? drawPercepts(c, this.output, scale) : [];
    for (const { box } of this.refused)
      drawBox(
        c,
        { left: box[0], top: box[1], right: box[2], bottom: box[3], label: "", colour: "#c9a0ff" },
        scale,
      );
  }

  private hover(e: PointerEvent): void {
    const area = this.canvas.getBoundingClientRect();
    const x = ((e.clientX - area.left) / area.width) * WIDTH;
    const y = ((e.clientY - area.top) / area.height) * HEIGHT;
    const inside = (l: number, t: number, r: number, b: number) =>
      x >= l && x <= r && y >= t && y <= b;
    const refused = this.refused.filter(({ box }) => inside(...box));
    const box = this.boxes.find((b) => inside(b.left, b.top, b.right, b.bottom));
    const reasons = refused.map(({ kind, reason }) => `${words(kind)}: ${reason}`);
    const said = reasons.length > 0 ? `Refused as ${reasons.join("; ")}.` : "";
    this.canvas.title = said || (box?.label ?? "");
    if (this.showRefused) text(this.said, said || "Point at a box to read why it was refused.");
  }
}

function lastPicture(robot: RobotStreams, time: number): Message | undefined {
  let best: Message | undefined;
  for (const stream of robot.inputs) {
    const message = stream.around(time)?.before;
    if (
      message &&
      time - message.time < OLDEST &&
      pictureKind(message.value) &&
      (!best || message.time > best.time)
    )
      best = message;
  }
  return best;
}

async function fetchPicture(url: string, time: number): Promise<ImageBitmap | undefined> {
  try {
    const answer = await fetch(`${url}?time=${Math.round(time)}`);
    return answer.ok ? await createImageBitmap(await answer.blob()) : undefined;
  } catch {
    return undefined;
  }
}

async function fetchRefused(log: number, time: number): Promise<Refused[]> {
  try {
    const answer = await fetch(`/api/refused/${log}?time=${Math.round(time)}`);
    return answer.ok ? ((await answer.json()) as Refused[]) : [];
  } catch {
    return [];
  }
}
