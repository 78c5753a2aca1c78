// SPDX-License-Identifier: Apache-2.0
// Orders to a live match: pause, step, speed, and where ball and robots are put, typed or dragged
// on the field. What the match refuses is said beside.
import { button, make, text } from "../app/dom";
import { TEAM_NAMES, type Point, type Team } from "../model/field";
import type { Moment } from "../model/moment";

export interface Orders {
  send(order: Record<string, unknown>): Promise<string>; // empty, or why not
}

export const httpOrders: Orders = {
  async send(order) {
    try {
      const answer = await fetch("/api/control", {
        method: "POST",
        headers: { "Content-Type": "application/json" },
        body: JSON.stringify(order),
      });
      if (answer.ok) return "";
      const said = (await answer.json().catch(() => ({}))) as { error?: string };
      return said.error ?? `The match answers ${answer.status}.`;
    } catch {
      return "The match does not answer.";
    }
  },
};

const SPEEDS: [string, string][] = [
  ["0.5", "half"],
  ["1", "as the clock"],
  ["2", "2 ×"],
  ["4", "4 ×"],
  ["8", "8 ×"],
  ["0", "as fast as it goes"],
];

export class LivePanel {
  readonly element: HTMLElement;
  paused = false;
  private readonly said = make("span", { class: "said", role: "status" });
  private readonly pause: HTMLButtonElement;
  private readonly what = make("select", { "aria-label": "What is put", class: "what" });
  private readonly x = numberBox("x, cm across the field");
  private readonly y = numberBox("y, cm along the field");
  private readonly heading = numberBox("heading, degrees");
  private moment: Moment | undefined;

  constructor(private readonly orders: Orders) {
    this.pause = button("Pause match", "Pause or resume the match", () => void this.togglePause());
    const speed = make(
      "select",
      { "aria-label": "Speed of the match" },
      ...SPEEDS.map(([value, name]) => make("option", { value, selected: value === "1" }, name)),
    );
    speed.addEventListener(
      "change",
      () => void this.order({ do: "speed", factor: Number(speed.value) }),
    );
    this.what.append(make("option", { value: "ball" }, "ball"));
    this.what.addEventListener("change", () => this.fill());
    const form = make(
      "form",
      {
        class: "put",
        submit: (e) => {
          e.preventDefault();
          this.put();
        },
      },
      make("span", {}, "Put"),
      this.what,
      this.x,
      this.y,
      this.heading,
      make("button", { type: "submit" }, "put"),
    );
    this.element = make(
      "div",
      { class: "live", role: "group", "aria-label": "Live match" },
      make("span", { class: "badge" }, "live"),
      this.pause,
      button("Step", "One frame of the match", () => void this.order({ do: "step", frames: 1 })),
      speed,
      form,
      this.said,
    );
  }

  show(moment: Moment): void {
    this.moment = moment;
    const keys = moment.robots.map((r) => r.key);
    if (this.what.options.length === keys.length + 1) return;
    this.what.replaceChildren(
      make("option", { value: "ball" }, "ball"),
      ...moment.robots.map((r) =>
        make("option", { value: r.key }, `${TEAM_NAMES[r.team]} ${r.player}`),
      ),
    );
    this.fill();
  }

  // The place where it is now, to begin with.
  private fill(): void {
    const robot = this.moment?.robots.find((r) => r.key === this.what.value);
    const place = robot ? (robot.truth ?? robot.belief) : this.moment?.ball;
    this.heading.hidden = !robot;
    this.x.value = place ? place.x.toFixed(0) : "";
    this.y.value = place ? place.y.toFixed(0) : "";
    const heading = robot?.truth?.heading ?? robot?.belief?.heading ?? 0;
    this.heading.value = ((heading * 180) / Math.PI).toFixed(0);
  }

  private put(): void {
    const place = { x: Number(this.x.value), y: Number(this.y.value) };
    const robot = this.moment?.robots.find((r) => r.key === this.what.value);
    if (robot) void this.putRobot(robot.team, robot.player, place, Number(this.heading.value));
    else void this.putBall(place);
  }

  putBall(place: Point): Promise<void> {
    return this.order({ do: "ball", x: place.x, y: place.y });
  }

  putRobot(team: Team, player: number, place: Point, degrees: number): Promise<void> {
    return this.order({
      do: "robot",
      team: TEAM_NAMES[team],
      player,
      x: place.x,
      y: place.y,
      heading_deg: degrees,
    });
  }

  async togglePause(): Promise<void> {
    await this.order({ do: this.paused ? "resume" : "pause" });
    if (this.said.textContent !== "") return;
    this.paused = !this.paused;
    text(this.pause, this.paused ? "Resume match" : "Pause match");
  }

  async order(order: Record<string, unknown>): Promise<void> {
    text(this.said, "");
    text(this.said, await this.orders.send(order));
  }
}

function numberBox(name: string): HTMLInputElement {
  return make("input", { type: "number", step: "any", "aria-label": name, title: name });
}
