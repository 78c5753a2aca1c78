// SPDX-License-Identifier: Apache-2.0
// All values of one number of one topic, told as they are read. Where a list is shorter than the
// path asks, or a member is absent, the value is not a number.
import { Decoder, type Structure, type Value, type Wanted } from "../reading/decoder";
import type { LogFile } from "../reading/logFile";

// "world.modes.0.weight" asks for world.modes with weight in each.
export function wantedOf(path: string): Wanted {
  const names = path.split(".").filter((name) => !/^\d+$/.test(name));
  return names.reduceRight<Wanted>((inner, name) => ({ [name]: inner }), true);
}

export function valueOf(message: Structure, path: string): number {
  let value: Value | undefined = message;
  for (const name of path.split(".")) {
    if (value === undefined || value === null || typeof value !== "object") return NaN;
    value = (value as Record<string, Value>)[name];
  }
  if (typeof value === "boolean") return value ? 1 : 0;
  return typeof value === "number" ? value : NaN;
}

const CHUNKS_A_TELLING = 40;

export async function readSeries(
  log: LogFile,
  topic: string,
  path: string,
  tell: (times: Float64Array, values: Float64Array, done: boolean) => void,
): Promise<void> {
  const channel = log.channels.get(topic);
  const type = log.typeOf(topic);
  if (!channel || !type) return tell(new Float64Array(), new Float64Array(), true);
  const decoder = new Decoder(type, wantedOf(path));
  const places = log.chunks.flatMap((c, i) => (c.channels.has(channel.id) ? [i] : []));
  let times: number[] = [];
  let values: number[] = [];
  for (const [i, place] of places.entries()) {
    for (const { time, bytes } of (await log.chunk(place)).messages.get(channel.id) ?? []) {
      times.push(time);
      values.push(valueOf(decoder.decode(bytes), path));
    }
    const done = i === places.length - 1;
    if (!done && i % CHUNKS_A_TELLING !== CHUNKS_A_TELLING - 1) continue;
    tell(Float64Array.from(times), Float64Array.from(values), done);
    times = [];
    values = [];
  }
}
