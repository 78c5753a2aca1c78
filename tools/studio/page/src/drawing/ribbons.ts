// SPDX-License-Identifier: Apache-2.0
// Flat lines, ellipses and arrows on the ground, all in one mesh that is filled anew for each time.
import * as THREE from "three";
import type { Point } from "../model/field";

const MOST_CORNERS = 60000;

export class Ribbons {
  readonly mesh: THREE.Mesh;
  count = 0; // shapes since clear()
  private readonly places = new Float32Array(3 * MOST_CORNERS);
  private readonly colours = new Float32Array(4 * MOST_CORNERS);
  private corners = 0;
  private readonly ink = new THREE.Color();

  constructor() {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(this.places, 3));
    geometry.setAttribute("color", new THREE.BufferAttribute(this.colours, 4));
    this.mesh = new THREE.Mesh(
      geometry,
      new THREE.MeshBasicMaterial({
        vertexColors: true,
        transparent: true,
        side: THREE.DoubleSide,
        depthWrite: false,
        polygonOffset: true,
        polygonOffsetFactor: -4,
        polygonOffsetUnits: -4,
      }),
    );
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 2;
  }

  clear(): void {
    this.corners = 0;
    this.count = 0;
  }

  finish(): void {
    const geometry = this.mesh.geometry;
    geometry.setDrawRange(0, this.corners);
    for (const name of ["position", "color"]) {
      const attribute = geometry.getAttribute(name) as THREE.BufferAttribute;
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, this.corners * attribute.itemSize);
      attribute.needsUpdate = true;
    }
    this.mesh.visible = this.corners > 0;
  }

  private corner(x: number, y: number, z: number, alpha: number): void {
    if (this.corners >= MOST_CORNERS) return;
    this.places.set([x, y, z], 3 * this.corners);
    this.colours.set([this.ink.r, this.ink.g, this.ink.b, alpha], 4 * this.corners);
    ++this.corners;
  }

  triangle(a: Point, b: Point, c: Point, colour: number, alpha: number, z = 0.8): void {
    this.ink.set(colour);
    for (const p of [a, b, c]) this.corner(p.x, p.y, z, alpha);
  }

  private piece(a: Point, b: Point, width: number, alpha: number, z: number): void {
    const length = Math.hypot(b.x - a.x, b.y - a.y) || 1;
    const nx = (-(b.y - a.y) / length) * (width / 2);
    const ny = ((b.x - a.x) / length) * (width / 2);
    const corners = [
      [a.x + nx, a.y + ny],
      [a.x - nx, a.y - ny],
      [b.x - nx, b.y - ny],
      [a.x + nx, a.y + ny],
      [b.x - nx, b.y - ny],
      [b.x + nx, b.y + ny],
    ];
    for (const [x, y] of corners) this.corner(x!, y!, z, alpha);
  }

  line(a: Point, b: Point, width: number, colour: number, alpha = 1, z = 0.8): void {
    this.ink.set(colour);
    this.piece(a, b, width, alpha, z);
    ++this.count;
  }

  dashes(a: Point, b: Point, width: number, colour: number, alpha = 1): void {
    const length = Math.hypot(b.x - a.x, b.y - a.y);
    const at = (way: number) => ({
      x: a.x + ((b.x - a.x) * way) / length,
      y: a.y + ((b.y - a.y) * way) / length,
    });
    this.ink.set(colour);
    for (let way = 0; way < length; way += 10)
      this.piece(at(way), at(Math.min(length, way + 6)), width, alpha, 0.8);
    ++this.count;
  }

  arrow(a: Point, b: Point, width: number, colour: number, alpha = 1): void {
    const length = Math.hypot(b.x - a.x, b.y - a.y);
    if (length < 0.5) return;
    const ux = (b.x - a.x) / length;
    const uy = (b.y - a.y) / length;
    const head = Math.min(length, 3.2 * width);
    const neck = { x: b.x - ux * head, y: b.y - uy * head };
    this.line(a, neck, width, colour, alpha);
    this.triangle(
      { x: neck.x - uy * head * 0.6, y: neck.y + ux * head * 0.6 },
      { x: neck.x + uy * head * 0.6, y: neck.y - ux * head * 0.6 },
      b,
      colour,
      alpha,
    );
  }

  // One standard deviation of a symmetric 2 x 2 covariance; any root of it draws the same ellipse.
  ellipse(
    middle: Point,
    xx: number,
    xy: number,
    yy: number,
    width: number,
    colour: number,
    alpha = 1,
  ): void {
    const a = Math.sqrt(Math.max(xx, 0));
    const b = a > 0 ? xy / a : 0;
    const c = Math.sqrt(Math.max(yy - b * b, 0));
    const corners = 32;
    const at = (i: number) => {
      const turn = (2 * Math.PI * i) / corners;
      return {
        x: middle.x + a * Math.cos(turn),
        y: middle.y + b * Math.cos(turn) + c * Math.sin(turn),
      };
    };
    this.ink.set(colour);
    for (let i = 0; i < corners; ++i) this.piece(at(i), at(i + 1), width, alpha, 0.8);
    ++this.count;
  }

  ring(middle: Point, radius: number, width: number, colour: number, alpha = 1): void {
    this.ellipse(middle, radius * radius, 0, radius * radius, width, colour, alpha);
  }

  square(middle: Point, side: number, colour: number, alpha: number): void {
    this.line(
      { x: middle.x - side / 2, y: middle.y },
      { x: middle.x + side / 2, y: middle.y },
      side,
      colour,
      alpha,
      0.6,
    );
  }
}
