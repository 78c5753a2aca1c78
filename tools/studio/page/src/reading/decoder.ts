// SPDX-License-Identifier: Apache-2.0
// Decodes ROS 1 messages by the definition that stands in the log, whole or only the members that
// are asked for; the others are passed over. It makes no code from text, which the page's security
// policy forbids. Bytes that end early give an error.
import { parse } from "@foxglove/rosmsg";

export type Value = number | boolean | string | Uint8Array | Float64Array | Value[] | Structure;
export interface Structure {
  [name: string]: Value;
}

interface Cursor {
  view: DataView;
  at: number;
}
type Step = (c: Cursor) => Value;
export interface Member {
  name: string;
  type: MemberType;
  isArray: boolean;
  length: number | undefined; // of an array with a fixed length
}
export interface MemberType {
  name: string;
  members: Member[] | undefined; // of a structure
  size: number | undefined; // bytes, where that is fixed
}
export type Wanted = true | { [name: string]: Wanted };

type Reading = [size: number, read: Step];
const NUMBERS: Record<string, Reading> = {
  bool: [1, (c) => c.view.getUint8(c.at) !== 0],
  uint8: [1, (c) => c.view.getUint8(c.at)],
  int8: [1, (c) => c.view.getInt8(c.at)],
  uint16: [2, (c) => c.view.getUint16(c.at, true)],
  int16: [2, (c) => c.view.getInt16(c.at, true)],
  uint32: [4, (c) => c.view.getUint32(c.at, true)],
  int32: [4, (c) => c.view.getInt32(c.at, true)],
  uint64: [8, (c) => Number(c.view.getBigUint64(c.at, true))],
  int64: [8, (c) => Number(c.view.getBigInt64(c.at, true))],
  float32: [4, (c) => c.view.getFloat32(c.at, true)],
  float64: [8, (c) => c.view.getFloat64(c.at, true)],
};
const texts = new TextDecoder();

// Types by the text of their definition: the logs of a match hold the same ones, and to parse a
// text takes tens of milliseconds.
export class Types {
  private readonly known = new Map<string, MemberType>();

  of(schema: string): MemberType {
    let type = this.known.get(schema);
    if (!type) this.known.set(schema, (type = typeOf(schema)));
    return type;
  }
}

// The type of the first definition, with all within it.
export function typeOf(schema: string): MemberType {
  const definitions = parse(schema);
  const known = new Map<string, MemberType>();
  const build = (name: string): MemberType => {
    const before = known.get(name);
    if (before) return before;
    const number = NUMBERS[name];
    const type: MemberType = { name, members: undefined, size: number?.[0] };
    known.set(name, type);
    const definition = definitions.find((d) => d.name === name);
    if (definition) complete(type, definition.definitions, build);
    else if (!number && name !== "string") throw new Error(`the type ${name} is not defined`);
    return type;
  };
  const root: MemberType = { name: "", members: undefined, size: undefined };
  const first = definitions.find((d) => d.name === undefined) ?? definitions[0];
  complete(root, first?.definitions ?? [], build);
  return root;
}

type Definition = ReturnType<typeof parse>[number]["definitions"][number];

function complete(type: MemberType, lines: Definition[], build: (name: string) => MemberType) {
  type.members = lines
    .filter((line) => !line.isConstant)
    .map((line) => ({
      name: line.name,
      type: build(line.type),
      isArray: line.isArray ?? false,
      length: line.arrayLength,
    }));
  let size: number | undefined = 0;
  for (const member of type.members) {
    const times: number | undefined = member.isArray ? member.length : 1;
    if (size === undefined || member.type.size === undefined || times === undefined)
      size = undefined;
    else size += member.type.size * times;
  }
  type.size = size;
}

export class Decoder {
  private readonly step: Step;

  constructor(
    readonly type: MemberType,
    wanted: Wanted = true,
  ) {
    this.step = structure(type, wanted);
  }

  decode(bytes: Uint8Array): Structure {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    return this.step({ view, at: 0 }) as Structure;
  }
}

function structure(type: MemberType, wanted: Wanted): Step {
  const steps = (type.members ?? []).map((member) => {
    const asked = wanted === true ? true : wanted[member.name];
    return {
      name: member.name,
      keep: asked !== undefined,
      step: asked === undefined ? passing(member) : reading(member, asked),
    };
  });
  while (steps.length > 0 && !steps[steps.length - 1]!.keep && wanted !== true && !nested(type))
    steps.pop();
  return (c) => {
    const made: Structure = {};
    for (const { name, keep, step } of steps) {
      const value = step(c);
      if (keep) made[name] = value;
    }
    return made;
  };
}

// What stands behind the last member that is asked for need not be passed over, but within another
// structure.
function nested(type: MemberType): boolean {
  return type.name !== "";
}

function reading(member: Member, wanted: Wanted): Step {
  return member.isArray ? array(member, wanted) : single(member.type, wanted);
}

function single(type: MemberType, wanted: Wanted): Step {
  if (type.members) return structure(type, wanted);
  if (type.name === "string") return text;
  const [size, read] = NUMBERS[type.name]!;
  return (c) => {
    const value = read(c);
    c.at += size;
    return value;
  };
}

function text(c: Cursor): string {
  const length = c.view.getUint32(c.at, true);
  const bytes = new Uint8Array(c.view.buffer, c.view.byteOffset + c.at + 4, length);
  c.at += 4 + length;
  return texts.decode(bytes);
}

function countOf(member: Member, c: Cursor): number {
  if (member.length !== undefined) return member.length;
  const count = c.view.getUint32(c.at, true);
  c.at += 4;
  return count;
}

function array(member: Member, wanted: Wanted): Step {
  if (member.type.name === "uint8") return (c) => bytesAt(c, countOf(member, c));
  const item = single(member.type, wanted);
  return (c) => {
    const count = countOf(member, c);
    const size = member.type.size ?? 4;
    if (c.at + count * size > c.view.byteLength) throw new Error("a message ends early");
    const items: Value[] = new Array<Value>(count);
    for (let i = 0; i < count; ++i) items[i] = item(c);
    return items;
  };
}

function bytesAt(c: Cursor, count: number): Uint8Array {
  if (c.at + count > c.view.byteLength) throw new Error("a message ends early");
  const bytes = new Uint8Array(c.view.buffer, c.view.byteOffset + c.at, count);
  c.at += count;
  return bytes;
}

function passing(member: Member): Step {
  const size = member.type.size;
  if (!member.isArray && size !== undefined) return (c) => ((c.at += size), 0);
  if (member.isArray && size !== undefined)
    return (c) => {
      const count = countOf(member, c);
      c.at += count * size;
      return 0;
    };
  return reading(member, true);
}
