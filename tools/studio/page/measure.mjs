// SPDX-License-Identifier: Apache-2.0
// node measure.mjs URL SEED: opens the studio's page in a headless Chromium that draws in software,
// at 1280 x 720, seeks a dozen times, plays for a while, and prints as JSON how long that took. It
// reads the page's own report (src/app/report.ts).
import { chromium } from "playwright-core";

const [, , url, seed] = process.argv;
const kChromium = [
  "--headless",
  "--no-sandbox",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--ignore-gpu-blocklist",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--no-first-run",
  "--disable-quic",
];
const kSeeks = 12;
const kPlayed = 8; // s

// Numbers from 0 to 1, the same for the same seed (a linear congruential generator).
function* random(state) {
  for (;;) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    yield state / 4294967296;
  }
}

const percentile = (values, share) =>
  [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(share * values.length))];

async function seeks(page, length) {
  const taken = [];
  const draw = random(Number(seed));
  for (let i = 0; i < kSeeks; ++i) {
    const time = draw.next().value * length;
    taken.push(await page.evaluate((t) => window.__kelpie.seek(t), time));
  }
  return taken;
}

async function rates(page) {
  await page.evaluate(() => window.__kelpie.seek(5));
  await page.keyboard.press("Space");
  const found = [];
  for (let i = 0; i < kPlayed; ++i) {
    await page.waitForTimeout(1000);
    found.push(await page.evaluate(() => window.__kelpie.fps));
  }
  return found.slice(2);
}

// The page's policy lets nobody make code from text, as waiting for an expression would.
async function opened(page) {
  for (let i = 0; i < 1200; ++i) {
    const open = await page.evaluate(() => window.__kelpie?.openMs ?? 0);
    if (open > 0) return open;
    await page.waitForTimeout(100);
  }
  throw new Error("the page shows no robots within two minutes");
}

const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: kChromium });
const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
await page.goto(url);
const open = await opened(page);
const shown = await page.evaluate(() => ({
  robots: window.__kelpie.counts.robots,
  length: window.__kelpie.length,
}));
const taken = await seeks(page, shown.length);
const fps = await rates(page);
await browser.close();
console.log(
  JSON.stringify({
    open_s: open / 1000,
    robots: shown.robots,
    seek_ms: percentile(taken, 0.5),
    seek_worst_ms: Math.max(...taken),
    frames_per_s: percentile(fps, 0.5),
  }),
);
