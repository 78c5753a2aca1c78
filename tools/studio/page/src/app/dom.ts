// SPDX-License-Identifier: Apache-2.0
// Short ways to make elements of the page.
type Attributes = Record<string, string | boolean | ((event: Event) => void)>;

// A function is a listener for the event of that name, false leaves an attribute away.
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false) element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}

export function button(
  label: string | Node,
  name: string,
  act: () => void,
  className = "",
): HTMLButtonElement {
  return make(
    "button",
    { type: "button", "aria-label": name, title: name, class: className, click: act },
    label,
  );
}

export function text(element: Element, words: string): void {
  if (element.textContent !== words) element.textContent = words;
}

export function byId(id: string): HTMLElement {
  const element = document.getElementById(id);
  if (!element) throw new Error(`the page has no ${id}`);
  return element;
}

// A canvas that is as sharp as the screen. Its pixels stay in the computer's own memory: many small
// rectangles are slow where the graphics card is a program, too.
export function fitCanvas(canvas: HTMLCanvasElement, width: number, height: number) {
  const ratio = Math.min(2, window.devicePixelRatio || 1);
  const w = Math.max(1, Math.round(width * ratio));
  const h = Math.max(1, Math.round(height * ratio));
  if (canvas.width !== w) canvas.width = w;
  if (canvas.height !== h) canvas.height = h;
  const context = canvas.getContext("2d", { willReadFrequently: true })!;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  return context;
}

export interface Inks {
  [name: string]: string;
}

// Colours of the theme, as the style sheet has them.
export function inks(names: readonly string[]): Inks {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(
    names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]),
  );
}

// Calls the function once for the next picture, however often it is asked, or only after a while.
export function atNextPicture(act: () => void): { now: () => void; soon: () => void } {
  let wanted = false;
  let timer = 0;
  const now = () => {
    if (wanted) return;
    wanted = true;
    requestAnimationFrame(() => {
      wanted = false;
      act();
    });
  };
  const soon = () => {
    if (timer !== 0) return;
    timer = window.setTimeout(() => {
      timer = 0;
      now();
    }, 400);
  };
  return { now, soon };
}
