// SPDX-License-Identifier: Apache-2.0
// All robots at once: one instanced mesh for each link and kind of paint, with the uniform's colour
// by instance. A second, transparent set shows where they believe to be.
import * as THREE from "three";
import { BodyTree, type Stance } from "../model/body";
import type { Pose, Team } from "../model/field";
import { coloured, merged, shapeGeometry } from "./shapes";

export const TEAM_COLOURS = [0xe0342b, 0x2f6fe4] as const;
const PAINT = { shell: 0xf1f2f4, dark: 0x33363d, uniform: 0xffffff };
const MOST = 8;
const WHITE = new THREE.Color(0xffffff);

export interface ShownRobot {
  pose: Pose;
  team: Team;
  player: number;
  joints: readonly number[];
  stance: Stance;
  hideHead: boolean;
}

interface Part {
  link: number;
  mesh: THREE.InstancedMesh;
  uniform: boolean;
}

export class RobotMeshes {
  readonly group = new THREE.Group();
  private readonly parts: Part[] = [];
  private readonly places: THREE.Matrix4[] = [];
  private readonly base = new THREE.Matrix4();
  private readonly matrix = new THREE.Matrix4();
  private readonly colour = new THREE.Color();

  constructor(
    private readonly tree: BodyTree,
    ghost: boolean,
  ) {
    tree.links.forEach((link, i) => {
      const plain = link.shapes.filter((s) => s.paint !== "uniform");
      const uniform = link.shapes.filter((s) => s.paint === "uniform");
      for (const shapes of [plain, uniform]) {
        if (shapes.length === 0) continue;
        const geometry = merged(shapes.map((s) => coloured(shapeGeometry(s), PAINT[s.paint])));
        this.add(geometry, i, shapes === uniform, ghost);
      }
    });
  }

  private add(geometry: THREE.BufferGeometry, link: number, uniform: boolean, ghost: boolean) {
    const material = new THREE.MeshLambertMaterial({
      vertexColors: true,
      transparent: ghost,
      opacity: ghost ? 0.28 : 1,
      depthWrite: !ghost,
    });
    const mesh = new THREE.InstancedMesh(geometry, material, MOST);
    mesh.count = 0;
    mesh.frustumCulled = false;
    mesh.castShadow = !ghost;
    mesh.receiveShadow = false;
    // All parts have a colour of their own, white where the uniform is not, so that one shader
    // draws them.
    for (let i = 0; i < MOST; ++i) mesh.setColorAt(i, WHITE);
    this.parts.push({ link, mesh, uniform: uniform || ghost });
    this.group.add(mesh);
  }

  show(robots: readonly ShownRobot[]): void {
    const count = Math.min(robots.length, MOST);
    this.group.visible = count > 0;
    for (const part of this.parts) part.mesh.count = count;
    for (let i = 0; i < count; ++i) this.place(robots[i]!, i);
    for (const { mesh, uniform } of this.parts) {
      mesh.instanceMatrix.needsUpdate = true;
      if (uniform && mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
    }
  }

  private place(robot: ShownRobot, instance: number): void {
    this.tree.place(robot.joints, robot.stance, this.places);
    robotMatrix(robot.pose, this.base);
    this.colour.set(TEAM_COLOURS[robot.team]);
    for (const { link, mesh, uniform } of this.parts) {
      this.matrix.multiplyMatrices(this.base, this.places[link]!);
      if (robot.hideHead && this.tree.headLinks.has(link)) this.matrix.makeScale(0, 0, 0);
      mesh.setMatrixAt(instance, this.matrix);
      if (uniform) mesh.setColorAt(instance, this.colour);
    }
  }
}

// From the robot frame (x right, y ahead) to the field.
export function robotMatrix(pose: Pose, out = new THREE.Matrix4()): THREE.Matrix4 {
  out.makeRotationZ(pose.heading - Math.PI / 2);
  return out.setPosition(pose.x, pose.y, 0);
}

// The player's number on its back, readable from above and behind.
export class NumberPlates {
  readonly group = new THREE.Group();
  private readonly meshes: THREE.InstancedMesh[];
  private readonly back: THREE.Matrix4; // in the frame of the body's first link
  private readonly places: THREE.Matrix4[] = [];
  private readonly matrix = new THREE.Matrix4();

