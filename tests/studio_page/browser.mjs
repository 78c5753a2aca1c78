// SPDX-License-Identifier: Apache-2.0
// What the page's tests share: a match that is played once, the studio's server, and a browser in
// which every error of the page's console counts. KELPIE is the program, KELPIE_MATCH a folder with
// logs of a match where there is one already.
import { execFile, spawn } from "node:child_process";
import { mkdtempSync, readdirSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after } from "node:test";
import { promisify } from "node:util";

const page = new URL("../../tools/studio/page/package.json", import.meta.url);
const { chromium } = createRequire(page)("playwright-core");
const kelpie = process.env.KELPIE ?? "kelpie";
const [program, ...words] = kelpie.split(" ");

export const folder = mkdtempSync(join(tmpdir(), "kelpie-page-"));
process.on("exit", () => rmSync(folder, { recursive: true, force: true }));

let match;
// The logs of a short match of two robots each side.
export async function matchLogs() {
  match ??= process.env.KELPIE_MATCH ?? await playMatch();
  return readdirSync(match).filter((name) => name.endsWith(".mcap")).map((n) => join(match, n));
}

async function playMatch() {
  const out = join(folder, "match");
  await promisify(execFile)(program, [...words, "play", "--robots", "2v2", "--seconds", "12",
    "--fast", "--seed", "3", "--logs", "all", "--no-film", "--out", out]);
  return out;
}

// Starts the program, and answers when it has told its address.
export function started(test, args) {
  const server = spawn(program, [...words, ...args]);
  test.after(() => server.kill());
  let said = "";
  return new Promise((found, failed) => {
    const take = (bytes) => {
      said += bytes;
      const address = /(?:http|ws):\/\/[\d.:]+/.exec(said);
      if (address) found({ address: `${address[0]}/`, end: (signal) => server.kill(signal) });
    };
    server.stdout.on("data", take);
    server.stderr.on("data", take);
    server.on("exit", (code) => failed(new Error(`the studio ended with ${code}: ${said}`)));
  });
}

// The address of a studio that is stopped after the test.
export async function studio(test, sources) {
  return (await started(test, ["studio", "--port", "0", ...sources])).address;
}

// A match of one robot each side that is being played until the test ends. Its processes end with
// it.
export function playing(test, args) {
  return started(test, ["play", "--studio", "--port", "0", "--robots", "1v1", "--fast", "--seed",
    "3", ...args]);
}

const QUIET = ["--no-sandbox", "--use-angle=swiftshader", "--use-gl=angle",
  "--enable-unsafe-swiftshader", "--disable-background-networking", "--disable-component-update",
  "--disable-sync", "--no-first-run", "--disable-quic"];

// One browser serves all tests of a file; each has a window of its own.
let shared;
after(() => shared?.close());

// A page of the size that it is made for, and the errors that it has had.
export async function browser(test, { width = 1280, height = 720, dark = false } = {}) {
  shared ??= await chromium.launch({ executablePath: "/usr/bin/chromium", args: QUIET });
  const view = await shared.newPage({ viewport: { width, height },
    colorScheme: dark ? "dark" : "light" });
  test.after(() => view.context().close());
  const errors = [];
  view.on("console", (said) => said.type() === "error" && errors.push(said.text()));
  view.on("pageerror", (error) => errors.push(error.message));
  return { view, errors };
}

export const report = (view) => view.evaluate(() => {
  const now = window.__kelpie;
  return now && { openMs: now.openMs, time: now.time, counts: now.counts, places: now.places,
    notes: [...now.notes] };
});

// The report, or nothing while the page loads itself anew, as it does when another match begins.
async function reportUnlessLoading(view) {
  try {
    return await report(view);
  } catch (error) {
    if (/context was destroyed/.test(error.message)) return undefined;
    throw error;
  }
}

// Until the report is as wanted; fails with the last one after half a minute.
export async function until(view, wanted) {
  let last;
  for (let i = 0; i < 300; ++i) {
    last = await reportUnlessLoading(view);
    if (last && wanted(last)) return last;
    await view.waitForTimeout(100);
  }
  throw new Error(`the page does not come to that: ${JSON.stringify(last)}`);
}

// What `ask` answers once it fits; fails with its last answer after half a minute.
export async function eventually(view, ask, wanted) {
  let answer;
  for (let i = 0; i < 150; ++i) {
    answer = await ask();
    if (wanted.test(answer)) return;
    await view.waitForTimeout(200);
  }
  throw new Error(`not ${wanted}: ${answer}`);
}

export async function open(test, sources, { hash = "", search = "", ...size } = {}) {
  const address = await studio(test, sources);
  const { view, errors } = await browser(test, size);
  await view.goto(`${address}${search}${hash}`);
  return { view, errors, address };
}
