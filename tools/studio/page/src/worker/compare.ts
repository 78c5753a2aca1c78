// SPDX-License-Identifier: Apache-2.0
// Which frames of two logs have other outputs, byte by byte. Frames are matched by their number,
// the first member of every output.
import { OUTPUT_TOPIC } from "../model/match";
import type { LogFile } from "../reading/logFile";

export interface Compared {
  times: number[]; // us in the first log, of the frames that differ
  frames: number; // that both have
  onlyOne: number; // that one of them lacks
}

export function sameBytes(a: Uint8Array, b: Uint8Array): boolean {
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; ++i) if (a[i] !== b[i]) return false;
  return true;
}

function frameOf(bytes: Uint8Array): number {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength).getUint32(0, true);
}

async function* outputs(log: LogFile) {
  const channel = log.channels.get(OUTPUT_TOPIC);
  if (!channel) return;
  for (const [i, place] of log.chunks.entries())
    if (place.channels.has(channel.id)) yield* (await log.chunk(i)).messages.get(channel.id) ?? [];
}

export async function compareLogs(a: LogFile, b: LogFile): Promise<Compared> {
  const result: Compared = { times: [], frames: 0, onlyOne: 0 };
  const left = outputs(a);
  const right = outputs(b);
  let x = await left.next();
  let y = await right.next();
  while (!x.done && !y.done) {
    const frame = frameOf(x.value.bytes);
    const other = frameOf(y.value.bytes);
    if (frame === other) {
      ++result.frames;
      if (!sameBytes(x.value.bytes, y.value.bytes)) result.times.push(x.value.time);
    } else ++result.onlyOne;
    if (frame <= other) x = await left.next();
    if (other <= frame) y = await right.next();
  }
  for (; !x.done; x = await left.next()) ++result.onlyOne;
  for (; !y.done; y = await right.next()) ++result.onlyOne;
  return result;
}
