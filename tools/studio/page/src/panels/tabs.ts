// SPDX-License-Identifier: Apache-2.0
// The lower part of the page: one panel of several, chosen by tabs.
import { make } from "../app/dom";

export class Tabs {
  readonly element = make("div", { class: "tabs", role: "tablist", "aria-label": "Lower panel" });
  readonly panels = make("div", { class: "tab-panels" });
  chosen = "";
  private readonly all = new Map<
    string,
    { tab: HTMLButtonElement; panel: HTMLElement; onTheme: () => void }
  >();

  constructor(private readonly changed: () => void) {
    this.element.addEventListener("keydown", (e) => this.move(e));
  }

  add(name: string, content: HTMLElement, onTheme: () => void = () => undefined): void {
    const id = `panel-${name.toLowerCase()}`;
    const tab = make(
      "button",
      { type: "button", role: "tab", "aria-controls": id, click: () => this.choose(name) },
      name,
    );
    const panel = make("div", { id, role: "tabpanel", "aria-label": name, hidden: true }, content);
    this.all.set(name, { tab, panel, onTheme });
    this.element.append(tab);
    this.panels.append(panel);
    this.choose(this.chosen || name);
  }

  choose(name: string): void {
    if (!this.all.has(name)) return;
    this.chosen = name;
    for (const [other, { tab, panel }] of this.all) {
      panel.hidden = other !== name;
      tab.setAttribute("aria-selected", String(other === name));
      tab.tabIndex = other === name ? 0 : -1;
    }
    this.changed();
  }

  themeChanged(): void {
    for (const { onTheme } of this.all.values()) onTheme();
  }

  private move(e: KeyboardEvent): void {
    const way = e.key === "ArrowRight" ? 1 : e.key === "ArrowLeft" ? -1 : 0;
    if (way === 0) return;
    const names = [...this.all.keys()];
    const next = names[(names.indexOf(this.chosen) + way + names.length) % names.length]!;
    this.choose(next);
    this.all.get(next)!.tab.focus();
    e.preventDefault();
    e.stopPropagation();
  }
}
