// SPDX-License-Identifier: Apache-2.0
// Logs that lack something, and parts that the server does not have: the page shows what there is
// and says the rest in a line.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { browser, folder, matchLogs, open, report, studio, until } from "./browser.mjs";

const oneLog = async () => (await matchLogs()).filter((name) => name.endsWith("match.mcap"));

test("the log of one robot shows all robots by its truth", async (t) => {
  const { view, errors } = await open(t, await oneLog(), { hash: "#t=6" });
  const now = await until(view, (r) => r.counts.robots === 4);
  assert.equal(now.counts.lanes, 1);
  assert.deepEqual(errors, []);
});

test("a log that is cut off is shown as far as it goes, and a note says so", async (t) => {
  const bytes = readFileSync((await oneLog())[0]);
  const cut = join(folder, "cut.mcap");
  writeFileSync(cut, bytes.subarray(0, Math.floor(0.7 * bytes.length)));
  const { view, errors } = await open(t, [cut]);
  const now = await until(view, (r) => r.counts.robots > 0);
  assert.match(now.notes.join(" "), /cut\.mcap/);
  assert.deepEqual(errors, []);
});

test("a note is dismissed", async (t) => {
  const bytes = readFileSync((await oneLog())[0]);
  const cut = join(folder, "cut2.mcap");
  writeFileSync(cut, bytes.subarray(0, Math.floor(0.8 * bytes.length)));
  const { view } = await open(t, [cut]);
  await until(view, (r) => r.counts.robots > 0);
  const notes = await view.locator(".note").count();
  await view.getByRole("button", { name: /^Dismiss/ }).first().click();
  assert.equal(await view.locator(".note").count(), notes - 1);
});

test("what the server does not have is answered with 404 and no page", async (t) => {
  const address = await studio(t, await oneLog());
  for (const path of ["assets/none.js", "logs/99", "api/none", "../etc/passwd"])
    assert.equal((await fetch(address + path)).status, 404, path);
});

test("two equal logs have no frame that differs", async (t) => {
  const [log] = await oneLog();
  const { view, errors } = await open(t, [log, log], { search: "?compare=0,1", hash: "#t=6" });
  const now = await until(view, (r) => r.notes.some((note) => note.includes("frames")));
  assert.equal(now.counts.differences, 0);
  assert.match(now.notes.join(" "), /All \d+ frames that both logs have are the same/);
  assert.equal(await view.locator(".second canvas").count(), 1);
  assert.deepEqual(errors, []);
});

test("logs that are not there to compare are said, and the match is shown", async (t) => {
  const { view } = await open(t, await oneLog(), { search: "?compare=0,7" });
  const now = await until(view, (r) => r.counts.robots > 0);
  assert.match(now.notes.join(" "), /no two logs/);
});

test("a page whose logs cannot be fetched says so and is not blank", async (t) => {
  const address = await studio(t, await oneLog());
  const { view } = await browser(t);
  await view.route("**/logs/**", (route) => route.abort());
  await view.goto(address);
  await view.locator(".note.error").first().waitFor();
  assert.match(await view.textContent("#notes"), /cannot be read/);
  assert.equal(await report(view), undefined);
});
