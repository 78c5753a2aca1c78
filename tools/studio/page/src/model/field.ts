// SPDX-License-Identifier: Apache-2.0
// The field of a log's configuration, and the frames of reference: everything is drawn on the red
// team's field, the blue team's is turned by half a turn. Centimetres and radians.
import names from "kelpie:names";
import { listAt, numberAt, valueAt } from "../reading/access";
import type { Structure } from "../reading/decoder";

export interface Point {
  x: number;
  y: number;
}
export interface Pose extends Point {
  heading: number;
}
export interface FieldLine {
  start: Point;
  end: Point;
}
export interface Landmark {
  kind: string;
  position: Point;
}
export interface Field {
  width: number;
  length: number;
  goalWidth: number;
  goalDepth: number;
  goalHeight: number;
  circleDiameter: number;
  lineWidth: number;
  sideFringe: number;
  endFringe: number;
  borderWidth: number;
  beaconRadius: number;
  beaconHeight: number;
  lines: FieldLine[];
  landmarks: Landmark[];
}
export type Team = 0 | 1; // red, blue

export const TEAM_NAMES = ["red", "blue"] as const;

export function pointAt(from: Structure | undefined, path: string): Point | undefined {
  const x = numberAt(from, `${path}.x`);
  const y = numberAt(from, `${path}.y`);
  return x === undefined || y === undefined ? undefined : { x, y };
}

export function poseAt(from: Structure | undefined, path: string): Pose | undefined {
  const place = pointAt(from, `${path}.position`);
  const heading = numberAt(from, `${path}.heading`);
  return place && heading !== undefined ? { ...place, heading } : undefined;
}

function lineOf(line: Structure): FieldLine[] {
  const start = pointAt(line, "start");
  const end = pointAt(line, "end");
  return start && end ? [{ start, end }] : [];
}

function landmarkOf(landmark: Structure): Landmark[] {
  const position = pointAt(landmark, "position");
  const kind = names.enums["LandmarkKind"]![numberAt(landmark, "kind") ?? -1];
  return position && kind ? [{ kind, position }] : [];
}

// Undefined where the configuration holds no field.
export function fieldOf(config: Structure | undefined): Field | undefined {
  const from = valueAt(config, "field") as Structure | undefined;
  const size = (name: string) => numberAt(from, name) ?? 0;
  if (size("width") === 0 || size("length") === 0) return undefined;
  return {
    width: size("width"),
    length: size("length"),
    goalWidth: size("goalWidth"),
    goalDepth: size("goalDepth"),
    goalHeight: size("goalHeight"),
    circleDiameter: size("circleDiameter"),
    lineWidth: size("lineWidth"),
    sideFringe: size("sideFringe"),
    endFringe: size("endFringe"),
    borderWidth: size("borderWidth"),
    beaconRadius: size("beaconRadius"),
    beaconHeight: size("beaconHeight"),
    lines: listAt(from, "lines").flatMap(lineOf),
    landmarks: listAt(from, "landmarks").flatMap(landmarkOf),
  };
}

// From a team's own field to the red team's.
export class MapFrame {
  constructor(
    private readonly field: Field,
    private readonly team: Team,
  ) {}

  point(p: Point): Point {
    return this.team === 0 ? p : { x: this.field.width - p.x, y: this.field.length - p.y };
  }
  direction(p: Point): Point {
    return this.team === 0 ? p : { x: -p.x, y: -p.y };
  }
  pose(p: Pose): Pose {
    return { ...this.point(p), heading: this.team === 0 ? p.heading : p.heading + Math.PI };
  }
}

// A point of the robot frame (x right, y ahead) on the field.
export function fieldFromRobot(pose: Pose, p: Point): Point {
  const sin = Math.sin(pose.heading);
  const cos = Math.cos(pose.heading);
  return { x: pose.x + sin * p.x + cos * p.y, y: pose.y - cos * p.x + sin * p.y };
}

export function between(a: number, b: number, share: number): number {
  return a + share * (b - a);
}

export function angleBetween(a: number, b: number, share: number): number {
  const turn = Math.atan2(Math.sin(b - a), Math.cos(b - a));
  return a + share * turn;
}

export function poseBetween(a: Pose, b: Pose, share: number): Pose {
  return {
    x: between(a.x, b.x, share),
    y: between(a.y, b.y, share),
    heading: angleBetween(a.heading, b.heading, share),
  };
}
