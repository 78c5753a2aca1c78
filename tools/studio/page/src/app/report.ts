// SPDX-License-Identifier: Apache-2.0
// What tests and the measuring command read from the page: window.__kelpie.
import { Vector3 } from "three";
import type { Notes } from "../panels/notes";
import type { Studio } from "./studio";

export interface Report {
  openMs: number; // from the page's load to the first picture of the field with its robots
  readonly seekMs: number; // of the last seek for which something had to be read
  fps: number; // pictures of the field in the last second
  readonly time: number; // s
  readonly length: number; // s, of what can be shown
  readonly counts: Record<string, number>;
  readonly notes: readonly string[];
  readonly places: Record<string, Place>; // cm on the field, of "ball" and robots as "red-1"
  seek(seconds: number): Promise<number>; // ms until it is shown
  screenOf(place: Place): Place; // where a place of the carpet is on the page, px
}

interface Place {
  x: number;
  y: number;
}

declare global {
  interface Window {
    __kelpie?: Report;
  }
}

function countsOf(studio: Studio): Record<string, number> {
  const shown = studio.field?.shown;
  return {
    robots: shown?.robots ?? 0,
    ghosts: shown?.ghosts ?? 0,
    lines: shown?.lines ?? 0,
    beliefs: shown?.beliefs ?? 0,
    lanes: studio.match.robots.length,
    segments: studio.facts.segments,
    marks: studio.facts.marks.length,
    goals: studio.facts.marks.filter((m) => m.kind === "goal").length,
    boxes: studio.camera.boxes.length,
    differences: studio.timeLine.differences.length,
    draws: studio.field?.stage.drawnFrames ?? 0,
    calls: studio.field?.stage.renderer.info.render.calls ?? 0,
    triangles: studio.field?.stage.renderer.info.render.triangles ?? 0,
  };
}

function placesOf(studio: Studio): Record<string, Place> {
  const places: Record<string, Place> = {};
  for (const { key, truth, belief } of studio.moment?.robots ?? []) {
    const pose = truth ?? belief;
    if (pose) places[key] = { x: pose.x, y: pose.y };
  }
  const ball = studio.moment?.ball;
  if (ball) places.ball = { x: ball.x, y: ball.y };
  return places;
}

function screenOf(studio: Studio, place: Place): Place {
  const stage = studio.field?.stage;
  if (!stage) return { x: 0, y: 0 };
  const box = stage.renderer.domElement.getBoundingClientRect();
  const at = new Vector3(place.x, place.y, 5).project(stage.camera);
  return {
    x: box.left + ((at.x + 1) / 2) * box.width,
    y: box.top + ((1 - at.y) / 2) * box.height,
  };
}

const frame = () => new Promise((done) => requestAnimationFrame(done));

async function seek(studio: Studio, seconds: number): Promise<number> {
  const began = performance.now();
  studio.cursor.seek(seconds * 1e6);
  while (!studio.moment?.complete || studio.moment.time !== studio.cursor.time) await frame();
  const draws = studio.field?.stage.drawnFrames ?? 0;
  while (studio.field && studio.field.stage.drawnFrames === draws) await frame();
  return performance.now() - began;
}

export function report(studio: Studio, notes: Notes): void {
  const made: Report = {
    openMs: 0,
    fps: 0,
    get seekMs() {
      return studio.seekMs;
    },
    get time() {
      return studio.cursor.time / 1e6;
    },
    get length() {
      return (studio.cursor.to - studio.cursor.from) / 1e6;
    },
    get counts() {
      return countsOf(studio);
    },
    get places() {
      return placesOf(studio);
    },
    get notes() {
      return notes.all;
    },
    seek: (seconds) => seek(studio, seconds),
    screenOf: (place) => screenOf(studio, place),
  };
  window.__kelpie = made;
  const first = () => {
    if ((studio.field?.shown.robots ?? 0) > 0 || !studio.field) made.openMs = performance.now();
    else requestAnimationFrame(first);
  };
  first();
  let before = 0;
  setInterval(() => {
    const now = studio.field?.stage.drawnFrames ?? 0;
    made.fps = now - before;
    before = now;
  }, 1000);
}
