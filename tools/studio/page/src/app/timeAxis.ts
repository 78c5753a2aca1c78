// SPDX-License-Identifier: Apache-2.0
// Which part of the match lanes and time line show, and where a time is on the screen.
export class TimeAxis {
  from: number;
  to: number;
  private readonly listeners: (() => void)[] = [];

  constructor(
    public first: number,
    public last: number,
  ) {
    this.from = first;
    this.to = Math.max(last, first + 1e6);
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  private set(from: number, to: number): void {
    const span = Math.min(Math.max(to - from, 1e6), Math.max(1e6, this.last - this.first));
    const begin = Math.min(Math.max(from, this.first), Math.max(this.first, this.last - span));
    this.from = begin;
    this.to = begin + span;
    for (const listener of this.listeners) listener();
  }

  get whole(): boolean {
    return this.from <= this.first && this.to >= this.last;
  }

  zoom(factor: number, about: number): void {
    this.set(about - (about - this.from) * factor, about + (this.to - about) * factor);
  }

  move(us: number): void {
    this.set(this.from + us, this.to + us);
  }

  showAll(): void {
    this.set(this.first, this.last);
  }

  // Follows the cursor where it leaves the part that is shown.
  keep(time: number): void {
    const span = this.to - this.from;
    if (time < this.from) this.set(time - 0.1 * span, time + 0.9 * span);
    else if (time > this.to) this.set(time - 0.9 * span, time + 0.1 * span);
  }

  grow(first: number, last: number): void {
    const whole = this.whole;
    this.first = first;
    this.last = last;
    if (whole) this.showAll();
  }

  x(time: number, width: number): number {
    return ((time - this.from) / (this.to - this.from)) * width;
  }
  time(x: number, width: number): number {
    return this.from + (x / Math.max(1, width)) * (this.to - this.from);
  }
}
