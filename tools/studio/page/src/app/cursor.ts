// SPDX-License-Identifier: Apache-2.0
// The one time that all panels show, in us of the match, and whether it runs. A live match is
// followed at its end until somebody goes back.
export type CursorListener = (time: number) => void;

export const FRAME_US = 1e6 / 30;

export class Cursor {
  time = 0;
  playing = false;
  speed = 1;
  following = false; // the live end
  private readonly listeners: CursorListener[] = [];
  private lastTick = 0;

  constructor(
    public from: number,
    public to: number,
  ) {
    this.time = from;
  }

  onChange(listener: CursorListener): void {
    this.listeners.push(listener);
  }

  set(time: number): void {
    const clamped = Math.min(this.to, Math.max(this.from, time));
    this.time = clamped;
    for (const listener of this.listeners) listener(clamped);
  }

  get moving(): boolean {
    return this.playing || this.following;
  }

  // By a person, who with it leaves the live end but where it is the end.
  seek(time: number): void {
    this.following = this.following && time >= this.to - FRAME_US / 2;
    this.set(time);
  }

  // Of a live match that is followed: it is left behind, and followed again by going to its end.
  play(on = !this.playing && !this.following): void {
    if (this.following) this.following = false;
    if (on && this.time >= this.to) this.set(this.from);
    this.playing = on;
    this.lastTick = 0;
    if (on) requestAnimationFrame((now) => this.tick(now));
    for (const listener of this.listeners) listener(this.time);
  }

  private tick(now: number): void {
    if (!this.playing) return;
    const elapsed = this.lastTick > 0 ? Math.min(250, now - this.lastTick) : 0;
    this.lastTick = now;
    this.set(this.time + elapsed * 1000 * this.speed);
    if (this.time >= this.to && !this.following) {
      this.play(false);
      return;
    }
    requestAnimationFrame((next) => this.tick(next));
  }

  grow(to: number): void {
    this.to = Math.max(this.to, to);
  }
}
