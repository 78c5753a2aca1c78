// SPDX-License-Identifier: Apache-2.0
// node check_log.mjs LOG: decodes every message of a log by the schema that the log itself carries,
// with @mcap/core and Foxglove's ROS 1 decoder. Prints the count of each topic. Fails when anything
// cannot be decoded, when encoding it again gives other bytes, or when the log's own statistics
// count otherwise. SHOW_FIELDS=1 prints the last message of each topic.
import { createReadStream } from "node:fs";
import { McapStreamReader } from "@mcap/core";
import { parse } from "@foxglove/rosmsg";
import { decompress } from "fzstd";
import { MessageReader, MessageWriter } from "@foxglove/rosmsg-serialization";

const schemas = new Map(); // id -> { name, reader, writer }
const channels = new Map(); // id -> { topic, schema, count, last }
let statistics;

function take(record) {
  switch (record.type) {
    case "Schema": {
      if (record.encoding !== "ros1msg") throw new Error(`schema encoding ${record.encoding}`);
      const definitions = parse(new TextDecoder().decode(record.data), { ros2: false });
      schemas.set(record.id, {
        name: record.name,
        reader: new MessageReader(definitions),
        writer: new MessageWriter(definitions),
      });
      break;
    }
    case "Channel":
      if (channels.has(record.id)) break; // the summary repeats it
      channels.set(record.id, { topic: record.topic, schema: record.schemaId, count: 0 });
      break;
    case "Message": {
      const channel = channels.get(record.channelId);
      const { reader, writer } = schemas.get(channel.schema);
      channel.last = reader.readMessage(record.data);
      if (Buffer.compare(writer.writeMessage(channel.last), record.data) !== 0) {
        throw new Error(`${channel.topic}: other bytes when encoded again`);
      }
      channel.count += 1;
      break;
    }
    case "Statistics":
      statistics = record;
      break;
  }
}

async function readLog(path) {
  const reader = new McapStreamReader({
    validateCrcs: true,
    decompressHandlers: { zstd: (data, size) => decompress(data, new Uint8Array(Number(size))) },
  });
  for await (const piece of createReadStream(path)) {
    reader.append(piece);
    for (let record = reader.nextRecord(); record; record = reader.nextRecord()) take(record);
  }
  if (!reader.done()) throw new Error("the log has no end");
}

function report() {
  let total = 0;
  for (const [id, { topic, schema, count, last }] of channels) {
    console.log(`${topic}  ${schemas.get(schema).name}  ${count} messages`);
    if (statistics && Number(statistics.channelMessageCounts.get(id) ?? 0n) !== count) {
      throw new Error(`${topic}: the statistics count otherwise`);
    }
    if (process.env.SHOW_FIELDS) console.dir(last, { depth: 3, maxArrayLength: 4 });
    total += count;
  }
  if (total === 0) throw new Error("no messages");
  console.log(`${total} messages decoded`);
}

try {
  if (process.argv.length !== 3) throw new Error("usage: node check_log.mjs LOG");
  await readLog(process.argv[2]);
  report();
} catch (error) {
  console.error(`${process.argv[2] ?? "check_log"}: ${error.message}`);
  process.exit(1);
}
