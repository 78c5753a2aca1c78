// SPDX-License-Identifier: Apache-2.0
// Where the scene is looked at from: by the pointer, behind a robot, through its camera, as on
// television, or from above. Moves are smooth in time of the screen and end by themselves.
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { BodyTree } from "../model/body";
import type { Field, Point } from "../model/field";
import { robotMatrix, type ShownRobot } from "./robots";

export const VIEWS = ["broadcast", "orbit", "follow", "eye", "above"] as const;
export type ViewName = (typeof VIEWS)[number];

interface Goal {
  position: THREE.Vector3;
  target: THREE.Vector3;
  fov: number;
  up: THREE.Vector3;
}

const UP = new THREE.Vector3(0, 0, 1);

export class Views {
  mode: ViewName = "broadcast";
  readonly controls: OrbitControls;
  private readonly target = new THREE.Vector3();
  private readonly play = new THREE.Vector2(); // what broadcast follows, smoothed
  private started = false;
  private everPlaced = false;

  constructor(
    private readonly camera: THREE.PerspectiveCamera,
    element: HTMLElement,
    private readonly field: Field,
    private readonly tree: BodyTree,
    changed: () => void,
  ) {
    this.controls = new OrbitControls(camera, element);
    this.controls.enableDamping = false;
    this.controls.maxPolarAngle = Math.PI / 2 - 0.02;
    this.controls.minDistance = 25;
    this.controls.maxDistance = 1400;
    this.controls.addEventListener("change", changed);
    this.controls.addEventListener("start", () => this.takeOver());
    this.play.set(field.width / 2, field.length / 2);
  }

  // Who turns the view by the pointer goes on from where it stands.
  onTakenOver: () => void = () => undefined;
  private takeOver(): void {
    if (this.mode === "orbit") return;
    this.mode = "orbit";
    this.onTakenOver();
  }

  // After a jump in time the view is where it belongs, without a way there.
  jump(): void {
    this.started = false;
  }

  setMode(mode: ViewName): void {
    this.mode = mode;
    this.controls.enabled = true;
    this.controls.target.copy(this.target);
    this.camera.up.copy(UP);
    if (mode === "orbit" && this.everPlaced) this.controls.update();
  }

  // Moves towards the goal; true while there is some way left.
  step(robot: ShownRobot | undefined, ball: Point | undefined, seconds: number): boolean {
    if (this.mode === "orbit" && this.everPlaced) return false;
    const goal = this.goalOf(robot, ball, seconds);
    const rigid = this.mode === "eye" || !this.started;
    const share = rigid ? 1 : 1 - Math.exp(-seconds / (this.mode === "broadcast" ? 0.5 : 0.25));
    this.camera.position.lerp(goal.position, share);
    this.target.lerp(goal.target, share);
    this.camera.up.copy(goal.up);
    this.camera.fov += share * (goal.fov - this.camera.fov);
    this.camera.updateProjectionMatrix();
    this.camera.lookAt(this.target);
    this.controls.target.copy(this.target);
    this.started = this.everPlaced = true;
    return (
      this.camera.position.distanceTo(goal.position) > 0.3 ||
      this.target.distanceTo(goal.target) > 0.3
    );
  }

  private goalOf(robot: ShownRobot | undefined, ball: Point | undefined, seconds: number): Goal {
    if (this.mode === "above") return this.above();
    if (this.mode === "eye" && robot) return this.eye(robot);
    if (this.mode === "follow" && robot) return follow(robot);
    return this.broadcast(ball, seconds);
  }

  private broadcast(ball: Point | undefined, seconds: number): Goal {
    const { width, length } = this.field;
    const wanted = ball ?? { x: width / 2, y: length / 2 };
    const share = this.started ? 1 - Math.exp(-seconds / 0.7) : 1;
    this.play.lerp(new THREE.Vector2(wanted.x, wanted.y), share);
    const along = THREE.MathUtils.clamp(this.play.y, 0.25 * length, 0.75 * length);
    const near = this.camera.aspect > 2 ? 0.9 : 1;
    return {
      position: new THREE.Vector3(
        -0.58 * width * near,
        length / 2 + 0.5 * (along - length / 2),
        0.6 * width,
      ),
      target: new THREE.Vector3(width / 2 + 0.22 * (this.play.x - width / 2), along, 0),
      fov: 40,
      up: UP,
    };
  }

  private above(): Goal {
    const { width, length } = this.field;
    const across = length + 70;
    const down = width + 60;
    const half = Math.tan(THREE.MathUtils.degToRad(15));
    const height = Math.max(down / (2 * half), across / (2 * half * this.camera.aspect));
    const middle = new THREE.Vector3(width / 2, length / 2, 0);
    return {
      position: middle.clone().setZ(height),
      target: middle,
      fov: 30,
      up: new THREE.Vector3(1, 0, 0),
    };
  }

  // Through the camera of the head, as its joints and the body put it.
  private eye(robot: ShownRobot): Goal {
    const place = cameraPlace(robot, this.tree);
    const ahead = new THREE.Vector3().setFromMatrixColumn(place, 1);
    const position = new THREE.Vector3().setFromMatrixPosition(place);
    const vertical = this.tree.body.camera?.opening[1] ?? 0.8;
    return {
      position,
      target: position.clone().addScaledVector(ahead, 60),
      fov: THREE.MathUtils.radToDeg(2 * Math.atan(Math.tan(vertical / 2) / EYE_SHARE)),
      up: new THREE.Vector3().setFromMatrixColumn(place, 2),
    };
  }
}

export const EYE_SHARE = 0.86; // of the height of the view that the robot's image takes

// The camera's frame on the field: x right, y along its axis, z up.
export function cameraPlace(robot: ShownRobot, tree: BodyTree): THREE.Matrix4 {
  const places = tree.place(robot.joints, robot.stance, []);
  const index = tree.links.findIndex((link) => link.name === tree.body.camera?.link);
  const place = robotMatrix(robot.pose).multiply(places[Math.max(0, index)]!);
  const [x, y, z] = tree.body.camera?.origin ?? [0, 0, 0];
  return place.multiply(new THREE.Matrix4().makeTranslation(x, y, z));
}

function follow(robot: ShownRobot): Goal {
  const ahead = new THREE.Vector3(Math.cos(robot.pose.heading), Math.sin(robot.pose.heading), 0);
  const here = new THREE.Vector3(robot.pose.x, robot.pose.y, 12);
  return {
    position: here.clone().addScaledVector(ahead, -85).setZ(52),
    target: here.clone().addScaledVector(ahead, 30),
    fov: 48,
    up: UP,
  };
}
