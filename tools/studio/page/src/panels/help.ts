// SPDX-License-Identifier: Apache-2.0
// All keys, in a dialogue.
import { button, make } from "../app/dom";

const KEYS: [string, string][] = [
  ["Space", "play or stop"],
  ["← →", "a frame back or on"],
  ["[ ]", "a second, or the event before or behind"],
  ["Home End", "beginning, end (of a live match: follow it)"],
  ["1 … 8", "choose a robot"],
  ["Escape", "choose none: what all robots believe is drawn"],
  ["v", "next view: broadcast, free, follow, robot’s eye, above"],
  ["+ − 0", "zoom the time in and out, show all of it"],
  ["l", "layers"],
  ["d", "first frame that differs, in a comparison"],
  ["Page Up, Page Down", "in the lanes: decision before or behind"],
  ["t", "light or dark"],
  ["?", "this help"],
];

export class Help {
  readonly element: HTMLDialogElement;

  constructor() {
    this.element = make(
      "dialog",
      { "aria-label": "Keys" },
      make("h2", {}, "Keys"),
      make(
        "dl",
        {},
        ...KEYS.flatMap(([key, what]) => [
          make("dt", {}, ...key.split(" ").flatMap((k) => [make("kbd", {}, k), " "])),
          make("dd", {}, what),
        ]),
      ),
      make(
        "p",
        {},
        "Drag on the field to turn the view, with the right button to move it, wheel to " +
          "come nearer. On the time line the wheel zooms, with Shift it moves.",
      ),
      button("Close", "Close", () => this.element.close(), "main"),
    );
  }

  toggle(): void {
    if (this.element.open) this.element.close();
    else this.element.showModal();
  }
}
