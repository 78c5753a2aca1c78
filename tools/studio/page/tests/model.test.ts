// SPDX-License-Identifier: Apache-2.0
import { Vector3 } from "three";
import { describe, expect, test } from "vitest";
import { readCppNames } from "../plugin/cppNames";
import { comparedOf, readHash, writeHash } from "../src/app/address";
import { TimeAxis } from "../src/app/timeAxis";
import { fromClasses } from "../src/drawing/pictures";
import { BodyTree, bodyOf } from "../src/model/body";
import { addOutput, emptyRows, eventMark, outputMarks, possessionOf } from "../src/model/facts";
import { FactStore, joinMarks, joinSegments } from "../src/model/factStore";
import { MapFrame, fieldFromRobot, poseBetween, type Field } from "../src/model/field";
import { partsOf, wantedTopic } from "../src/model/liveMatch";
import { found, numberPaths } from "../src/model/schemaTree";
import {
  clockOf,
  decisionsOf,
  eventSentence,
  reasonOf,
  sentenceOf,
  shortNumber,
} from "../src/model/words";
import { stepTime } from "../src/panels/timeLine";
import { matchOf, type Match } from "../src/model/match";
import { momentAt } from "../src/model/moment";
import { typeOf } from "../src/reading/decoder";
import type { LogFile } from "../src/reading/logFile";
import type { Stream } from "../src/reading/stream";
import { sameBytes } from "../src/worker/compare";
import { valueOf, wantedOf } from "../src/worker/series";

const step = {
  layer: 3,
  module: "grab_dribble",
  branch: "aim",
  reason: "the gap is {} deg to the left of {}",
  numbers: [12.34],
};

describe("words", () => {
  test("numbers stand in a reason as a person wants to know them", () => {
    expect([83.4, 8.26, 0.127, -0.001].map(shortNumber)).toEqual(["83", "8.3", "0.13", "0"]);
    expect(reasonOf("{} of {}", [1])).toBe("1 of ?");
  });

  test("a decision is told as a sentence", () => {
    expect(sentenceOf(decisionsOf({ trace: [step] })[0]!)).toBe(
      "The skill grab_dribble chose aim: the gap is 12 deg to the left of ?.",
    );
  });

  test("a goal is told with its player", () => {
    expect(eventSentence({ kind: 1, team: 0, player: 2, reason: "" })).toBe(
      "Goal of red by player 2.",
    );
    expect(eventSentence({ kind: 99, team: 0, player: 0, reason: "" })).toBe("An unknown event.");
  });

  test("a clock has minutes and tenths", () => {
    expect([clockOf(65), clockOf(65.27, true), clockOf(-1)]).toEqual(["1:05", "1:05.2", "0:00"]);
  });
});

describe("names of the C++ sources", () => {
  const names = readCppNames(new URL("../../../../", import.meta.url).pathname);

  test("are those of the headers, in order", () => {
    expect(names.enums["PlayState"]).toEqual(["initial", "ready", "set", "playing", "finished"]);
    expect(names.enums["TraceLayer"]![3]).toBe("skill");
  });

  test("give every special motion a use, its mirror image's if need be", () => {
    const kicks = names.motions.filter((m) => m.use === "kick").map((m) => m.name);
    expect(kicks).toContain("head_swipe_right");
    expect(names.motions[0]!.name).toBe("none");
  });
});

describe("frames of reference", () => {
  const field = { width: 360, length: 540 } as Field;

  test("the blue team's field is turned by half a turn", () => {
    const pose = new MapFrame(field, 1).pose({ x: 10, y: 20, heading: 0.5 });
    expect(pose).toEqual({ x: 350, y: 520, heading: 0.5 + Math.PI });
  });

  test("what is ahead of a robot that looks up-field is further up", () => {
    const place = fieldFromRobot({ x: 100, y: 100, heading: Math.PI / 2 }, { x: 5, y: 30 });
    expect(place.x).toBeCloseTo(105);
    expect(place.y).toBeCloseTo(130);
  });

  test("headings are interpolated the short way", () => {
    const half = poseBetween({ x: 0, y: 0, heading: 3 }, { x: 0, y: 0, heading: -3 }, 0.5);
    expect(Math.abs(half.heading)).toBeCloseTo(Math.PI);
  });
});

