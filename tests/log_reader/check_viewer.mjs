// SPDX-License-Identifier: Apache-2.0
// node check_viewer.mjs FILE: decodes every message of a file for viewers twice, by the definition
// that the file holds and by the one that Foxglove publishes (its package makes .proto files), and
// fails where the two differ in a name or a value. Prints the count of each type as JSON. Our own
// types are decoded by the file's definition alone.
import { readFileSync } from "node:fs";
import { McapStreamReader } from "@mcap/core";
import * as published from "@foxglove/schemas/internal.js";
import protobuf from "protobufjs";
import descriptor from "protobufjs/ext/descriptor/index.js";
import { decompress } from "fzstd";

const { foxgloveMessageSchemas, foxgloveEnumSchemas, generateProto } = published.default ?? published;
const asTexts = { longs: Number, enums: String, bytes: String, defaults: true, arrays: true };

function publishedTypes() {
  const root = new protobuf.Root();
  for (const name of ["timestamp", "duration"]) {
    root.addJSON(protobuf.common.get(`google/protobuf/${name}.proto`).nested);
  }
  for (const schema of Object.values(foxgloveMessageSchemas)) {
    const enums = Object.values(foxgloveEnumSchemas).filter(
      ({ parentSchemaName }) => parentSchemaName === schema.name,
    );
    protobuf.parse(generateProto(schema, enums), root, { keepCase: true });
  }
  return root;
}

// Members by name: the order in which two definitions list them is no matter.
function sorted(value) {
  if (Array.isArray(value)) return value.map(sorted);
  if (value === null || typeof value !== "object") return value;
  const names = Object.keys(value).sort();
  return Object.fromEntries(names.map((name) => [name, sorted(value[name])]));
}

function typesOf(schema, root) {
  const own = protobuf.Root.fromDescriptor(descriptor.FileDescriptorSet.decode(schema.data));
  const theirs = schema.name.startsWith("foxglove.") ? root : own;
  return [own, theirs].map((types) => types.lookupType(schema.name));
}

// JSON says a definition's snake_case names in camelCase where it comes from a descriptor.
function textOf(type, data) {
  return JSON.stringify(sorted(type.toObject(type.decode(data), asTexts))).replaceAll("_", "");
}

function check(bytes) {
  const root = publishedTypes();
  const decompressHandlers = {
    zstd: (from, size) => decompress(from, new Uint8Array(Number(size))),
  };
  const reader = new McapStreamReader({ decompressHandlers });
  const types = new Map();
  const channels = new Map();
  const counts = {};
  reader.append(bytes);
  for (let record = reader.nextRecord(); record; record = reader.nextRecord()) {
    if (record.type === "Schema" && !types.has(record.id)) {
      types.set(record.id, { name: record.name, pair: typesOf(record, root) });
    }
    if (record.type === "Channel") channels.set(record.id, record);
    if (record.type !== "Message") continue;
    const { topic, schemaId } = channels.get(record.channelId);
    const { name, pair } = types.get(schemaId);
    const [own, theirs] = pair.map((type) => textOf(type, record.data).toLowerCase());
    if (own !== theirs) throw new Error(`${topic}: ${own} is not ${theirs}`);
    counts[name] = (counts[name] ?? 0) + 1;
  }
  if (!reader.done()) throw new Error("the file has no end");
  return counts;
}

console.log(JSON.stringify(check(readFileSync(process.argv[2]))));
