// SPDX-License-Identifier: Apache-2.0
// What vision found in an image, drawn over it: boxes with labels, the ball's circle, line points,
// borders of the carpet, the horizon. Coordinates are those of the image, in pixels.
import names from "kelpie:names";
import { flagAt, listAt, numberAt, structureAt } from "../reading/access";
import type { Structure } from "../reading/decoder";
import { TEAM_NAMES } from "../model/field";
import { shortNumber } from "../model/words";
import { HEIGHT, WIDTH } from "./pictures";

export interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
  label: string;
  colour: string;
}

const LINE_POINT_COLOURS = ["#ffe95c", "#7fe4ff", "#8dff9a"];

function boxAt(from: Structure, label: string, colour: string): Box[] {
  const side = (name: string) => numberAt(from, `box.${name}`);
  const [left, top, right, bottom] = ["left", "top", "right", "bottom"].map(side);
  if (left === undefined || top === undefined || right === undefined || bottom === undefined)
    return [];
  return [{ left, top, right, bottom, label, colour }];
}

const cm = (percept: Structure) => `${shortNumber(numberAt(percept, "distance") ?? 0)} cm`;

// All boxes of the percepts, with what stands beside them.
export function boxesOf(percepts: Structure | undefined): Box[] {
  const kinds = names.enums["LandmarkKind"]!;
  const boxes = [
    ...listAt(percepts, "landmarks").flatMap((p) =>
      boxAt(p, `${words(kinds[numberAt(p, "kind") ?? 0] ?? "landmark")}, ${cm(p)}`, "#ffffff"),
    ),
    ...listAt(percepts, "robots").flatMap((p) =>
      boxAt(
        p,
        `${TEAM_NAMES[numberAt(p, "team") === 1 ? 1 : 0]} robot, ${cm(p)}`,
        numberAt(p, "team") === 1 ? "#79a8ff" : "#ff7d74",
      ),
    ),
    ...listAt(percepts, "gaps").flatMap((p) => boxAt(p, "gap", "#7dff8a")),
    ...listAt(percepts, "pinkPatches").flatMap((p) => boxAt(p, `pink patch, ${cm(p)}`, "#ff9ad5")),
  ];
  return [...boxes, ...ballBox(structureAt(percepts, "ball"))];
}

function ballBox(ball: Structure | undefined): Box[] {
  const x = numberAt(ball, "centre.x");
  const y = numberAt(ball, "centre.y");
  const r = numberAt(ball, "radius");
  if (!ball || !flagAt(ball, "present") || x === undefined || y === undefined || r === undefined)
    return [];
  return [
    {
      left: x - r,
      top: y - r,
      right: x + r,
      bottom: y + r,
      label: `ball, ${cm(ball)}`,
      colour: "#ffa24a",
    },
  ];
}

// "beaconBlueOnPink" -> "beacon blue on pink".
export function words(name: string): string {
  return name.replace(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`);
}

function border(
  c: CanvasRenderingContext2D,
  from: Structure | undefined,
  colour: string,
  dashed: boolean,
): void {
  const left = numberAt(from, "atLeft");
  const right = numberAt(from, "atRight");
  if (left === undefined || right === undefined) return;
  c.strokeStyle = colour;
  c.setLineDash(dashed ? [4, 4] : []);
  c.beginPath();
  c.moveTo(0, left);
  c.lineTo(WIDTH, right);
  c.stroke();
  c.setLineDash([]);
}

// Draws over an image that fills the context's transform of WIDTH x HEIGHT; returns the boxes.
export function drawPercepts(
  c: CanvasRenderingContext2D,
  output: Structure | undefined,
  scale: number,
): Box[] {
  const percepts = structureAt(output, "percepts");
  c.lineWidth = 1.4 / scale;
  border(c, structureAt(output, "body.horizon"), "rgba(255,255,255,0.35)", true);
  for (const edge of listAt(percepts, "fieldEdges")) border(c, edge, "#7fe4ff", false);
  for (const point of listAt(percepts, "linePoints")) {
    c.fillStyle = LINE_POINT_COLOURS[numberAt(point, "kind") ?? 0] ?? "#fff";
    c.fillRect(
      (numberAt(point, "pixel.x") ?? -9) - 1,
      (numberAt(point, "pixel.y") ?? -9) - 1,
      2,
      2,
    );
  }
  const boxes = boxesOf(percepts);
  for (const box of boxes) drawBox(c, box, scale);
  return boxes;
}

export function drawBox(c: CanvasRenderingContext2D, box: Box, scale: number): void {
  c.strokeStyle = box.colour;
  if (box.label.startsWith("ball")) {
    c.beginPath();
    c.arc((box.left + box.right) / 2, (box.top + box.bottom) / 2, (box.right - box.left) / 2, 0, 7);
    c.stroke();
  } else c.strokeRect(box.left, box.top, box.right - box.left, box.bottom - box.top);
  if (box.label === "") return;
  c.font = `${10.5 / scale}px system-ui, sans-serif`;
  const wide = c.measureText(box.label).width + 6 / scale;
  const x = Math.min(Math.max(0, box.left), WIDTH - wide);
  const y = Math.min(Math.max(13 / scale, box.top - 2 / scale), HEIGHT - 2);
  c.fillStyle = "rgba(10,14,20,0.72)";
  c.fillRect(x, y - 11 / scale, wide, 13 / scale);
  c.fillStyle = box.colour;
  c.fillText(box.label, x + 3 / scale, y - 1 / scale);
}
