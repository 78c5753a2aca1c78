// SPDX-License-Identifier: Apache-2.0
// A match that is played while the page shows it: it is followed, stopped, changed, and it ends.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { browser, eventually, folder, playing, report, until } from "./browser.mjs";

const running = (now) => now.counts.robots === 2 && now.time > 1;

// Whether time comes to a stand within ten seconds: what was under way arrives yet.
async function stands(view) {
  let before = -1;
  for (let i = 0; i < 10; ++i) {
    const { time } = await report(view);
    if (Math.abs(time - before) < 0.02) return true;
    before = time;
    await view.waitForTimeout(1000);
  }
  return false;
}

test("a live match is followed, and stands while it is paused", async (t) => {
  const { address } = await playing(t, ["--out", join(folder, "live1")]);
  const { view, errors } = await browser(t);
  await view.goto(address);
  const { time } = await until(view, running);
  await until(view, (now) => now.time > time);
  await view.getByRole("button", { name: "Pause or resume the match" }).click();
  await view.locator("text=Resume match").waitFor();
  assert.ok(await stands(view));
  assert.deepEqual(errors, []);
});

test("the ball is put where it is typed, and a refusal is said", async (t) => {
  const { address } = await playing(t, ["--out", join(folder, "live2")]);
  const { view } = await browser(t);
  await view.goto(address);
  await until(view, running);
  const put = async (x, y) => {
    await view.getByLabel("x, cm across the field").fill(String(x));
    await view.getByLabel("y, cm along the field").fill(String(y));
    await view.getByRole("button", { name: "put", exact: true }).click();
  };
  await put(120, 200);
  await view.waitForTimeout(1000);
  assert.equal(await view.textContent(".live .said"), "");
  await put(99999, 0);
  await view.locator(".live .said:not(:empty)").waitFor();
});

test("who goes back is not pulled to the end, and End follows again", async (t) => {
  const { address } = await playing(t, ["--out", join(folder, "live3")]);
  const { view } = await browser(t);
  await view.goto(address);
  await until(view, (now) => running(now) && now.time > 3);
  await view.keyboard.press("[");
  const { time } = await report(view);
  await view.waitForTimeout(1000);
  assert.equal((await report(view)).time, time);
  await view.keyboard.press("End");
  await until(view, (now) => now.time > time + 1);
});

test("the behaviours are listed and shown", async (t) => {
  const { address } = await playing(t, ["--out", join(folder, "live4")]);
  const { view, errors } = await browser(t);
  await view.goto(address);
  await until(view, running);
  await view.getByRole("tab", { name: "Behaviours" }).click();
  await view.getByLabel("Behaviour file").selectOption({ label: "red: main.py" });
  await eventually(view, () => view.getByLabel("Text of the behaviour").inputValue(), /decide/);
  assert.deepEqual(errors, []);
});

test("the end of the match is said in a line", async (t) => {
  const { address, end } = await playing(t, ["--out", join(folder, "live5")]);
  const { view } = await browser(t);
  await view.goto(address);
  await until(view, running);
  end();
  await until(view, (now) => now.notes.some((note) => /match is over|Connection lost/.test(note)));
  assert.ok((await report(view)).counts.robots === 2);
});
