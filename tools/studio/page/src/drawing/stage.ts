// SPDX-License-Identifier: Apache-2.0
// The 3D scene: renderer, light, sky, floor. It draws only when something has changed, as every
// frame costs much where no graphics card helps. x and y are the field's, z is up, all in cm.
import * as THREE from "three";
import { RESTS_AFTER, Sharpness, drawsInSoftware } from "./sharpness";

export interface Palette {
  skyTop: number;
  skyLow: number;
  floor: number;
  sun: number;
}
const LIGHT: Palette = { skyTop: 0x7fb0e0, skyLow: 0xe9f1f7, floor: 0xb9b4ab, sun: 2.3 };
const DARK: Palette = { skyTop: 0x0b1220, skyLow: 0x25344a, floor: 0x2b3038, sun: 1.9 };

// What is near is drawn first, so that little is drawn twice.
export const FLOOR_ORDER = 4;
const SKY_ORDER = 5;

export class Stage {
  readonly scene = new THREE.Scene();
  readonly renderer: THREE.WebGLRenderer;
  readonly sun = new THREE.DirectionalLight(0xfff4e2, LIGHT.sun);
  camera: THREE.PerspectiveCamera = new THREE.PerspectiveCamera(42, 1, 2, 4000);
  drawnFrames = 0;
  private readonly hemisphere = new THREE.HemisphereLight(0xdfeaf5, 0x6a7a5c, 1.5);
  private readonly sky: THREE.Mesh;
  private readonly floor: THREE.Mesh;
  private wanted = false;
  private readonly software = drawsInSoftware();
  private readonly sharpness = new Sharpness();
  private size = { width: 1, height: 1 };
  private scale = 1;
  private rest = 0;

  constructor(
    canvas: HTMLCanvasElement,
    private readonly beforeDrawing: () => void,
  ) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: !this.software });
    // To ask for a shader's errors waits until it is made, one after the other.
    this.renderer.debug.checkShaderErrors = false;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = THREE.PCFShadowMap;
    this.renderer.shadowMap.autoUpdate = true;
    this.camera.up.set(0, 0, 1);
    this.sky = dome();
    this.floor = floorDisc();
    this.floor.position.z = -1.2;
    this.scene.add(this.sky, this.floor, this.hemisphere, this.sun, this.sun.target);
    this.setDark(false);
  }

  // The sun stands over the middle of the field, its shadows reach all of it.
  lightField(width: number, length: number): void {
    const middle = new THREE.Vector3(width / 2, length / 2, 0);
    this.sun.target.position.copy(middle);
    this.sun.position.copy(middle).add(new THREE.Vector3(-260, -190, 620));
    this.sun.shadow.mapSize.set(2048, 2048);
    const reach = 0.62 * Math.max(width, length);
    Object.assign(this.sun.shadow.camera, {
      left: -reach,
      right: reach,
      top: reach,
      bottom: -reach,
      near: 200,
      far: 1200,
    });
    this.sun.shadow.bias = -0.0015;
    this.sun.shadow.normalBias = 0.6;
    this.sun.shadow.camera.updateProjectionMatrix();
  }

  setDark(dark: boolean): void {
    const palette = dark ? DARK : LIGHT;
    paint(this.sky, palette.skyLow, palette.skyTop, (p) => p.z / 1500);
    paint(this.floor, palette.floor, palette.skyLow, (p) => (p.length() - 300) / 1700);
    this.sun.intensity = palette.sun;
    this.hemisphere.intensity = dark ? 1.1 : 1.5;
    this.invalidate();
  }

  resize(width: number, height: number): void {
    this.size = { width, height };
    this.applySize();
    this.camera.aspect = width / Math.max(1, height);
    this.camera.updateProjectionMatrix();
    this.invalidate();
  }

  invalidate(): void {
    if (this.wanted) return;
    this.wanted = true;
    requestAnimationFrame(() => {
      this.wanted = false;
      this.draw();
    });
  }

  private applySize(): void {
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2) * this.scale);
    this.renderer.setSize(this.size.width, this.size.height, false);
  }

  private setScale(scale: number): void {
    if (scale === this.scale) return;
    this.scale = scale;
    this.applySize();
  }

  private draw(): void {
    this.setScale(this.sharpness.moving(performance.now()));
    this.render();
    if (!this.sharpness.coarse && !this.software) return;
    window.clearTimeout(this.rest);
    this.rest = window.setTimeout(() => {
      this.setScale(this.software ? 1.5 : 1);
      this.render();
    }, RESTS_AFTER);
  }

  private render(): void {
    this.beforeDrawing();
    this.sky.position.copy(this.camera.position);
    this.renderer.render(this.scene, this.camera);
    ++this.drawnFrames;
  }
}

// Colours at the corners alone tell sky and floor, as every pixel of them is drawn each time.
function dome(): THREE.Mesh {
  const geometry = new THREE.SphereGeometry(3000, 20, 10).rotateX(Math.PI / 2);
  return backdrop(geometry, SKY_ORDER);
}

function floorDisc(): THREE.Mesh {
  return backdrop(new THREE.RingGeometry(0, 2950, 32, 6), FLOOR_ORDER);
}

function backdrop(geometry: THREE.BufferGeometry, order: number): THREE.Mesh {
  const count = geometry.getAttribute("position").count;
  geometry.setAttribute("color", new THREE.BufferAttribute(new Float32Array(3 * count), 3));
  const mesh = new THREE.Mesh(
    geometry,
    new THREE.MeshBasicMaterial({
      vertexColors: true,
      side: THREE.DoubleSide,
      depthWrite: order === FLOOR_ORDER,
    }),
  );
  mesh.renderOrder = order;
  mesh.frustumCulled = false;
  return mesh;
}

// From one colour to the other by a share that each corner has.
function paint(
  mesh: THREE.Mesh,
  from: number,
  to: number,
  shareOf: (place: THREE.Vector3) => number,
): void {
  const places = mesh.geometry.getAttribute("position") as THREE.BufferAttribute;
  const colours = mesh.geometry.getAttribute("color") as THREE.BufferAttribute;
  const [a, b, place] = [new THREE.Color(from), new THREE.Color(to), new THREE.Vector3()];
  for (let i = 0; i < places.count; ++i) {
    const share = THREE.MathUtils.clamp(shareOf(place.fromBufferAttribute(places, i)), 0, 1);
    const c = a.clone().lerp(b, share);
    colours.setXYZ(i, c.r, c.g, c.b);
  }
  colours.needsUpdate = true;
}
