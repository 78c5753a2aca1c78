// SPDX-License-Identifier: Apache-2.0
// The names and lengths that the page shares with the C++ sources, read from these when the page is
// built: enumerations, special motions, sizes. It fails where a name that is asked for is missing.
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

const HEADERS = [
  "robot/core/types/Command.h",
  "robot/core/types/FrameInput.h",
  "robot/core/types/Motion.h",
  "robot/core/types/ObjectPercepts.h",
  "robot/core/types/Percepts.h",
  "robot/core/types/Image.h",
  "robot/core/types/TeamNote.h",
  "robot/core/types/Joints.h",
  "robot/body/FieldDescription.h",
  "tools/sim/world/Truth.h",
];
const NEEDED_ENUMS = [
  "EventKind",
  "PlayState",
  "TraceLayer",
  "Fallback",
  "FallSide",
  "LandmarkKind",
  "LinePointKind",
  "Role",
  "WalkKind",
];
const NEEDED_NUMBERS = ["kImageWidth", "kImageHeight", "kBallRadius", "kNoTime"];

export interface Motion {
  name: string;
  use: string;
}
export interface CppNames {
  enums: Record<string, string[]>;
  numbers: Record<string, number>;
  motions: Motion[];
  palette: [number, number, number][]; // how viewers draw each colour class
}

function enumsOf(text: string): [string, string[]][] {
  const plain = text.replace(/\/\/.*$/gm, "");
  const found = plain.matchAll(/enum class (\w+)\s*:\s*[\w:]+\s*\{([^}]*)\}/g);
  return [...found].map(([, name, list]) => [
    name!,
    (list ?? "")
      .split(",")
      .map((value) => value.trim())
      .filter((value) => value !== ""),
  ]);
}

function numbersOf(text: string): [string, number][] {
  const found = text.matchAll(/constexpr (?:int|double) (k\w+)\s*=\s*(-?[\d.]+);/g);
  return [...found].map(([, name, value]) => [name!, Number(value)]);
}

// The rows of kColourPalette.
function paletteOf(text: string): [number, number, number][] {
  const table = /kColourPalette = \{\{([\s\S]*?)\}\};/.exec(text)?.[1] ?? "";
  return [...table.matchAll(/(\d+),\s*(\d+),\s*(\d+)/g)].map(([, r, g, b]) => [
    Number(r),
    Number(g),
    Number(b),
  ]);
}

// Sections of the list of choices: `[Role]`, then `name = "PYTHON_NAME"` in order.
function choicesOf(text: string): [string, string[]][] {
  return text
    .split(/^\[/m)
    .slice(1)
    .map((section) => {
      const names = [...section.matchAll(/^(\w+) = "[A-Z0-9_]+"$/gm)].map((m) => m[1]!);
      return [section.slice(0, section.indexOf("]")), names];
    });
}

function motionsOf(folder: string): Motion[] {
  const motions: Motion[] = [{ name: "none", use: "rest" }];
  for (const file of readdirSync(folder).filter((name) => name.endsWith(".toml"))) {
    const line = /motion = \{ number = (\d+)(?:, use = "(\w+)")?/.exec(
      readFileSync(join(folder, file), "utf8"),
    );
    if (line) motions[Number(line[1])] = { name: file.replace(".toml", ""), use: line[2] ?? "" };
  }
  const mirrored = (name: string) =>
    name.includes("right") ? name.replace("right", "left") : name.replace("left", "right");
  const useOf = ({ name, use }: Motion) =>
    use !== "" ? use : (motions.find((other) => other?.name === mirrored(name))?.use ?? "rest");
  return Array.from(motions, (motion) =>
    motion ? { name: motion.name, use: useOf(motion) } : { name: "unknown", use: "rest" },
  );
}

export function readCppNames(root: string): CppNames {
  const texts = HEADERS.map((path) => readFileSync(join(root, path), "utf8"));
  const choices = choicesOf(readFileSync(join(root, "robot/core/enumerations.toml"), "utf8"));
  const enums = Object.fromEntries([...texts.flatMap(enumsOf), ...choices]);
  const numbers = Object.fromEntries(texts.flatMap(numbersOf));
  for (const name of NEEDED_ENUMS) if (!enums[name]) throw new Error(`no enumeration ${name}`);
  for (const name of NEEDED_NUMBERS)
    if (numbers[name] === undefined) throw new Error(`no number ${name}`);
  const palette = paletteOf(readFileSync(join(root, "vision/colour/ColourClass.h"), "utf8"));
  if (palette.length === 0) throw new Error("no colour palette");
  return { enums, numbers, motions: motionsOf(join(root, "actuator/data/motions")), palette };
}

// The module "kelpie:names" for the page.
export function cppNames(root: string) {
  return {
    name: "kelpie-names",
    resolveId: (id: string) => (id === "kelpie:names" ? "\0kelpie:names" : undefined),
    load: (id: string) =>
      id === "\0kelpie:names" ? `export default ${JSON.stringify(readCppNames(root))};` : undefined,
  };
}