  constructor(private readonly tree: BodyTree) {
    const shapes = tree.links[0]?.shapes ?? [];
    const top = Math.max(0, ...shapes.map((s) => s.centre[2] + s.size[2] / 2));
    const along = shapes[0]?.centre[1] ?? 0;
    this.back = new THREE.Matrix4().makeTranslation(0, along, top + 0.12);
    const material = new THREE.MeshBasicMaterial({
      map: digits(),
      transparent: true,
      depthWrite: false,
    });
    this.meshes = [0, 1, 2, 3].map((i) => {
      const mesh = new THREE.InstancedMesh(plate(i), material, MOST);
      mesh.frustumCulled = false;
      this.group.add(mesh);
      return mesh;
    });
  }

  show(robots: readonly ShownRobot[]): void {
    for (const mesh of this.meshes) mesh.count = 0;
    for (const robot of robots.slice(0, MOST)) {
      const mesh = this.meshes[robot.player - 1];
      if (!mesh || this.tree.links.length === 0) continue;
      this.tree.place(robot.joints, robot.stance, this.places);
      robotMatrix(robot.pose, this.matrix).multiply(this.places[0]!).multiply(this.back);
      mesh.setMatrixAt(mesh.count++, this.matrix);
      mesh.instanceMatrix.needsUpdate = true;
    }
  }
}

const PLATE = 6.4; // cm

function plate(i: number): THREE.BufferGeometry {
  const geometry = new THREE.PlaneGeometry(PLATE, PLATE);
  const uv = geometry.getAttribute("uv");
  for (let k = 0; k < uv.count; ++k) uv.setX(k, (uv.getX(k) + i) / 4);
  return geometry;
}

function digits(): THREE.Texture {
  const canvas = document.createElement("canvas");
  canvas.width = 256;
  canvas.height = 64;
  const c = canvas.getContext("2d")!;
  c.font = "bold 58px system-ui, sans-serif";
  c.textAlign = "center";
  c.textBaseline = "middle";
  c.fillStyle = "#ffffff";
  for (let i = 0; i < 4; ++i) c.fillText(String(i + 1), 64 * i + 32, 35);
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  return texture;
}

// Soft dark spots where robots and ball touch the carpet: they tell where something stands at a
// small part of the cost of the sun's shadows.
export class ContactShadows {
  readonly mesh: THREE.InstancedMesh;
  private readonly matrix = new THREE.Matrix4();

  constructor() {
    const material = new THREE.MeshBasicMaterial({
      map: spot(),
      transparent: true,
      depthWrite: false,
      polygonOffset: true,
      polygonOffsetFactor: -3,
      polygonOffsetUnits: -3,
    });
    this.mesh = new THREE.InstancedMesh(new THREE.PlaneGeometry(1, 1), material, MOST + 1);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 1;
  }

  show(robots: readonly ShownRobot[], ball: { x: number; y: number } | undefined): void {
    let count = 0;
    for (const { pose } of robots.slice(0, MOST)) {
      this.matrix.makeRotationZ(pose.heading).scale(new THREE.Vector3(34, 23, 1));
      this.matrix.setPosition(
        pose.x - 5 * Math.cos(pose.heading),
        pose.y - 5 * Math.sin(pose.heading),
        0.35,
      );
      this.mesh.setMatrixAt(count++, this.matrix);
    }
    if (ball) {
      this.matrix.makeScale(12, 12, 1).setPosition(ball.x + 0.6, ball.y + 0.6, 0.35);
      this.mesh.setMatrixAt(count++, this.matrix);
    }
    this.mesh.count = count;
    this.mesh.instanceMatrix.needsUpdate = true;
  }
}

function spot(): THREE.Texture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const c = canvas.getContext("2d")!;
  const shade = c.createRadialGradient(32, 32, 2, 32, 32, 32);
  shade.addColorStop(0, "rgba(4,16,8,0.72)");
  shade.addColorStop(0.5, "rgba(4,16,8,0.42)");
  shade.addColorStop(1, "rgba(4,16,8,0)");
  c.fillStyle = shade;
  c.fillRect(0, 0, 64, 64);
  return new THREE.CanvasTexture(canvas);
}
