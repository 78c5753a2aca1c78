// SPDX-License-Identifier: Apache-2.0
// The page's keys. Where something is typed or chosen from a list they are left alone.
export type Keys = Record<string, () => void>;

function takesKeys(element: EventTarget | null, key: string): boolean {
  if (!(element instanceof HTMLElement)) return false;
  if (element.matches("textarea, select, input:not([type=checkbox])")) return true;
  return key === " " && element.matches("button, input, summary, [role=tab]");
}

export function listenToKeys(keys: Keys): void {
  window.addEventListener("keydown", (e) => {
    if (e.ctrlKey || e.metaKey || e.altKey || takesKeys(e.target, e.key)) return;
    if (document.querySelector("dialog[open]") && e.key !== "?") return;
    const act = keys[e.key];
    if (!act) return;
    e.preventDefault();
    act();
  });
}
