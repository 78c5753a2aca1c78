// SPDX-License-Identifier: Apache-2.0
// The messages of one chunk of an MCAP file, by channel in the order of their times. A record that
// is cut off ends the chunk.
import { decompress } from "fzstd";

export interface RawMessage {
  readonly time: number; // us
  readonly bytes: Uint8Array;
}
export interface Chunk {
  readonly bytes: number;
  readonly messages: ReadonlyMap<number, RawMessage[]>; // by channel
}

const MESSAGE = 0x05;
const CHUNK = 0x06;

// The compressed or plain records within a chunk record.
export function recordsOf(chunk: Uint8Array): Uint8Array {
  const view = new DataView(chunk.buffer, chunk.byteOffset, chunk.byteLength);
  if (view.getUint8(0) !== CHUNK) throw new Error("no chunk stands where the index says");
  const plainSize = Number(view.getBigUint64(25, true));
  const nameLength = view.getUint32(37, true);
  const name = new TextDecoder().decode(chunk.subarray(41, 41 + nameLength));
  const at = 41 + nameLength;
  const records = chunk.subarray(at + 8, at + 8 + Number(view.getBigUint64(at, true)));
  if (name === "") return records;
  if (name !== "zstd") throw new Error(`chunks compressed by ${name} cannot be read`);
  return decompress(records, new Uint8Array(plainSize));
}

export function parseChunk(chunk: Uint8Array): Chunk {
  const records = recordsOf(chunk);
  const view = new DataView(records.buffer, records.byteOffset, records.byteLength);
  const messages = new Map<number, RawMessage[]>();
  for (let at = 0; at + 9 <= records.length; ) {
    const length = Number(view.getBigUint64(at + 1, true));
    const end = at + 9 + length;
    if (end > records.length) break;
    if (view.getUint8(at) === MESSAGE) addMessage(messages, view, records, at + 9, end);
    at = end;
  }
  return { bytes: records.length, messages };
}

function addMessage(
  messages: Map<number, RawMessage[]>,
  view: DataView,
  records: Uint8Array,
  at: number,
  end: number,
): void {
  const channel = view.getUint16(at, true);
  const time = Number(view.getBigUint64(at + 6, true) / 1000n);
  const message = { time, bytes: records.subarray(at + 22, end) };
  const list = messages.get(channel);
  if (list) list.push(message);
  else messages.set(channel, [message]);
}
