// SPDX-License-Identifier: Apache-2.0
// One topic's messages over time, from a file or from a match that is being played. `around`
// answers at once with what is in memory: undefined while the part of the time is not, then `load`
// gets it.
import { Decoder, type MemberType, type Structure } from "./decoder";

export interface Message {
  readonly time: number; // us
  readonly bytes: Uint8Array;
  readonly value: Structure; // decoded when it is first asked for
}
export interface Around {
  readonly before: Message | undefined; // the last at the time or earlier
  readonly after: Message | undefined; // the first later
}
export interface Stream {
  readonly topic: string;
  readonly type: MemberType;
  readonly from: number; // us, of the first message
  readonly to: number; // us, of the last
  around(time: number): Around | undefined;
  load(time: number): Promise<void>;
}

export class LazyMessage implements Message {
  private made: Structure | undefined;

  constructor(
    readonly time: number,
    readonly bytes: Uint8Array,
    private readonly decoder: Decoder,
  ) {}

  get value(): Structure {
    this.made ??= this.decoder.decode(this.bytes);
    return this.made;
  }
}

// Index of the last of the ascending times that is not later; -1 when all are.
export function lastNotAfter(count: number, timeAt: (i: number) => number, time: number): number {
  let low = 0;
  let high = count;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (timeAt(middle) <= time) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}
