// SPDX-License-Identifier: Apache-2.0
// Ball and robots of a live match are dragged over the carpet by the pointer. While something is
// held the view does not turn.
import * as THREE from "three";
import type { Point } from "../model/field";
import type { Moment, RobotMoment } from "../model/moment";

const BALL_REACH = 14; // cm from the pointer's place on the carpet
const ROBOT_REACH = 16;

export type Held = { ball: true } | { robot: RobotMoment };

// What is nearest to a place of the carpet, and near enough to be meant.
export function heldAt(moment: Moment, place: Point): Held | undefined {
  if (moment.ball && Math.hypot(moment.ball.x - place.x, moment.ball.y - place.y) < BALL_REACH)
    return { ball: true };
  const robots = moment.robots.map((robot) => {
    const pose = robot.truth ?? robot.belief;
    const middle = pose && {
      x: pose.x - 7 * Math.cos(pose.heading),
      y: pose.y - 7 * Math.sin(pose.heading),
    };
    return { robot, away: middle ? Math.hypot(middle.x - place.x, middle.y - place.y) : Infinity };
  });
  const nearest = robots.sort((a, b) => a.away - b.away)[0];
  return nearest && nearest.away < ROBOT_REACH ? { robot: nearest.robot } : undefined;
}

export class Dragging {
  held: Held | undefined;
  place: Point | undefined; // on the carpet, where what is held would be put
  private readonly ray = new THREE.Raycaster();

  constructor(
    private readonly canvas: HTMLElement,
    private readonly camera: THREE.Camera,
    private readonly moment: () => Moment | undefined,
    private readonly turning: (on: boolean) => void,
    private readonly moved: () => void,
    private readonly dropped: (held: Held, place: Point) => void,
  ) {
    canvas.addEventListener("pointerdown", (e) => this.down(e), { capture: true });
    canvas.addEventListener("pointermove", (e) => this.move(e));
    canvas.addEventListener("pointerup", () => this.up());
    canvas.addEventListener("pointercancel", () => this.let());
  }

  private carpetAt(e: PointerEvent): Point | undefined {
    const box = this.canvas.getBoundingClientRect();
    const at = new THREE.Vector2(
      ((e.clientX - box.left) / box.width) * 2 - 1,
      1 - ((e.clientY - box.top) / box.height) * 2,
    );
    this.ray.setFromCamera(at, this.camera);
    const place = new THREE.Vector3();
    return this.ray.ray.intersectPlane(new THREE.Plane(new THREE.Vector3(0, 0, 1), -5), place)
      ? { x: place.x, y: place.y }
      : undefined;
  }

  private down(e: PointerEvent): void {
    const moment = this.moment();
    const place = this.carpetAt(e);
    if (e.button !== 0 || !moment || !place) return;
    this.held = heldAt(moment, place);
    if (!this.held) return;
    this.turning(false);
    this.canvas.setPointerCapture(e.pointerId);
  }

  private move(e: PointerEvent): void {
    if (!this.held) return;
    this.place = this.carpetAt(e);
    this.moved();
  }

  private up(): void {
    if (this.held && this.place) this.dropped(this.held, this.place);
    this.let();
  }

  private let(): void {
    if (!this.held) return;
    this.held = this.place = undefined;
    this.turning(true);
    this.moved();
  }
}
