// SPDX-License-Identifier: Apache-2.0
// What the page has to say of logs and connection, a line each that can be dismissed.
import { button, make } from "../app/dom";

export class Notes {
  readonly all: string[] = [];
  private readonly lines = new Map<string, HTMLElement>();

  constructor(private readonly element: HTMLElement) {}

  say(sentence: string, kind: "note" | "error" = "note"): void {
    if (this.all.includes(sentence)) return;
    this.all.push(sentence);
    const line = make(
      "div",
      { class: `note ${kind}` },
      make("span", { "aria-hidden": "true" }, kind === "error" ? "⚠" : "ℹ"),
      make("p", {}, sentence),
      button("×", `Dismiss: ${sentence}`, () => line.remove(), "quiet"),
    );
    this.lines.set(sentence, line);
    this.element.append(line);
    while (this.element.children.length > 4) this.element.firstElementChild!.remove();
  }

  // What is no longer so, and may be said again.
  take(sentence: string): void {
    this.lines.get(sentence)?.remove();
    this.lines.delete(sentence);
    const at = this.all.indexOf(sentence);
    if (at >= 0) this.all.splice(at, 1);
  }
}
