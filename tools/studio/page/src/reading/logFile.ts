// SPDX-License-Identifier: Apache-2.0
// A log behind an address: its summary at once, its chunks when they are needed, the last ones
// kept. Fails with a sentence where it is no log with an index.
import { McapIndexedReader } from "@mcap/core";
import { parseChunk, type Chunk } from "./chunk";
import { Decoder, Types, type MemberType } from "./decoder";
import type { Readable } from "./httpFile";
import { LazyMessage, lastNotAfter, type Around, type Message, type Stream } from "./stream";

const KEPT_BYTES = 48e6; // of a log's chunks, unpacked

export interface ChunkPlace {
  offset: bigint;
  length: bigint;
  from: number; // us
  to: number;
  channels: ReadonlySet<number>;
}
export interface Channel {
  id: number;
  topic: string;
  schema: string;
  schemaName: string;
}

export class LogFile {
  readonly channels = new Map<string, Channel>(); // by topic
  readonly chunks: ChunkPlace[];
  private readonly cache = new Map<number, Chunk>(); // least recently used first
  private readonly coming = new Map<number, Promise<Chunk>>();
  private keptBytes = 0;

  static async open(readable: Readable, types = new Types()): Promise<LogFile> {
    return new LogFile(readable, await McapIndexedReader.Initialize({ readable }), types);
  }

  private constructor(
    private readonly readable: Readable,
    reader: McapIndexedReader,
    private readonly types: Types,
  ) {
    const texts = new TextDecoder();
    for (const { id, topic, schemaId } of reader.channelsById.values()) {
      const schema = reader.schemasById.get(schemaId);
      const text = schema ? texts.decode(schema.data) : "";
      this.channels.set(topic, { id, topic, schema: text, schemaName: schema?.name ?? "" });
    }
    this.chunks = reader.chunkIndexes
      .map((c) => ({
        offset: c.chunkStartOffset,
        length: c.chunkLength,
        from: Number(c.messageStartTime / 1000n),
        to: Number(c.messageEndTime / 1000n),
        channels: new Set(c.messageIndexOffsets.keys()),
      }))
      .sort((a, b) => a.from - b.from);
  }

  get from(): number {
    return this.chunks[0]?.from ?? 0;
  }
  get to(): number {
    return this.chunks.reduce((latest, c) => Math.max(latest, c.to), 0);
  }

  typeOf(topic: string): MemberType | undefined {
    const channel = this.channels.get(topic);
    if (!channel) return undefined;
    return this.types.of(channel.schema);
  }

  // Where the chunk is in memory, that; it counts as used.
  kept(index: number): Chunk | undefined {
    const chunk = this.cache.get(index);
    if (!chunk) return undefined;
    this.cache.delete(index);
    this.cache.set(index, chunk);
    return chunk;
  }

  async chunk(index: number): Promise<Chunk> {
    const kept = this.kept(index);
    if (kept) return kept;
    const before = this.coming.get(index);
    if (before) return before;
    const now = this.fetch(index).finally(() => this.coming.delete(index));
    this.coming.set(index, now);
    return now;
  }

  private async fetch(index: number): Promise<Chunk> {
    const place = this.chunks[index]!;
    const chunk = parseChunk(await this.readable.read(place.offset, place.length));
    this.cache.set(index, chunk);
    this.keptBytes += chunk.bytes;
    for (const [oldest, dropped] of this.cache) {
      if (this.keptBytes <= KEPT_BYTES || oldest === index) break;
      this.cache.delete(oldest);
      this.keptBytes -= dropped.bytes;
    }
    return chunk;
  }

  stream(topic: string): FileStream | undefined {
    const channel = this.channels.get(topic);
    const type = this.typeOf(topic);
    return channel && type ? new FileStream(this, channel, type) : undefined;
  }
}

export class FileStream implements Stream {
  readonly topic: string;
  private readonly decoder: Decoder;
  private readonly places: number[]; // chunks that hold the channel
  private readonly decoded = new WeakMap<Uint8Array, Message>();

  constructor(
    private readonly log: LogFile,
    private readonly channel: Channel,
    readonly type: MemberType,
  ) {
    this.topic = channel.topic;
    this.decoder = new Decoder(type);
    this.places = log.chunks
      .map((_, i) => i)
      .filter((i) => log.chunks[i]!.channels.has(channel.id));
  }

  get from(): number {
    return this.place(0)?.from ?? 0;
  }
  get to(): number {
    return this.place(this.places.length - 1)?.to ?? 0;
  }

  around(time: number): Around | undefined {
    const at = this.placeAt(time);
    const here = this.messages(at);
    if (!here) return undefined;
    const i = lastNotAfter(here.length, (k) => here[k]!.time, time);
    const before = i >= 0 ? here[i] : this.edge(at - 1, "last");
    const after = i + 1 < here.length ? here[i + 1] : this.edge(at + 1, "first");
    if (before === "absent" || after === "absent") return undefined;
    return { before: before && this.message(before), after: after && this.message(after) };
  }

  // The neighbours of a chunk are read only where the time is at its edge.
  async load(time: number): Promise<void> {
    const at = this.placeAt(time);
    await this.loadPlace(at);
    const here = this.messages(at) ?? [];
    const i = lastNotAfter(here.length, (k) => here[k]!.time, time);
    if (i < 0) await this.loadPlace(at - 1);
    if (i + 1 >= here.length) await this.loadPlace(at + 1);
  }

  private async loadPlace(i: number): Promise<void> {
    const index = this.places[i];
    if (index !== undefined) await this.log.chunk(index);
  }

  private place(i: number) {
    const index = this.places[i];
    return index === undefined ? undefined : this.log.chunks[index];
  }

  private placeAt(time: number): number {
    return Math.max(
      0,
      lastNotAfter(this.places.length, (i) => this.place(i)!.from, time),
    );
  }

  private messages(i: number) {
    const index = this.places[i];
    if (index === undefined) return [];
    const chunk = this.log.kept(index);
    return chunk ? (chunk.messages.get(this.channel.id) ?? []) : undefined;
  }

  private edge(i: number, which: "first" | "last") {
    const list = this.messages(i);
    if (!list) return "absent" as const;
    return which === "first" ? list[0] : list[list.length - 1];
  }

  private message(raw: { time: number; bytes: Uint8Array }): Message {
    const before = this.decoded.get(raw.bytes);
    if (before) return before;
    const message = new LazyMessage(raw.time, raw.bytes, this.decoder);
    this.decoded.set(raw.bytes, message);
    return message;
  }
}
