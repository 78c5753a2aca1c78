// SPDX-License-Identifier: Apache-2.0
// Geometries that are put together of simple parts with a colour each, so that one draw call shows
// them all.
import * as THREE from "three";
import { RoundedBoxGeometry } from "three/examples/jsm/geometries/RoundedBoxGeometry.js";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import type { Shape } from "../model/body";

export function coloured(geometry: THREE.BufferGeometry, colour: number): THREE.BufferGeometry {
  const plain = geometry.index ? geometry.toNonIndexed() : geometry;
  plain.deleteAttribute("uv");
  const c = new THREE.Color(colour);
  const count = plain.getAttribute("position").count;
  const values = new Float32Array(3 * count);
  for (let i = 0; i < count; ++i) c.toArray(values, 3 * i);
  plain.setAttribute("color", new THREE.BufferAttribute(values, 3));
  return plain;
}

export function merged(parts: THREE.BufferGeometry[]): THREE.BufferGeometry {
  return mergeGeometries(parts) ?? new THREE.BufferGeometry();
}

// A part of the body, rounded as the shell of the real one is. Cylinders stand along z.
export function shapeGeometry(shape: Shape): THREE.BufferGeometry {
  const [x, y, z] = shape.size;
  let geometry: THREE.BufferGeometry;
  if (shape.kind === "sphere") {
    geometry = new THREE.SphereGeometry(0.5, 12, 8).scale(x, y, z);
  } else if (shape.kind === "cylinder") {
    geometry = new THREE.CylinderGeometry(0.5, 0.5, 1, 12).rotateX(Math.PI / 2).scale(x, y, z);
  } else {
    geometry = new RoundedBoxGeometry(x, y, z, 2, 0.28 * Math.min(x, y, z));
  }
  return geometry.translate(...shape.centre);
}

// A flat quadrangle on the ground from one point to another.
export function stripe(ax: number, ay: number, bx: number, by: number, width: number,
  height: number): THREE.BufferGeometry {
  const length = Math.hypot(bx - ax, by - ay);
  return new THREE.PlaneGeometry(length + width, width)
    .rotateZ(Math.atan2(by - ay, bx - ax))
    .translate((ax + bx) / 2, (ay + by) / 2, height);
}