describe("the body", () => {
  const tree = new BodyTree(
    bodyOf({
      links: [
        { name: "trunk" },
        {
          name: "neck",
          parent: "trunk",
          origin: [0, -0.25, 1.95],
          joint: 0,
          shapes: { size: [1, 1, 1], centre: [0, 0, 0], kind: "box", paint: "dark" },
        },
        { name: "head", parent: "neck", origin: [0, 0, 8], joint: 2 },
      ],
      camera: { link: "head", opening_rad: [1, 0.8] },
    }),
  );
  const level = { shoulderHeight: 11, bodyTilt: 0, bodyRoll: 0 };
  const placeOf = (i: number, joints: number[], stance = level) =>
    new Vector3().setFromMatrixPosition(tree.place(joints, stance, [])[i]!);

  test("has the neck's base above the origin of the robot frame", () => {
    const lean = { ...level, bodyTilt: 0.3 };
    expect(placeOf(1, [0, 0, 0], lean).y).toBeCloseTo(0);
  });

  test("lifts the head with the neck upright and lowers it with the neck forward", () => {
    expect(placeOf(2, [0, 0, 0]).z).toBeCloseTo(11 + 1.95 + 8);
    expect(placeOf(2, [-1, 0, 0]).z).toBeLessThan(18);
    expect(placeOf(2, [-1, 0, 0]).y).toBeGreaterThan(5);
  });

  test("takes one shape as well as a list", () => expect(tree.links[1]!.shapes).toHaveLength(1));
  test("knows what hangs from the head", () => expect([...tree.headLinks]).toEqual([2]));
});

describe("facts", () => {
  const output = {
    command: {
      walk: { forward: 20, left: 0, turn: 0 },
      motion: 0,
      fallback: 0,
      team: { role: 1 },
      trace: [{ ...step, layer: 0, module: "forward", branch: "play" }, step],
    },
  };

  test("equal decisions make one segment", () => {
    const rows = emptyRows();
    addOutput(rows, output, 0, 33e3);
    addOutput(rows, output, 33e3, 66e3);
    expect(rows.skill).toHaveLength(1);
    expect(rows.skill[0]).toMatchObject({ from: 0, to: 66e3, label: "grab_dribble: aim" });
    expect(rows.role[0]!.label).toBe("attacker");
    expect(rows.motion[0]!.label).toBe("walk");
  });

  test("chunks are joined whatever order they came in", () => {
    const store = new FactStore();
    const rowsAt = (from: number) => {
      const rows = emptyRows();
      addOutput(rows, output, from, from + 33e3);
      return rows;
    };
    store.addRows("red-1", 1, rowsAt(33e3));
    store.addRows("red-1", 0, rowsAt(0));
    expect(store.rowsOf("red-1").skill).toMatchObject([{ from: 0, to: 66e3 }]);
  });

  test("a gap in time ends a segment", () => {
    const part = (from: number) => [{ from, to: from + 10, label: "a", why: "" }];
    expect(joinSegments([part(0), part(1e6)])).toHaveLength(2);
  });

  test("a kick that goes on is one mark", () => {
    const kick = { command: { ...output.command, motion: 3 } };
    const before = { motion: 0, fallback: "", fallen: 0 };
    expect(outputMarks(kick, 0, 0, 2, before)).toHaveLength(1);
    expect(outputMarks(kick, 33e3, 0, 2, before)).toHaveLength(0);
    const again = { time: 1e6, kind: "kick", team: 0, text: "x" } as const;
    expect(joinMarks([again, { ...again, time: 0 }])).toHaveLength(1);
  });

  test("a script error is marked", () => {
    const broken = { command: { ...output.command, fallback: 2 } };
    expect(outputMarks(broken, 0, 1, 3, { motion: 0, fallback: "", fallen: 0 })[0]!.text).toBe(
      "blue 3: The behaviours stopped with an error.",
    );
  });

  test("who is near the ball has it", () => {
    const robot = (team: number, x: number) => ({ team, pose: { position: { x, y: 0 } } });
    expect(possessionOf({ ball: { x: 0, y: 0 }, robots: [robot(0, 90), robot(1, 12)] })).toBe(1);
    expect(possessionOf({ ball: { x: 0, y: 0 }, robots: [robot(0, 90)] })).toBe(-1);
  });

  test("goals belong to a team, other calls to nobody", () => {
    expect(eventMark({ kind: 1, team: 1 }, 5)).toMatchObject({ kind: "goal", team: 1 });
    expect(eventMark({ kind: 6, team: 1 }, 5)).toMatchObject({ kind: "referee", team: -1 });
  });
});

test("the address keeps what is shown, and nonsense in it counts as absent", () => {
  const kept = { time: 12.5, robot: "red-2", view: "eye", layers: ["robots"], tab: "Plots" };
  expect(readHash(writeHash(kept))).toEqual(kept);
  expect(readHash("#t=x&robot=")).toEqual({});
  expect(comparedOf("?compare=0,1")).toEqual([0, 1]);
  expect(comparedOf("?compare=a")).toBeUndefined();
});

