// SPDX-License-Identifier: Apache-2.0
// The robots of the match as a list to choose from, and of the chosen one what it decided at this
// time, from the player down, with some numbers.
import { make, text } from "../app/dom";
import { numberAt, structureAt } from "../reading/access";
import { TEAM_NAMES } from "../model/field";
import type { RobotMoment } from "../model/moment";
import { decisionsOf, fallbackOf, legsOf, roleName, sentenceOf, shortNumber } from "../model/words";

const NO_LOG = "There is no log of this robot.";

export class RobotList {
  readonly element = make("div", { class: "robots", role: "radiogroup", "aria-label": "Robots" });
  private readonly buttons = new Map<string, HTMLButtonElement>();

  constructor(private readonly pick: (key: string) => void) {
    this.element.addEventListener("keydown", (e) => this.move(e));
  }

  show(robots: readonly RobotMoment[], selected: string): void {
    const before = this.buttons.size;
    robots.forEach((robot, i) => this.buttonOf(robot, i));
    // Of a live match the robots become known in any order.
    if (this.buttons.size > before)
      this.element.append(...robots.flatMap((robot) => this.buttons.get(robot.key) ?? []));
    for (const [key, button] of this.buttons) {
      button.setAttribute("aria-checked", String(key === selected));
      button.tabIndex = key === selected || (selected === "" && key === robots[0]?.key) ? 0 : -1;
      button.hidden = !robots.some((r) => r.key === key);
    }
  }

  private buttonOf(robot: RobotMoment, index: number): void {
    if (this.buttons.has(robot.key)) return;
    const name = `${TEAM_NAMES[robot.team]} ${robot.player}`;
    const button = make(
      "button",
      {
        type: "button",
        role: "radio",
        class: TEAM_NAMES[robot.team],
        "aria-label": name,
        title: `${name} (key ${index + 1})`,
        click: () => this.pick(robot.key),
      },
      make("small", {}, TEAM_NAMES[robot.team][0]!.toUpperCase()),
      String(robot.player),
    );
    this.buttons.set(robot.key, button);
    this.element.append(button);
  }

  private move(e: KeyboardEvent): void {
    const way =
      e.key === "ArrowRight" || e.key === "ArrowDown"
        ? 1
        : e.key === "ArrowLeft" || e.key === "ArrowUp"
          ? -1
          : 0;
    if (way === 0) return;
    const keys = [...this.buttons.keys()].sort(
      (a, b) => b.slice(0, 1).localeCompare(a.slice(0, 1)) || a.localeCompare(b),
    );
    const now = keys.findIndex((k) => this.buttons.get(k) === document.activeElement);
    const next = keys[(now + way + keys.length) % keys.length]!;
    this.pick(next);
    this.buttons.get(next)!.focus();
    e.preventDefault();
    e.stopPropagation();
  }
}

export class ReasonPanel {
  readonly element: HTMLElement;
  private readonly list = make("ol", { class: "reasons" });
  private readonly numbers = make("dl", { class: "numbers" });
  private shown = "";

  constructor() {
    this.element = make(
      "section",
      { class: "panel", "aria-label": "Decisions of this robot" },
      make("div", { class: "head" }, make("h2", {}, "Why")),
      this.list,
      this.numbers,
    );
  }

  show(robot: RobotMoment | undefined): void {
    this.showReasons(robot);
    this.showNumbers(robot);
  }

  private showReasons(robot: RobotMoment | undefined): void {
    const command = structureAt(robot?.output, "command");
    const instead = fallbackOf(command);
    const steps = decisionsOf(command);
    const known = robot?.output !== undefined;
    const key = `${instead}${JSON.stringify(steps)}${robot?.key ?? ""}${known}`;
    if (key === this.shown) return;
    this.shown = key;
    const said =
      instead || (known ? "No reason is given." : robot ? NO_LOG : "Choose a robot above.");
    this.list.replaceChildren(
      ...(steps.length > 0 && instead === ""
        ? steps.map((step) =>
            make(
              "li",
              { title: sentenceOf(step) },
              make("span", { class: "who" }, `${step.module || step.layer}`),
              make("b", {}, step.branch || "?"),
              make("span", { class: "why" }, step.reason),
            ),
          )
        : [make("li", {}, said)]),
    );
  }

  private showNumbers(robot: RobotMoment | undefined): void {
    const rows = robot?.output ? numbersOf(robot) : [];
    while (this.numbers.children.length > 2 * rows.length) this.numbers.lastElementChild!.remove();
    rows.forEach(([name, value], i) => {
      if (this.numbers.children.length <= 2 * i) this.numbers.append(make("dt"), make("dd"));
      text(this.numbers.children[2 * i]!, name);
      text(this.numbers.children[2 * i + 1]!, value);
    });
  }
}

function numbersOf(robot: RobotMoment): [string, string][] {
  const output = robot.output;
  const number = (path: string) => numberAt(output, path);
  const ball =
    number("world.ball.present") === 1
      ? `${shortNumber(number("world.ball.distance") ?? 0)} cm, seen ` +
        `${shortNumber(number("world.ball.secondsSinceSeen") ?? 0)} s ago`
      : "none";
  const { truth, belief } = robot;
  const wrong = truth && belief ? Math.hypot(truth.x - belief.x, truth.y - belief.y) : undefined;
  const away = wrong === undefined ? "" : `, ${shortNumber(wrong)} cm off`;
  const time = number("command.team.timeToBall") ?? 1000;
  return [
    ["Role", roleName(number("command.team.role"))],
    ["Legs", legsOf(structureAt(output, "command"))],
    ["Pose", `sure to ${shortNumber(number("world.positionSd") ?? 0)} cm${away}`],
    ["Ball", ball],
    ["At the ball in", time < 1000 ? `${shortNumber(time)} s` : "does not go"],
  ];
}
