// SPDX-License-Identifier: Apache-2.0
// node check_log.mjs LOG: decodes every message of a log by the schema that the log itself carries,
// with @mcap/core and Foxglove's ROS 1 decoder. Prints the count of each topic. Fails when anything
// cannot be decoded, when encoding it again gives other bytes, when a checksum is wrong, when the
// log's own statistics count otherwise, or when a reader that jumps by the indexes finds other
// messages than one that reads from front to back. SHOW_FIELDS=1 prints each topic's last message.
//
// Why these readers: those who made the format made them, container and messages alike, so nothing
// of ours judges our own bytes. Debian has no MCAP reader; its python3-genpy decodes the messages
// but would leave the container to us. npm gets them where it is on the machine; it is not installed
// for them, since Debian's npm brings 376 packages.
import { readFileSync } from "node:fs";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { crc32 } from "@foxglove/crc";
import { parse } from "@foxglove/rosmsg";
import { MessageReader, MessageWriter } from "@foxglove/rosmsg-serialization";
import { decompress } from "fzstd";

const decompressHandlers = {
  zstd: (bytes, size) => decompress(bytes, new Uint8Array(Number(size))),
};

function require(fact, what) {
  if (!fact) throw new Error(what);
}

function codecOf(schema) {
  require(schema.encoding === "ros1msg", `schema encoding ${schema.encoding}`);
  const definitions = parse(new TextDecoder().decode(schema.data), { ros2: false });
  return {
    name: schema.name,
    reader: new MessageReader(definitions),
    writer: new MessageWriter(definitions),
  };
}

// A message as text to compare by: where it belongs, when it was, what it holds.
function keyOf(message) {
  const { channelId, sequence, logTime, publishTime, data } = message;
  return [channelId, sequence, logTime, publishTime, data.length, crc32(data)].join(" ");
}

// What is open while a log is read from front to back.
class Contents {
  codecs = new Map(); // schema id -> { name, reader, writer }
  channels = new Map(); // channel id -> { topic, schema, count, last }
  chunks = []; // { start, end, count, crc } of each chunk, times of its messages
  keys = []; // of all messages, in the order of the file
  statistics;

  take(record) {
    if (record.type === "Schema") this.codecs.set(record.id, codecOf(record));
    if (record.type === "Channel") this.takeChannel(record);
    if (record.type === "Chunk") this.takeChunk(record);
    if (record.type === "Message") this.takeMessage(record);
    if (record.type === "Statistics") this.statistics = record;
  }

  takeChannel({ id, topic, schemaId }) {
    if (this.channels.has(id)) return; // each chunk and the summary repeat it
    this.channels.set(id, { topic, schema: schemaId, count: 0 });
  }

  takeChunk({ compression, uncompressedCrc, messageStartTime, messageEndTime }) {
    require(uncompressedCrc !== 0, "a chunk has no checksum");
    require(compression === "" || compression === "zstd", `compression ${compression}`);
    this.chunks.push({ start: messageStartTime, end: messageEndTime, compression, times: [] });
  }

  takeMessage(record) {
    const channel = this.channels.get(record.channelId);
    const { reader, writer } = this.codecs.get(channel.schema);
    channel.last = reader.readMessage(record.data);
    require(
      Buffer.compare(writer.writeMessage(channel.last), record.data) === 0,
      `${channel.topic}: other bytes when encoded again`,
    );
    channel.count += 1;
    this.keys.push(keyOf(record));
    this.chunks.at(-1)?.times.push(record.logTime);
  }
}

function readFromFrontToBack(bytes) {
  const contents = new Contents();
  const reader = new McapStreamReader({ includeChunks: true, decompressHandlers });
  reader.append(bytes);
  for (let record = reader.nextRecord(); record; record = reader.nextRecord()) {
    contents.take(record);
  }
  require(reader.done(), "the log has no end");
  require(contents.keys.length > 0, "no messages");
  return contents;
}

function checkStatistics({ channels, chunks, keys, statistics }) {
  require(statistics, "no statistics");
  require(Number(statistics.messageCount) === keys.length, "the statistics count otherwise");
  require(statistics.chunkCount === chunks.length, "the statistics count other chunks");
  for (const [id, { topic, count }] of channels) {
    require(
      Number(statistics.channelMessageCounts.get(id) ?? 0n) === count,
      `${topic}: the statistics count otherwise`,
    );
  }
}

function checkChunkTimes({ chunks }) {
  for (const [number, { start, end, times }] of chunks.entries()) {
    const sorted = times.sort((a, b) => Number(a - b));
    require(
      sorted.length === 0 || (sorted[0] === start && sorted.at(-1) === end),
      `chunk ${number}: its times are not those of its messages`,
    );
  }
}

async function indexedReader(bytes) {
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, size) => {
      require(offset + size <= BigInt(bytes.length), `an index points to byte ${offset + size}`);
      return new Uint8Array(bytes.subarray(Number(offset), Number(offset + size)));
    },
  };
  return McapIndexedReader.Initialize({ readable, decompressHandlers });
}

async function keysByIndex(reader, choice) {
  const keys = [];
  let before = 0n;
  for await (const message of reader.readMessages(choice)) {
    require(message.logTime >= before, "the indexes give messages out of order");
    before = message.logTime;
    keys.push(keyOf(message));
  }
  return keys;
}

function checkSame(one, other, what) {
  const sorted = [...one].sort();
  const same = one.length === other.length && [...other].sort().every((k, i) => k === sorted[i]);
  require(same, `${what}: ${other.length} messages by the indexes, ${one.length} in the log`);
}

// The whole log, each topic, and the latter half of the time, through the indexes alone.
async function checkIndexes(bytes, { channels, chunks, keys }) {
  const reader = await indexedReader(bytes);
  require(
    reader.dataSectionCrc === undefined ||
      crc32(bytes.subarray(0, Number(reader.dataEndOffset))) === reader.dataSectionCrc,
    "wrong checksum of the data section",
  );
  require(reader.chunkIndexes.length === chunks.length, "not every chunk is in the index");
  if (chunks.length === 0) return;
  checkSame(keys, await keysByIndex(reader, {}), "whole log");
  for (const [id, { topic }] of channels) {
    const own = keys.filter((key) => key.startsWith(`${id} `));
    checkSame(own, await keysByIndex(reader, { topics: [topic] }), topic);
  }
  const times = keys.map((key) => BigInt(key.split(" ")[2])).sort((a, b) => Number(a - b));
  const startTime = times[times.length >> 1];
  const late = keys.filter((key) => BigInt(key.split(" ")[2]) >= startTime);
  checkSame(late, await keysByIndex(reader, { startTime }), "latter half");
}

function report({ codecs, channels, chunks, keys }) {
  for (const { topic, schema, count, last } of channels.values()) {
    console.log(`${topic}  ${codecs.get(schema).name}  ${count} messages`);
    if (process.env.SHOW_FIELDS) console.dir(last, { depth: 3, maxArrayLength: 4 });
  }
  const compressed = chunks.filter(({ compression }) => compression !== "").length;
  console.log(`${keys.length} messages decoded, ${chunks.length} chunks, ${compressed} compressed`);
}

try {
  require(process.argv.length === 3, "usage: node check_log.mjs LOG");
  const bytes = readFileSync(process.argv[2]);
  const contents = readFromFrontToBack(bytes);
  checkStatistics(contents);
  checkChunkTimes(contents);
  await checkIndexes(bytes, contents);
  report(contents);
} catch (error) {
  console.error(`${process.argv[2] ?? "check_log"}: ${error.message}`);
  process.exit(1);
}
