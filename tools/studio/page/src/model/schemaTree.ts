// SPDX-License-Identifier: Apache-2.0
// The numbers within a type, as paths, for who wants to plot one.
import type { Member, MemberType } from "../reading/decoder";

const LONGEST = 24; // of an array whose numbers are listed one by one
const OF_A_LIST = 3; // of a list of any length

export function numberPaths(type: MemberType, before = ""): string[] {
  return (type.members ?? []).flatMap((member) => pathsOf(member, `${before}${member.name}`));
}

function pathsOf(member: Member, path: string): string[] {
  if (!member.isArray) return inner(member.type, path);
  if (member.type.name === "uint8" && (member.length ?? 1e9) > LONGEST) return [];
  const count = Math.min(member.length ?? OF_A_LIST, LONGEST);
  return Array.from({ length: count }, (_, i) => inner(member.type, `${path}.${i}`)).flat();
}

function inner(type: MemberType, path: string): string[] {
  if (type.members) return numberPaths(type, `${path}.`);
  return type.name === "string" ? [] : [path];
}

// Those in which all the words stand, shortest first.
export function found(paths: readonly string[], words: string, most: number): string[] {
  const parts = words
    .toLowerCase()
    .split(/\s+/)
    .filter((word) => word !== "");
  return paths
    .filter((path) => parts.every((part) => path.toLowerCase().includes(part)))
    .sort((a, b) => a.length - b.length || a.localeCompare(b))
    .slice(0, most);
}
