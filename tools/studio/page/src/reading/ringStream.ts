// SPDX-License-Identifier: Apache-2.0
// A topic of a match that is being played: the messages of the last minutes, within a bound of
// bytes, oldest dropped first. All there is is in memory, so that `load` has nothing to do.
import { Decoder, type MemberType } from "./decoder";
import { LazyMessage, lastNotAfter, type Around, type Message, type Stream } from "./stream";

const KEPT_US = 180e6;
const DROP_AT_ONCE = 64; // messages, as dropping moves all others

export class RingStream implements Stream {
  private readonly decoder: Decoder;
  private messages: Message[] = [];
  private bytes = 0;

  constructor(
    readonly topic: string,
    readonly type: MemberType,
    private readonly mostBytes = 24e6,
  ) {
    this.decoder = new Decoder(type);
  }

  get from(): number {
    return this.messages[0]?.time ?? 0;
  }
  get to(): number {
    return this.messages[this.messages.length - 1]?.time ?? 0;
  }
  get all(): readonly Message[] {
    return this.messages;
  }
  get count(): number {
    return this.messages.length;
  }

  // Time goes on, but for a match that begins anew: then what was before is dropped.
  add(time: number, bytes: Uint8Array): Message {
    if (time < this.to - 1e6) this.clear();
    const message = new LazyMessage(time, bytes, this.decoder);
    this.messages.push(message);
    this.bytes += bytes.length;
    this.drop(time - KEPT_US);
    return message;
  }

  clear(): void {
    this.messages = [];
    this.bytes = 0;
  }

  private drop(before: number): void {
    let count = 0;
    let bytes = this.bytes;
    while (
      count < this.messages.length - 1 &&
      (this.messages[count]!.time < before || bytes > this.mostBytes)
    )
      bytes -= this.messages[count++]!.bytes.length;
    if (count < DROP_AT_ONCE) return;
    this.messages.splice(0, count);
    this.bytes = bytes;
  }

  around(time: number): Around {
    const i = lastNotAfter(this.messages.length, (k) => this.messages[k]!.time, time);
    return { before: this.messages[i], after: this.messages[i + 1] };
  }

  load(): Promise<void> {
    return Promise.resolve();
  }
}