test("a step goes to the next mark within a second, or a second on", () => {
  const mark = { time: 400e3, kind: "kick", team: 0, text: "" } as const;
  expect(stepTime(0, true, [mark])).toBe(400e3);
  expect(stepTime(400e3, true, [mark])).toBe(1.4e6);
  expect(stepTime(1e6, false, [mark])).toBe(400e3);
});

test("the time axis zooms about a time and stays within the match", () => {
  const axis = new TimeAxis(0, 100e6);
  axis.zoom(0.5, 50e6);
  expect([axis.from, axis.to]).toEqual([25e6, 75e6]);
  axis.move(-1e9);
  expect(axis.from).toBe(0);
});

test("numbers of a type are found by words of their path", () => {
  const type = typeOf(
    "kelpie/Ball ball\nfloat64[2] pair\nstring word\n" +
      "=".repeat(80) +
      "\nMSG: kelpie/Ball\nfloat64 distance\n",
  );
  expect(numberPaths(type)).toEqual(["ball.distance", "pair.0", "pair.1"]);
  expect(found(numberPaths(type), "dist BALL", 9)).toEqual(["ball.distance"]);
});

test("a series asks for its own member alone", () => {
  expect(wantedOf("world.modes.0.weight")).toEqual({ world: { modes: { weight: true } } });
  expect(valueOf({ a: [{ b: true }] }, "a.0.b")).toBe(1);
  expect(valueOf({ a: [] }, "a.0.b")).toBeNaN();
});

test("topics of a live match are taken apart", () => {
  expect(partsOf("/live/red-1/frame/output")).toEqual(["red-1", "/frame/output"]);
  expect(partsOf("/other")).toBeUndefined();
  expect(wantedTopic("/live/red-1/motion/input")).toBe(false);
});

test("packed classes become colours, long runs, too", () => {
  const pixels = new Uint8ClampedArray(4 * 208 * 160);
  fromClasses(Uint8Array.from([0x70, 0x1f, 255]), pixels);
  expect([...pixels.slice(0, 3)]).toEqual([0, 150, 40]);
  expect([...pixels.slice(4 * 271, 4 * 271 + 3)]).toEqual([255, 128, 0]);
  expect(pixels[4 * 272 + 3]).toBe(0);
});

test("outputs differ where a byte does", () => {
  expect(sameBytes(Uint8Array.of(1, 2), Uint8Array.of(1, 2))).toBe(true);
  expect(sameBytes(Uint8Array.of(1, 2), Uint8Array.of(1, 3))).toBe(false);
});

test("what a log of another version lacks is said in a sentence", () => {
  const type = typeOf(
    "kelpie/World world\n" + "=".repeat(80) + "\nMSG: kelpie/World\nfloat64 pose\n",
  );
  const file = {
    channels: new Map([["/frame/output", {}]]),
    typeOf: () => type,
    stream: () => undefined,
    from: 0,
    to: 1,
  } as unknown as LogFile;
  const config = { team: 0, player: 1, field: undefined } as const;
  const { notes, robots } = matchOf([{ name: "old.mcap", place: 0, file, config }]);
  expect(robots).toHaveLength(1);
  expect(notes.join(" ")).toMatch(/old\.mcap is of another version and lacks the ball/);
  expect(notes.join(" ")).toMatch(/holds no inputs/);
});

test("a moment between two messages is between their places", () => {
  const message = (time: number, x: number) => ({
    time,
    bytes: new Uint8Array(),
    value: {
      robots: [{ team: 1, player: 2, pose: { position: { x, y: 5 }, heading: 0 } }],
      ball: { x: 2 * x, y: 0 },
      redScore: 1,
      blueScore: 0,
    },
  });
  const truth = {
    topic: "/truth",
    type: typeOf(""),
    from: 0,
    to: 1e5,
    around: () => ({ before: message(0, 10), after: message(1e5, 20) }),
    load: () => Promise.resolve(),
  } as unknown as Stream;
  const match: Match = {
    robots: [],
    truth,
    event: undefined,
    truthLog: 0,
    field: undefined,
    from: 0,
    to: 1e5,
    notes: [],
  };
  const moment = momentAt(match, 5e4);
  expect(moment.robots[0]).toMatchObject({ key: "blue-2", truth: { x: 15, y: 5 } });
  expect(moment.ball).toEqual({ x: 30, y: 0 });
  expect(moment.score).toEqual([1, 0]);
});
