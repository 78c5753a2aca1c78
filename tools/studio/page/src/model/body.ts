// SPDX-License-Identifier: Apache-2.0
// The robot's body as the server describes it: a tree of links. From joint angles and the stance
// come the places of all links in the robot frame (x right, y ahead, z up from the ground).
import { Matrix4, Quaternion, Vector3 } from "three";

export type Triple = [number, number, number];
export interface Shape {
  size: Triple;
  centre: Triple;
  kind: "box" | "cylinder" | "sphere";
  paint: "shell" | "uniform" | "dark";
  axis?: Triple;
}
export interface Link {
  name: string;
  parent: string | null;
  origin: Triple;
  axis: Triple;
  joint: number;
  sign: number;
  shapes: Shape[];
}
export interface Body {
  links: Link[];
  camera?: { link: string; origin: Triple; opening: [number, number] };
  stance?: { joints?: number[]; shoulderHeight?: number; bodyTilt?: number };
}
export interface Stance {
  shoulderHeight: number;
  bodyTilt: number; // nose down positive
  bodyRoll: number; // left side up positive
}

// What a server sends, with one shape alone or a list of them.
interface SentBody {
  links?: (Partial<Omit<Link, "shapes">> & { name: string; shapes?: Shape | Shape[] })[];
  camera?: {
    link: string;
    origin?: Triple;
    opening?: [number, number];
    opening_rad?: [number, number];
  };
  stance?: Body["stance"];
}

export function bodyOf(sent: SentBody): Body {
  const links = (sent.links ?? []).map(
    (link) =>
      ({
        name: link.name,
        parent: link.parent || null,
        origin: link.origin ?? [0, 0, 0],
        axis: link.axis ?? [1, 0, 0],
        joint: link.joint ?? -1,
        sign: link.sign ?? 1,
        shapes: Array.isArray(link.shapes) ? link.shapes : link.shapes ? [link.shapes] : [],
      }) satisfies Link,
  );
  const body: Body = { links };
  if (sent.camera)
    body.camera = {
      link: sent.camera.link,
      origin: sent.camera.origin ?? [0, 0, 0],
      opening: sent.camera.opening ?? sent.camera.opening_rad ?? [1, 0.8],
    };
  if (sent.stance) body.stance = sent.stance;
  return body;
}

const NECK_TILT = 0; // joints in the order of the logs
const HEAD_PAN = 1;
const HEAD_NOD = 2;

export class BodyTree {
  readonly links: Link[];
  readonly headLinks: ReadonlySet<number>; // the camera's link and what hangs from it
  private readonly parents: number[];
  private readonly neck: Triple; // in the torso frame

  constructor(readonly body: Body) {
    this.links = body.links;
    const index = new Map(body.links.map((link, i) => [link.name, i]));
    this.parents = body.links.map((link) => index.get(link.parent ?? "") ?? -1);
    this.neck = body.links.find((link) => link.joint === NECK_TILT)?.origin ?? [0, 0, 0];
    this.headLinks = this.below(index.get(body.camera?.link ?? "") ?? -1);
  }

  private below(root: number): Set<number> {
    const found = new Set<number>(root >= 0 ? [root] : []);
    this.parents.forEach((parent, i) => found.has(parent) && found.add(i));
    return found;
  }

  // The links' frames in the robot frame.
  place(joints: readonly number[], stance: Stance, out: Matrix4[]): Matrix4[] {
    const turn = new Quaternion();
    const axis = new Vector3();
    const one = new Vector3(1, 1, 1);
    this.links.forEach((link, i) => {
      const matrix = (out[i] ??= new Matrix4());
      const angle = link.joint >= 0 ? link.sign * (joints[link.joint] ?? 0) : 0;
      turn.setFromAxisAngle(axis.set(...link.axis).normalize(), angle);
      matrix.compose(new Vector3(...link.origin), turn, one);
      const parent = this.parents[i]!;
      matrix.premultiply(parent >= 0 ? out[parent]! : this.torso(stance));
    });
    return out;
  }

  // The ground below the neck's base is the origin; the torso leans about its front shoulder axis.
  private torso(stance: Stance): Matrix4 {
    const sin = Math.sin(stance.bodyTilt);
    const cos = Math.cos(stance.bodyTilt);
    const ahead = -(this.neck[1] * cos + this.neck[2] * sin);
    const lean = new Matrix4().makeRotationX(-stance.bodyTilt);
    lean.setPosition(0, ahead, stance.shoulderHeight);
    if (stance.bodyRoll === 0) return lean;
    return lean.premultiply(rollAbout(stance.shoulderHeight, stance.bodyRoll));
  }
}

function rollAbout(height: number, roll: number): Matrix4 {
  const down = new Matrix4().makeTranslation(0, 0, -height);
  return new Matrix4()
    .makeTranslation(0, 0, height)
    .multiply(new Matrix4().makeRotationY(roll))
    .multiply(down);
}

// Pan and nod of a head whose camera looks along the direction (in the robot frame), by the angle
// of the neck: where a log keeps the camera but not the joints.
export function headTowards(joints: number[], stance: Stance, axes: readonly number[]): number[] {
  const neck = (joints[NECK_TILT] ?? 0) - stance.bodyTilt;
  const [x, y, z] = [axes[2] ?? 0, axes[5] ?? 1, axes[8] ?? 0];
  const ahead = Math.cos(neck) * y + Math.sin(neck) * z;
  const up = Math.cos(neck) * z - Math.sin(neck) * y;
  const turned = joints.slice();
  turned[HEAD_PAN] = Math.atan2(-x, ahead);
  turned[HEAD_NOD] = Math.asin(Math.min(1, Math.max(-1, up)));
  return turned;
}
