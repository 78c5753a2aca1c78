// SPDX-License-Identifier: Apache-2.0
// The 3D scene: renderer, light, sky, floor. It draws only when something has changed, as every
// frame costs much where no graphics card helps. x and y are the field's, z is up, all in cm.
import * as THREE from "three";

export interface Palette {
  skyTop: number;
  skyLow: number;
  floor: number;
  sun: number;
}
const LIGHT: Palette = { skyTop: 0x7fb0e0, skyLow: 0xe9f1f7, floor: 0xb9b4ab, sun: 2.3 };
const DARK: Palette = { skyTop: 0x0b1220, skyLow: 0x25344a, floor: 0x2b3038, sun: 1.9 };

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

  constructor(canvas: HTMLCanvasElement, private readonly beforeDrawing: () => void) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = THREE.PCFShadowMap;
    this.renderer.shadowMap.autoUpdate = true;
    this.camera.up.set(0, 0, 1);
    this.sky = skyDome();
    this.floor = new THREE.Mesh(new THREE.PlaneGeometry(6000, 6000),
      new THREE.MeshBasicMaterial({ color: LIGHT.floor }));
    this.floor.position.z = -1.2;
    this.scene.add(this.sky, this.floor, this.hemisphere, this.sun, this.sun.target);
    this.setDark(false);
  }

  // The sun stands over the middle of the field, its shadows reach all of it.
  lightField(width: number, length: number): void {
    const middle = new THREE.Vector3(width / 2, length / 2, 0);
    this.sun.target.position.copy(middle);
    this.sun.position.copy(middle).add(new THREE.Vector3(-260, -190, 620));
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(2048, 2048);
    const reach = 0.62 * Math.max(width, length);
    Object.assign(this.sun.shadow.camera, { left: -reach, right: reach, top: reach,
      bottom: -reach, near: 200, far: 1200 });
    this.sun.shadow.bias = -0.0015;
    this.sun.shadow.normalBias = 0.6;
    this.sun.shadow.camera.updateProjectionMatrix();
  }

  setDark(dark: boolean): void {
    const palette = dark ? DARK : LIGHT;
    (this.sky.material as THREE.ShaderMaterial).uniforms["top"]!.value.set(palette.skyTop);
    (this.sky.material as THREE.ShaderMaterial).uniforms["low"]!.value.set(palette.skyLow);
    (this.floor.material as THREE.MeshBasicMaterial).color.set(palette.floor);
    this.scene.fog = new THREE.Fog(palette.skyLow, 900, 2600);
    this.sun.intensity = palette.sun;
    this.hemisphere.intensity = dark ? 1.1 : 1.5;
    this.invalidate();
  }

  resize(width: number, height: number): void {
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
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

  private draw(): void {
    this.beforeDrawing();
    this.sky.position.copy(this.camera.position);
    this.renderer.render(this.scene, this.camera);
    ++this.drawnFrames;
  }
}

function skyDome(): THREE.Mesh {
  const material = new THREE.ShaderMaterial({
    side: THREE.BackSide, depthWrite: false, fog: false,
    uniforms: { top: { value: new THREE.Color() }, low: { value: new THREE.Color() } },
    vertexShader: "varying float up; void main() { up = normalize(position).z;" +
      " gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",
    fragmentShader: "uniform vec3 top; uniform vec3 low; varying float up; void main() {" +
      " gl_FragColor = vec4(mix(low, top, smoothstep(0.0, 0.6, up)), 1.0);" +
      " #include <colorspace_fragment>\n }".replace(" #include", "\n#include"),
  });
  const dome = new THREE.Mesh(new THREE.SphereGeometry(3000, 24, 16), material);
  dome.renderOrder = -1;
  dome.frustumCulled = false;
  return dome;
}
