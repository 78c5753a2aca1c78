// SPDX-License-Identifier: Apache-2.0
// Light or dark, by the system until somebody chooses; the choice is kept in this browser.
const KEY = "kelpie-theme";

function stored(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

export class Theme {
  private readonly system = matchMedia("(prefers-color-scheme: dark)");

  constructor(private readonly changed: (dark: boolean) => void) {
    this.system.addEventListener("change", () => this.apply());
    this.apply();
  }

  get dark(): boolean {
    const chosen = stored();
    return chosen === null ? this.system.matches : chosen === "dark";
  }

  toggle(): string {
    const next = this.dark ? "light" : "dark";
    try {
      localStorage.setItem(KEY, next);
    } catch {
      // A browser that keeps nothing follows the system.
    }
    this.apply();
    return next;
  }

  private apply(): void {
    document.documentElement.dataset["theme"] = this.dark ? "dark" : "light";
    this.changed(this.dark);
  }
}
