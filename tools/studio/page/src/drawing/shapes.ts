// SPDX-License-Identifier: Apache-2.0
// Geometries that are put together of simple parts with a colour each, so that one draw call shows
// them all.
import * as THREE from "three";
import { mergeGeometries, mergeVertices } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import type { Shape } from "../model/body";

export function coloured(from: THREE.BufferGeometry, colour: number): THREE.BufferGeometry {
  from.deleteAttribute("uv");
  const geometry = from.index ? from : mergeVertices(from);
  const c = new THREE.Color(colour);
  const count = geometry.getAttribute("position").count;
  const values = new Float32Array(3 * count);
  for (let i = 0; i < count; ++i) c.toArray(values, 3 * i);
  geometry.setAttribute("color", new THREE.BufferAttribute(values, 3));
  return geometry;
}

export function merged(parts: THREE.BufferGeometry[]): THREE.BufferGeometry {
  return mergeGeometries(parts) ?? new THREE.BufferGeometry();
}

// A box whose edges are cut off, with the normals of the faces at all their corners, so that the
// light rounds the edges: 44 triangles, as eight robots of many parts must be drawn without a
// graphics card.
export function roundedBox(x: number, y: number, z: number): THREE.BufferGeometry {
  const cut = 0.24 * Math.min(x, y, z);
  const half = [x / 2, y / 2, z / 2];
  const places: number[] = [];
  const normals: number[] = [];
  // The corner of the face along an axis, at the corner of the box with these signs.
  const corner = (signs: number[], axis: number) => {
    for (let i = 0; i < 3; ++i) {
      places.push(signs[i]! * (half[i]! - (i === axis ? 0 : cut)));
      normals.push(i === axis ? signs[i]! : 0);
    }
  };
  const triangle = (a: Corner, b: Corner, c: Corner) => [a, b, c].forEach(([s, k]) => corner(s, k));
  for (let axis = 0; axis < 3; ++axis) for (const side of [-1, 1]) addFace(axis, side, triangle);
  for (const a of [-1, 1])
    for (const b of [-1, 1]) {
      for (let along = 0; along < 3; ++along) addEdge(along, a, b, triangle);
      for (const c of [-1, 1])
        triangle(...turned(a * b * c, [[a, b, c], 0], [[a, b, c], 1], [[a, b, c], 2]));
    }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(places, 3));
  geometry.setAttribute("normal", new THREE.Float32BufferAttribute(normals, 3));
  return geometry;
}

type Corner = [signs: number[], axis: number];
type Triangle = (a: Corner, b: Corner, c: Corner) => void;

function turned(sense: number, a: Corner, b: Corner, c: Corner): [Corner, Corner, Corner] {
  return sense > 0 ? [a, b, c] : [a, c, b];
}

function signsOf(axis: number, along: number, u: number, v: number): number[] {
  const signs = [0, 0, 0];
  signs[axis] = along;
  signs[(axis + 1) % 3] = u;
  signs[(axis + 2) % 3] = v;
  return signs;
}

function addFace(axis: number, side: number, triangle: Triangle): void {
  const at = (u: number, v: number): Corner => [signsOf(axis, side, u, v), axis];
  triangle(...turned(side, at(-1, -1), at(1, -1), at(1, 1)));
  triangle(...turned(side, at(-1, -1), at(1, 1), at(-1, 1)));
}

// The strip between two faces, along an axis; u and v say which edge of the four.
function addEdge(along: number, u: number, v: number, triangle: Triangle): void {
  const first = (along + 1) % 3;
  const second = (along + 2) % 3;
  const at = (end: number, face: number): Corner => [signsOf(along, end, u, v), face];
  triangle(...turned(u * v, at(-1, first), at(-1, second), at(1, second)));
  triangle(...turned(u * v, at(-1, first), at(1, second), at(1, first)));
}

// A part of the body, rounded as the shell of the real one is. Cylinders stand along z.
export function shapeGeometry(shape: Shape): THREE.BufferGeometry {
  const [x, y, z] = shape.size;
  let geometry: THREE.BufferGeometry;
  if (shape.kind === "sphere") {
    geometry = new THREE.SphereGeometry(0.5, x > 5 ? 14 : 8, x > 5 ? 10 : 5).scale(x, y, z);
  } else if (shape.kind === "cylinder") {
    geometry = new THREE.CylinderGeometry(0.5, 0.5, 1, 10).rotateX(Math.PI / 2).scale(x, y, z);
  } else {
    geometry = roundedBox(x, y, z);
  }
  return geometry.translate(...shape.centre);
}

// A flat quadrangle on the ground from one point to another.
export function stripe(
  ax: number,
  ay: number,
  bx: number,
  by: number,
  width: number,
  height: number,
): THREE.BufferGeometry {
  const length = Math.hypot(bx - ax, by - ay);
  return new THREE.PlaneGeometry(length + width, width)
    .rotateZ(Math.atan2(by - ay, bx - ax))
    .translate((ax + bx) / 2, (ay + by) / 2, height);
}
