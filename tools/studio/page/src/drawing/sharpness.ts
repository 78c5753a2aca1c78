// SPDX-License-Identifier: Apache-2.0
// How fine the scene is drawn: whole while it rests, coarser while it moves and the machine cannot
// keep up otherwise. It goes by the time from one picture to the next.
const STEPS = [1, 0.85, 0.7, 0.55];
const SLOW = 36; // ms
const FAST = 18; // ms
const PAUSE = 260; // ms; what comes later belongs to no movement

export class Sharpness {
  private step = 0;
  private mean = 25;
  private count = 0;
  private last = 0;

  // Of the next picture, drawn at this time in ms.
  moving(now: number): number {
    const elapsed = now - this.last;
    this.last = now;
    if (elapsed < PAUSE) {
      this.mean += 0.15 * (elapsed - this.mean);
      ++this.count;
      this.adapt();
    }
    return STEPS[this.step]!;
  }

  private adapt(): void {
    const slower = this.mean > SLOW && this.count > 8 && this.step < STEPS.length - 1;
    const faster = this.mean < FAST && this.count > 90 && this.step > 0;
    if (!slower && !faster) return;
    this.step += slower ? 1 : -1;
    this.mean = 25;
    this.count = 0;
  }

  get coarse(): boolean {
    return this.step > 0;
  }
}

export const RESTS_AFTER = PAUSE;

// Whether the browser draws without a graphics card. Then smooth edges are left to the picture at
// rest, which is drawn larger.
export function drawsInSoftware(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  const names = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = gl && names ? String(gl.getParameter(names.UNMASKED_RENDERER_WEBGL)) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(name);
}
