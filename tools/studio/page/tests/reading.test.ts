// SPDX-License-Identifier: Apache-2.0
import { McapWriter } from "@mcap/core";
import { describe, expect, test } from "vitest";
import { Decoder, typeOf, type Structure } from "../src/reading/decoder";
import { LogFile } from "../src/reading/logFile";
import { RingStream } from "../src/reading/ringStream";
import { lastNotAfter } from "../src/reading/stream";

const SCHEMA = `uint32 frame
int64 time  # us
kelpie/Point[] points
string word
float64[2] pair
${"=".repeat(80)}
MSG: kelpie/Point
float64 x
float64 y
`;

function encoded(frame: number, time: number, points: number[][], word: string): Uint8Array {
  const text = new TextEncoder().encode(word);
  const view = new DataView(new ArrayBuffer(36 + 16 * points.length + text.length));
  view.setUint32(0, frame, true);
  view.setBigInt64(4, BigInt(time), true);
  view.setUint32(12, points.length, true);
  points.flat().forEach((value, i) => view.setFloat64(16 + 8 * i, value, true));
  const at = 16 + 16 * points.length;
  view.setUint32(at, text.length, true);
  new Uint8Array(view.buffer).set(text, at + 4);
  view.setFloat64(at + 4 + text.length, 1.5, true);
  view.setFloat64(at + 12 + text.length, -2, true);
  return new Uint8Array(view.buffer);
}

describe("the decoder", () => {
  const bytes = encoded(
    7,
    123,
    [
      [1, 2],
      [3, 4],
    ],
    "kick",
  );

  test("reads every member by the definition", () => {
    expect(new Decoder(typeOf(SCHEMA)).decode(bytes)).toEqual({
      frame: 7,
      time: 123,
      points: [
        { x: 1, y: 2 },
        { x: 3, y: 4 },
      ],
      word: "kick",
      pair: [1.5, -2],
    });
  });

  test("passes over what is not asked for", () => {
    const wanted = { points: { y: true }, pair: true } as const;
    expect(new Decoder(typeOf(SCHEMA), wanted).decode(bytes)).toEqual({
      points: [{ y: 2 }, { y: 4 }],
      pair: [1.5, -2],
    });
  });

  test("does not know a member that the definition lacks", () => {
    expect(new Decoder(typeOf(SCHEMA), { frame: true, absent: true }).decode(bytes)).toEqual({
      frame: 7,
    });
  });

  test("refuses a message that ends early", () => {
    expect(() => new Decoder(typeOf(SCHEMA)).decode(bytes.subarray(0, 30))).toThrow();
  });
});

async function logOf(times: number[]): Promise<LogFile> {
  const parts: Uint8Array[] = [];
  let size = 0n;
  const writer = new McapWriter({
    chunkSize: 90,
    writable: {
      write: (bytes: Uint8Array) => {
        parts.push(bytes.slice());
        size += BigInt(bytes.length);
        return Promise.resolve();
      },
      position: () => size,
    },
  });
  await writer.start({ profile: "", library: "test" });
  const schemaId = await writer.registerSchema({
    name: "kelpie/Thing",
    encoding: "ros1msg",
    data: new TextEncoder().encode(SCHEMA),
  });
  const channelId = await writer.registerChannel({
    topic: "/thing",
    schemaId,
    messageEncoding: "ros1",
    metadata: new Map(),
  });
  for (const [i, time] of times.entries())
    await writer.addMessage({
      channelId,
      sequence: i,
      logTime: BigInt(time) * 1000n,
      publishTime: 0n,
      data: encoded(i, time, [], ""),
    });
  await writer.end();
  const file = new Uint8Array(Number(size));
  parts.reduce((at, part) => (file.set(part, at), at + part.length), 0);
  return LogFile.open({
    size: async () => size,
    read: async (o, n) => file.slice(Number(o), Number(o + n)),
  });
}

describe("a log", () => {
  test("knows nothing before it is read, and then both neighbours", async () => {
    const stream = (await logOf([100, 200, 300, 400, 500])).stream("/thing")!;
    expect(stream.around(250)).toBeUndefined();
    await stream.load(250);
    const { before, after } = stream.around(250)!;
    expect([before!.time, after!.time]).toEqual([200, 300]);
    expect((before!.value as Structure)["frame"]).toBe(1);
  });

  test("has nothing before its first message and nothing behind its last", async () => {
    const stream = (await logOf([100, 200, 300])).stream("/thing")!;
    await stream.load(50);
    expect(stream.around(50)).toMatchObject({ before: undefined, after: { time: 100 } });
    await stream.load(900);
    expect(stream.around(900)).toMatchObject({ before: { time: 300 }, after: undefined });
  });

  test("knows no topic that it lacks", async () => {
    expect((await logOf([1])).stream("/absent")).toBeUndefined();
  });
});

test("a live topic keeps its bytes within the bound", () => {
  const stream = new RingStream("/thing", typeOf(SCHEMA), 36 * 100);
  for (let i = 0; i < 1000; ++i) stream.add(i * 1000, encoded(i, i, [], ""));
  expect(stream.count).toBeLessThan(100 + 65);
  expect(stream.around(999e3).before!.time).toBe(999e3);
});

test("a live topic begins anew with a match that does", () => {
  const stream = new RingStream("/thing", typeOf(SCHEMA));
  stream.add(50e6, encoded(1, 1, [], ""));
  stream.add(1e6, encoded(2, 2, [], ""));
  expect(stream.count).toBe(1);
});

test("the last time that is not later is found", () => {
  const times = [1, 3, 3, 9];
  expect([0, 1, 3, 8, 99].map((t) => lastNotAfter(4, (i) => times[i]!, t))).toEqual([
    -1, 0, 2, 2, 3,
  ]);
});
