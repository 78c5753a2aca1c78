// SPDX-License-Identifier: Apache-2.0
// The behaviours of a live match as text, and the lines that the match prints. What is saved is
// taken over while it is played; a line says so.
import { button, make, text } from "../app/dom";
import { fetchJson } from "../model/session";

interface File {
  team: string;
  path: string;
}
const MOST_LINES = 200;

export class Editor {
  readonly element: HTMLElement;
  private readonly files = make("select", { "aria-label": "Behaviour file" });
  private readonly area = make("textarea", {
    "aria-label": "Text of the behaviour",
    spellcheck: "false",
    autocomplete: "off",
  });
  private readonly said = make("span", { class: "said", role: "status" });
  private readonly lines = make("div", {
    class: "log-lines",
    role: "log",
    "aria-label": "Lines of " + "the match",
    tabindex: "0",
  });
  private list: File[] = [];
  private saved = "";

  constructor(editable: boolean) {
    this.files.addEventListener("change", () => void this.open());
    this.area.addEventListener("keydown", (e) => this.key(e));
    this.area.addEventListener("input", () => this.mark());
    const tools = make(
      "div",
      { class: "tools" },
      this.files,
      button("Save", "Save the behaviour (Control and s)", () => void this.save(), "main"),
      button("Undo all", "Read the file again", () => void this.open()),
      this.said,
    );
    const editor = make("div", { class: "edit" }, tools, this.area);
    this.element = make("div", { class: "editor" }, ...(editable ? [editor] : []), this.lines);
    if (editable) void this.readList();
  }

  private get file(): File | undefined {
    return this.list[this.files.selectedIndex];
  }

  private async readList(): Promise<void> {
    try {
      this.list = await fetchJson<File[]>("/api/behaviours");
      this.files.replaceChildren(
        ...this.list.map(({ team, path }) => make("option", {}, `${team}: ${path}`)),
      );
      await this.open();
    } catch {
      text(this.said, "The behaviours cannot be read.");
    }
  }

  private address({ team, path }: File): string {
    return `/api/behaviour?team=${encodeURIComponent(team)}&path=${encodeURIComponent(path)}`;
  }

  private async open(): Promise<void> {
    if (!this.file) return;
    const answer = await fetch(this.address(this.file));
    const words = await answer.text();
    if (!answer.ok) return text(this.said, words.trim());
    this.area.value = this.saved = words;
    this.mark();
  }

  private async save(): Promise<void> {
    if (!this.file) return;
    const words = this.area.value;
    const answer = await fetch(this.address(this.file), { method: "PUT", body: words });
    if (!answer.ok) return text(this.said, errorOf(await answer.text()));
    this.saved = words;
    text(this.said, "saved");
  }

  private mark(): void {
    text(this.said, this.area.value === this.saved ? "" : "changed, not saved");
  }

  private key(e: KeyboardEvent): void {
    if ((e.ctrlKey || e.metaKey) && e.key === "s") {
      e.preventDefault();
      void this.save();
    }
  }

  addLine(line: string): void {
    const bottom = this.lines.scrollTop + this.lines.clientHeight >= this.lines.scrollHeight - 4;
    this.lines.append(make("p", { class: /error|refused/i.test(line) ? "bad" : "" }, line));
    while (this.lines.children.length > MOST_LINES) this.lines.firstElementChild!.remove();
    if (bottom) this.lines.scrollTop = this.lines.scrollHeight;
  }
}

function errorOf(answer: string): string {
  try {
    return (JSON.parse(answer) as { error?: string }).error ?? answer.trim();
  } catch {
    return answer.trim();
  }
}
