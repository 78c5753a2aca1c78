// SPDX-License-Identifier: Apache-2.0
// The field as its description says: carpet, lines, goals, beacons, and the arrow of attack.
import * as THREE from "three";
import type { Field, Landmark } from "../model/field";
import { coloured, merged, stripe } from "./shapes";

const COLOURS = { blue: 0x1b6ff0, yellow: 0xf6cf1c, pink: 0xf2559b, white: 0xf4f4f2 };
const CARPET = "#2f7d41";

// Seeded, so that the carpet is the same each time.
function noise(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

function carpetTexture(): THREE.Texture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 256;
  const c = canvas.getContext("2d")!;
  c.fillStyle = CARPET;
  c.fillRect(0, 0, 256, 256);
  const random = noise(7);
  for (let i = 0; i < 9000; ++i) {
    const dark = random() < 0.5;
    c.fillStyle = dark ? "rgba(10,40,15,0.16)" : "rgba(190,235,170,0.10)";
    c.fillRect(Math.floor(random() * 256), Math.floor(random() * 256), 1, 1 + random() * 3);
  }
  const texture = new THREE.CanvasTexture(canvas);
  texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
  texture.colorSpace = THREE.SRGBColorSpace;
  texture.generateMipmaps = true;
  return texture;
}

function carpet(field: Field): THREE.Mesh {
  const width = field.width + 2 * field.sideFringe;
  const length = field.length + 2 * field.endFringe;
  const texture = carpetTexture();
  texture.repeat.set(width / 60, length / 60);
  const mesh = new THREE.Mesh(
    new THREE.PlaneGeometry(width, length),
    new THREE.MeshLambertMaterial({ map: texture }),
  );
  mesh.renderOrder = 2;
  mesh.position.set(field.width / 2, field.length / 2, 0);
  mesh.receiveShadow = true;
  return mesh;
}

function edgeOfCarpet(field: Field): THREE.BufferGeometry {
  const box = new THREE.BoxGeometry(
    field.width + 2 * field.sideFringe,
    field.length + 2 * field.endFringe,
    1,
  );
  return coloured(box.translate(field.width / 2, field.length / 2, -0.6), 0x1f5a2e);
}

const LINE_HEIGHT = 0.25; // cm, above the carpet, so that it does not hide them

function paintedLines(field: Field): THREE.Mesh {
  const parts = field.lines.map(({ start, end }) =>
    stripe(start.x, start.y, end.x, end.y, field.lineWidth, LINE_HEIGHT),
  );
  const radius = field.circleDiameter / 2;
  if (radius > 0)
    parts.push(
      new THREE.RingGeometry(
        radius - field.lineWidth / 2,
        radius + field.lineWidth / 2,
        48,
      ).translate(field.width / 2, field.length / 2, LINE_HEIGHT),
    );
  const mesh = new THREE.Mesh(
    merged(parts.map((p) => coloured(p, COLOURS.white))),
    new THREE.MeshBasicMaterial({
      vertexColors: true,
      side: THREE.DoubleSide, // as the backdrops: one shader for all that is without light
      polygonOffset: true,
      polygonOffsetFactor: -2,
      polygonOffsetUnits: -2,
    }),
  );
  mesh.renderOrder = 1;
  return mesh;
}

function colourOf(word: string): number {
  return COLOURS[word.toLowerCase() as keyof typeof COLOURS] ?? COLOURS.white;
}

function goal(field: Field, mark: Landmark): THREE.BufferGeometry[] {
  const colour = colourOf(mark.kind.replace("goal", ""));
  const { x, y } = mark.position;
  const out = y < field.length / 2 ? -1 : 1; // away from the field
  const { goalWidth: w, goalDepth: d, goalHeight: h } = field;
  const wall = (sx: number, sy: number, sz: number, cx: number, cy: number, cz: number) =>
    coloured(new THREE.BoxGeometry(sx, sy, sz).translate(cx, cy, cz), colour);
  const post = (side: number) =>
    coloured(
      new THREE.CylinderGeometry(1.4, 1.4, h, 12)
        .rotateX(Math.PI / 2)
        .translate(x + side * (w / 2 + 0.7), y, h / 2),
      colour,
    );
  return [
    wall(1.2, d, h, x - w / 2 - 0.6, y + (out * d) / 2, h / 2),
    wall(1.2, d, h, x + w / 2 + 0.6, y + (out * d) / 2, h / 2),
    wall(w + 2.4, 1.2, h, x, y + out * d, h / 2),
    coloured(
      new THREE.CylinderGeometry(1.2, 1.2, w + 2.4, 10)
        .rotateZ(Math.PI / 2)
        .translate(x, y, h - 1.2),
      colour,
    ),
    post(-1),
    post(1),
  ];
}

// Four equal bands, the upper two coloured, the lower two white.
function beacon(field: Field, mark: Landmark): THREE.BufferGeometry[] {
  const [, upper, lower] = /beacon(\w+)On(\w+)/.exec(mark.kind) ?? [];
  const band = field.beaconHeight / 4;
  const colours = [COLOURS.white, COLOURS.white, colourOf(lower ?? ""), colourOf(upper ?? "")];
  return colours.map((colour, i) =>
    coloured(
      new THREE.CylinderGeometry(field.beaconRadius, field.beaconRadius, band, 24)
        .rotateX(Math.PI / 2)
        .translate(mark.position.x, mark.position.y, (i + 0.5) * band),
      colour,
    ),
  );
}

// On the carpet beside the field: red attacks up-field.
function attackArrows(field: Field): THREE.Mesh {
  const arrow = (x: number, from: number, to: number, colour: number) => {
    const way = Math.sign(to - from);
    const head = new THREE.Shape([
      new THREE.Vector2(-4, 0),
      new THREE.Vector2(4, 0),
      new THREE.Vector2(0, 9 * way),
    ]);
    const tip = new THREE.ShapeGeometry(head);
    if (way < 0) tip.scale(-1, 1, 1);
    return [
      coloured(stripe(x, from, x, to, 2.4, 0.3), colour),
      coloured(tip.translate(x, to, 0.3), colour),
    ];
  };
  const middle = field.length / 2;
  const parts = [
    ...arrow(-field.sideFringe / 2, middle - 40, middle + 40, 0xff5a4f),
    ...arrow(field.width + field.sideFringe / 2, middle + 40, middle - 40, 0x6aa5ff),
  ];
  return new THREE.Mesh(
    merged(parts),
    new THREE.MeshBasicMaterial({ vertexColors: true, side: THREE.DoubleSide }),
  );
}

export interface Stadium {
  group: THREE.Group;
  arrows: THREE.Mesh;
  lineCount: number;
}

export function makeStadium(field: Field): Stadium {
  const group = new THREE.Group();
  const marks = field.landmarks.flatMap((mark) =>
    mark.kind.startsWith("goal") ? goal(field, mark) : beacon(field, mark),
  );
  const standing = new THREE.Mesh(
    merged([edgeOfCarpet(field), ...marks]),
    new THREE.MeshLambertMaterial({ vertexColors: true }),
  );
  standing.castShadow = standing.receiveShadow = true;
  const arrows = attackArrows(field);
  group.add(carpet(field), paintedLines(field), standing, arrows);
  for (const child of group.children) (child.matrixAutoUpdate = false), child.updateMatrix();
  return { group, arrows, lineCount: field.lines.length };
}
