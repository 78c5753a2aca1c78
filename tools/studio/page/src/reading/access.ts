// SPDX-License-Identifier: Apache-2.0
// Members of a decoded message by their path. Logs of other versions lack some: then the answer is
// undefined, or what the caller gives for it.
import type { Structure, Value } from "./decoder";

export function valueAt(from: Structure | undefined, path: string): Value | undefined {
  let value: Value | undefined = from;
  for (const name of path.split(".")) {
    if (value === undefined || value === null || typeof value !== "object") return undefined;
    value = (value as Structure)[name];
  }
  return value;
}

export function numberAt(from: Structure | undefined, path: string): number | undefined {
  const value = valueAt(from, path);
  if (typeof value === "boolean") return value ? 1 : 0;
  return typeof value === "number" && Number.isFinite(value) ? value : undefined;
}

export function flagAt(from: Structure | undefined, path: string): boolean {
  return numberAt(from, path) === 1;
}

export function textAt(from: Structure | undefined, path: string): string {
  const value = valueAt(from, path);
  return typeof value === "string" ? value : "";
}

export function structureAt(from: Structure | undefined, path: string): Structure | undefined {
  const value = valueAt(from, path);
  return value !== undefined &&
    typeof value === "object" &&
    !Array.isArray(value) &&
    !ArrayBuffer.isView(value)
    ? (value as Structure)
    : undefined;
}

export function listAt(from: Structure | undefined, path: string): Structure[] {
  const value = valueAt(from, path);
  return Array.isArray(value) ? (value as Structure[]) : [];
}

export function numbersAt(from: Structure | undefined, path: string): number[] {
  const value = valueAt(from, path);
  return Array.isArray(value) ? (value as number[]) : [];
}

export function bytesAt(from: Structure | undefined, path: string): Uint8Array | undefined {
  const value = valueAt(from, path);
  return value instanceof Uint8Array ? value : undefined;
}
