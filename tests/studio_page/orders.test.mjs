// SPDX-License-Identifier: Apache-2.0
// What a person does to a match from the page, and what becomes of it on the field.
import assert from "node:assert/strict";
import { cpSync, mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { browser, folder, playing, report, started, until } from "./browser.mjs";

const pycode = new URL("../../pycode", import.meta.url).pathname;
const running = (now) => now.counts.robots === 2 && now.time > 1;
const away = (a, b) => Math.hypot(a.x - b.x, a.y - b.y);

async function live(t, name, words = []) {
  const { address } = await playing(t, ["--out", join(folder, name), ...words]);
  const { view, errors } = await browser(t);
  await view.goto(address);
  await until(view, running);
  return { view, errors };
}

// The time at which it stands, once what was under way has arrived.
async function settled(view) {
  let before = -1;
  for (let same = 0; same < 3; ) {
    const { time } = await report(view);
    same = time === before ? same + 1 : 0;
    before = time;
    await view.waitForTimeout(1500);
  }
  return before;
}

async function pause(view) {
  await view.getByRole("button", { name: "Pause or resume the match" }).click();
  await view.locator("text=Resume match").waitFor();
  return settled(view);
}

test("a step is one frame of the match", async (t) => {
  const { view } = await live(t, "step");
  const paused = await pause(view);
  const step = async (time) => {
    const came = (now) => now.time > time + 0.01;
    const button = view.getByRole("button", { name: "One frame of the match" });
    await button.click();
    await view.waitForTimeout(3000);
    if (!came(await report(view))) await button.click();   // slowly drawn, a page may miss one
    await until(view, came);
    return settled(view);
  };
  const once = await step(paused);   // on a slow machine a last frame arrives with it
  const twice = await step(once);
  assert.ok(twice - once < 0.05, `${twice - once} s`);
});

test("the ball that is dragged lies where it was let go, and the robot goes for it", async (t) => {
  const { view, errors } = await live(t, "drag");
  await view.getByRole("button", { name: "Above" }).click();
  await until(view, (now) => now.places.ball && now.time > 8);
  await pause(view);
  const { places } = await report(view);
  const goal = { x: 180, y: places.ball.y > 270 ? 150 : 390 };
  const at = (place) => view.evaluate((p) => window.__kelpie.screenOf(p), place);
  const [from, to] = [await at(places.ball), await at(goal)];
  await view.mouse.move(from.x, from.y);
  await view.mouse.down();
  await view.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2, { steps: 4 });
  await view.mouse.move(to.x, to.y, { steps: 4 });
  await view.mouse.up();
  await view.getByRole("button", { name: "Pause or resume the match" }).click();
  const put = await until(view, (now) => now.places.ball && away(now.places.ball, goal) < 25);
  const nearest = (now) => Math.min(...["red-1", "blue-1"].map((key) =>
    away(now.places[key], now.places.ball)));
  const far = nearest(put);
  await until(view, (now) => now.places.ball && nearest(now) < Math.min(0.6 * far, 60));
  assert.deepEqual(errors, []);
});

test("a robot is carried to what is typed", async (t) => {
  const { view } = await live(t, "carry");
  await view.getByLabel("What is put").selectOption("blue-1");
  await view.getByLabel("x, cm across the field").fill("60");
  await view.getByLabel("y, cm along the field").fill("300");
  await view.getByLabel("heading, degrees").fill("-90");
  await view.getByRole("button", { name: "put", exact: true }).click();
  await until(view, (now) => away(now.places["blue-1"], { x: 60, y: 300 }) < 30);
});

test("a faster match is a faster match", async (t) => {
  const { view } = await live(t, "speed");
  await view.getByLabel("Speed of the match").selectOption("0.5");
  await view.waitForTimeout(1500);
  const slow = await report(view);
  await view.waitForTimeout(2000);
  const slowly = (await report(view)).time - slow.time;
  await view.getByLabel("Speed of the match").selectOption("0");
  await view.waitForTimeout(1500);
  const fast = await report(view);
  await view.waitForTimeout(2000);
  assert.ok((await report(view)).time - fast.time > 1.2 * slowly);
});

test("a behaviour that is saved plays at once, and the page says the line", async (t) => {
  const copy = join(folder, "pycode");
  cpSync(pycode, copy, { recursive: true });
  const { view } = await live(t, "edit", ["--red", copy]);
  await view.getByRole("tab", { name: "Behaviours" }).click();
  await view.getByLabel("Behaviour file").selectOption({ label: "red: main.py" });
  const editor = view.getByLabel("Text of the behaviour");
  await until(view, running);
  await view.waitForTimeout(1000);
  await editor.fill(`${await editor.inputValue()}\n# saved by the page\n`);
  await view.getByRole("button", { name: /save/i }).click();
  await view.locator("text=/main\\.py: loaded again/").first().waitFor({ timeout: 60000 });
  assert.match(readFileSync(join(copy, "main.py"), "utf8"), /saved by the page/);
});

test("a match that is killed and begun again is followed again by the same page", async (t) => {
  const out = join(folder, "again");
  mkdirSync(out);
  const words = ["play", "--robots", "1v1", "--fast", "--real-time", "--no-film", "--live", "--port",
    "0", "--seed", "3", "--out", out];
  const { address } = await started(t, ["studio", "--port", "0", out]);
  const { view } = await browser(t);
  await view.goto(address);
  const first = await started(t, words);
  await until(view, running);
  first.end("SIGKILL");
  const { time } = await until(view, (now) => now.notes.some((note) => /over/.test(note)));
  await started(t, words);
  await until(view, (now) => now.counts.robots === 2 && now.time !== time && now.time < 20 &&
    now.time > 1);
});
