// SPDX-License-Identifier: Apache-2.0
// What the address keeps behind its #: time, chosen robot, view, layers and tab, so that a link
// shows the same again. What is malformed counts as absent.
export interface Kept {
  time?: number; // s
  robot?: string;
  view?: string;
  layers?: string[];
  tab?: string;
}

export function readHash(hash: string): Kept {
  const from = new URLSearchParams(hash.replace(/^#/, ""));
  const kept: Kept = {};
  const time = Number(from.get("t"));
  if (from.has("t") && Number.isFinite(time)) kept.time = time;
  const robot = from.get("robot");
  const view = from.get("view");
  const tab = from.get("tab");
  if (robot) kept.robot = robot;
  if (view) kept.view = view;
  if (tab) kept.tab = tab;
  if (from.has("layers")) kept.layers = (from.get("layers") ?? "").split(".").filter((l) => l);
  return kept;
}

export function writeHash(kept: Kept): string {
  const to = new URLSearchParams();
  if (kept.time !== undefined) to.set("t", kept.time.toFixed(3));
  if (kept.robot) to.set("robot", kept.robot);
  if (kept.view) to.set("view", kept.view);
  if (kept.layers) to.set("layers", kept.layers.join("."));
  if (kept.tab) to.set("tab", kept.tab);
  return `#${to.toString()}`;
}

// "?compare=0,1": the places of the two logs.
export function comparedOf(search: string): [number, number] | undefined {
  const match = /^(\d+),(\d+)$/.exec(new URLSearchParams(search).get("compare") ?? "");
  return match ? [Number(match[1]), Number(match[2])] : undefined;
}
