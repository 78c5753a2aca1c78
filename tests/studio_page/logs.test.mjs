// SPDX-License-Identifier: Apache-2.0
// Recorded logs in the page: what is shown of them, and how a person moves in them.
import assert from "node:assert/strict";
import { test } from "node:test";
import { eventually, matchLogs, open, report, until } from "./browser.mjs";

const whole = (now) => now.openMs > 0 && now.counts.robots === 4;
const frame = 1 / 30;

// The decisions of the whole match are read and drawn.
async function allRead(view) {
  await until(view, (now) => now.counts.segments > 8);
  await view.locator(".progress:empty").waitFor({ state: "attached" });
  await view.waitForTimeout(1000);
}

test("a match opens with its field, robots and decisions, without an error", async (t) => {
  const { view, errors } = await open(t, await matchLogs(), { hash: "#t=8" });
  const first = await until(view, whole);
  assert.ok(first.counts.lines >= 7);
  const later = await until(view, (now) => now.counts.segments > 8 && now.counts.marks > 0);
  assert.equal(later.counts.lanes, 4);
  assert.match(await view.textContent("#title .state"), /first half/);
  assert.deepEqual(errors, []);
});

test("a step is a frame, and the keys for the ends go there", async (t) => {
  const { view, errors } = await open(t, await matchLogs(), { hash: "#t=5" });
  await until(view, whole);
  await view.keyboard.press("ArrowRight");
  const { time } = await report(view);
  assert.ok(Math.abs(time - 5 - frame) < 0.001);
  await view.keyboard.press("Home");
  assert.ok((await report(view)).time < 1);
  await view.keyboard.press("End");
  assert.ok((await report(view)).time > 8);
  assert.deepEqual(errors, []);
});

test("time runs between two presses of the space bar", async (t) => {
  const { view } = await open(t, await matchLogs(), { hash: "#t=4" });
  await until(view, whole);
  await view.keyboard.press(" ");
  await until(view, (now) => now.time > 4.5);
  await view.keyboard.press(" ");
  const { time } = await report(view);
  await view.waitForTimeout(400);
  assert.equal((await report(view)).time, time);
});

test("the time line is scrubbed by pointer and told to who does not see it", async (t) => {
  const { view } = await open(t, await matchLogs());
  await until(view, whole);
  const line = view.getByRole("slider", { name: "Time of the match" });
  const box = await line.boundingBox();
  await view.mouse.click(box.x + 0.6 * box.width, box.y + 10);
  const { time } = await until(view, (now) => now.time > 1);
  const told = Number(await line.getAttribute("aria-valuenow"));
  assert.ok(Math.abs(told - time) < 0.5);
});

test("pointing at a decision tells its reason, a click goes there", async (t) => {
  const { view } = await open(t, await matchLogs(), { hash: "#t=8" });
  await until(view, whole);
  await allRead(view);
  const lanes = await view.locator(".lanes canvas").boundingBox();
  const pointed = async () => {
    await view.mouse.move(lanes.x + 0.8 * lanes.width, lanes.y + 44);
    return view.textContent("#reason");
  };
  await eventually(view, pointed, /The (skill|player|decision|role) .* chose /);
  await view.mouse.click(lanes.x + 0.8 * lanes.width, lanes.y + 44);
  const { time } = await report(view);
  assert.notEqual(time, 8);
});

test("every view is reached by its key, and the address keeps it", async (t) => {
  const { view, errors } = await open(t, await matchLogs(), { hash: "#t=6" });
  await until(view, whole);
  for (const name of ["orbit", "follow", "eye", "above", "broadcast"]) {
    await view.keyboard.press("v");
    await view.waitForURL(new RegExp(`view=${name}`));
  }
  assert.deepEqual(errors, []);
});

test("layers are drawn when they are asked for", async (t) => {
  const { view } = await open(t, await matchLogs(), { hash: "#t=8&layers=robots" });
  const { counts } = await until(view, whole);
  await view.keyboard.press("l");
  for (const name of ["ghosts", "hypotheses", "opponents", "obstacles"])
    await view.locator(`.layers input[name=${name}]`).check();
  const now = await until(view, (r) => r.counts.ghosts === 4);
  assert.ok(now.counts.beliefs > counts.beliefs);
});

test("a robot is chosen by its number, and the camera shows what it saw", async (t) => {
  const { view } = await open(t, await matchLogs(), { hash: "#t=8" });
  await until(view, whole);
  await view.keyboard.press("3");
  await view.locator(".caption", { hasText: "blue 1" }).waitFor();
  assert.equal(await view.getByRole("radio", { name: "blue 1" }).getAttribute("aria-checked"),
    "true");
});

test("any number can be plotted", async (t) => {
  const { view, errors } = await open(t, await matchLogs(), { hash: "#t=8&tab=Plots" });
  await until(view, whole);
  await view.getByRole("tab", { name: "Plots" }).click();
  await view.getByRole("searchbox").fill("world ball distance");
  await view.locator(".found").getByRole("option").first().click();
  await view.locator(".chart canvas").waitFor();
  assert.match(await view.textContent(".chosen"), /world\.ball\.distance/);
  assert.deepEqual(errors, []);
});

test("the page is used by keyboard alone", async (t) => {
  const { view } = await open(t, await matchLogs(), { hash: "#t=8" });
  await until(view, whole);
  const names = new Set();
  for (let i = 0; i < 60; ++i) {
    await view.keyboard.press("Tab");
    names.add(await view.evaluate(() => {
      const at = document.activeElement;
      const label = at?.getAttribute("aria-label") ?? at?.labels?.[0]?.textContent;
      return label ?? at?.textContent ?? "";
    }));
  }
  assert.ok(!names.has(""), "something that takes the focus has no name");
  for (const name of ["Time of the match", "Play (space)", "Follow", "Layers", "red 1"])
    assert.ok(names.has(name), `${name} is not reached`);
});

test("the help is a dialogue that a key opens and closes", async (t) => {
  const { view } = await open(t, await matchLogs());
  await until(view, whole);
  await view.keyboard.press("?");
  assert.ok(await view.getByRole("dialog").isVisible());
  await view.keyboard.press("Escape");
  assert.ok(!(await view.getByRole("dialog", { includeHidden: true }).isVisible()));
});

test("light and dark follow the system until somebody chooses", async (t) => {
  const { view } = await open(t, await matchLogs(), { dark: true });
  await until(view, whole);
  const theme = () => view.evaluate(() => document.documentElement.dataset.theme);
  assert.equal(await theme(), "dark");
  await view.keyboard.press("t");
  assert.equal(await theme(), "light");
});

test("nothing is wider than the screen in its smallest size", async (t) => {
  const { view } = await open(t, await matchLogs(), { width: 1024, height: 640 });
  await until(view, whole);
  const [wide, high] = await view.evaluate(() => [document.documentElement.scrollWidth,
    document.documentElement.scrollHeight]);
  assert.deepEqual([wide <= 1024, high <= 640], [true, true]);
});
