// SPDX-License-Identifier: Apache-2.0
// Teams, score, clock and state of the match, which logs are shown, and the theme.
import { button, make, text } from "../app/dom";
import { icon } from "../app/icons";
import { flagAt, numberAt } from "../reading/access";
import type { Moment } from "../model/moment";
import { clockOf, stateName } from "../model/words";

export class TitleBar {
  private readonly red = make("b", { class: "score red" }, "–");
  private readonly blue = make("b", { class: "score blue" }, "–");
  private readonly clock = make("span", { class: "clock" });
  private readonly state = make("span", { class: "state" });
  private readonly which = make("span", { class: "which" });

  constructor(element: HTMLElement, onHelp: () => void, onTheme: () => string) {
    const theme = button(
      icon("theme"),
      "Light or dark",
      () => {
        theme.title = `Theme: ${onTheme()}`;
      },
      "quiet",
    );
    element.append(
      make("h1", {}, "Kelpie ", make("span", {}, "studio")),
      make(
        "div",
        { class: "teams", role: "group", "aria-label": "Score" },
        make("span", { class: "team red" }, "Red ▲"),
        this.red,
        make("i", {}, ":"),
        this.blue,
        make("span", { class: "team blue" }, "▼ Blue"),
      ),
      make("div", { class: "when" }, this.clock, this.state),
      this.which,
      theme,
      button("?", "Keys and help", onHelp, "quiet"),
    );
    element.querySelector(".team.red")!.setAttribute("title", "Red attacks the blue goal");
    element.querySelector(".team.blue")!.setAttribute("title", "Blue attacks the yellow goal");
  }

  names(logs: string, version: string): void {
    text(this.which, logs);
    this.which.title = `${logs}; Kelpie ${version}`;
  }

  show(moment: Moment): void {
    text(this.red, moment.score ? String(moment.score[0]) : "–");
    text(this.blue, moment.score ? String(moment.score[1]) : "–");
    text(this.clock, clockOf(moment.time / 1e6, true));
    const game = moment.game;
    if (!game) return text(this.state, "");
    const half = flagAt(game, "firstHalf") ? "first half" : "second half";
    const left = clockOf(numberAt(game, "secondsLeft") ?? 0);
    const kickOff = flagAt(game, "kickOff")
      ? `, kick-off of ${numberAt(game, "team") === 1 ? "blue" : "red"}`
      : "";
    text(
      this.state,
      `${half}, ${stateName({ ...game, penalised: false })}${kickOff}, ${left} left`,
    );
  }
}
