// SPDX-License-Identifier: Apache-2.0
// node open.mjs FILE PICTURE: opens a file for viewers in Rerun's own page (npm's, in a headless
// Chromium that draws in software), waits until all of it is there, clicks on image and log, writes a PNG of the page, and prints as JSON what the page then knows. Nothing of ours is in the
// page but the line that starts it.
import { createReadStream, existsSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { basename, extname } from "node:path";
import { chromium } from "playwright-core";

const [, , file, picture] = process.argv;
const kPackage = new URL("node_modules/@rerun-io/web-viewer/", import.meta.url).pathname;
const kTypes = { ".js": "text/javascript", ".wasm": "application/wasm" };
const kPage = `<!doctype html><meta charset="utf-8"><link rel="icon" href="data:,">
<style>html, body, #viewer { margin: 0; height: 100% }</style><div id="viewer"></div>
<script type="module">
  import { WebViewer } from "/index.js";
  const viewer = new WebViewer();
  window.events = [];
  for (const name of ["recording_open", "selection_change"])
    viewer.on(name, (event) => window.events.push(event));
  window.span = () => {
    const recording = viewer.get_active_recording_id();
    const line = recording && viewer.get_active_timeline(recording);
    const range = line && viewer.get_time_range(recording, line);
    return range ? (range.max - range.min) / 1e9 : 0;
  };
  await viewer.start(location.origin + "/viewer.mcap", document.getElementById("viewer"),
    { render_backend: "webgl", hide_welcome_screen: true, width: "100%", height: "100%" });
</script>`;

// Rerun's page imports its modules without their ending.
function answer(request, response) {
  const name = basename(request.url.split("?")[0]);
  if (name === "") {
    response.setHeader("content-type", "text/html");
    response.end(kPage);
    return;
  }
  const path = name === "viewer.mcap" ? file : kPackage + name + (extname(name) ? "" : ".js");
  if (!existsSync(path)) {
    response.writeHead(404).end();
    return;
  }
  response.setHeader("content-type", kTypes[extname(path)] ?? "application/octet-stream");
  response.setHeader("content-length", statSync(path).size);
  createReadStream(path).pipe(response);
}

const kChromium = ["--headless", "--no-sandbox", "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", "--disable-background-networking",
  "--disable-component-update", "--disable-sync", "--no-first-run", "--disable-quic"];

// Where Rerun's own layout may have put the camera's image, and the rows of the log.
const kImage = [[785, 200], [785, 120], [400, 200], [900, 300], [400, 450]];
const kRows = [[763, 390], [763, 410], [763, 430], [763, 470], [763, 510]];

// The span grows while the file is taken in; it is whole when it has stood still for a while.
async function untilWhole(page) {
  let span = 0;
  for (let same = 0; same < 6; ) {
    await page.waitForTimeout(1500);
    const now = await page.evaluate(() => window.span());
    same = now > 0 && now === span ? same + 1 : 0;
    span = now;
  }
  return span;
}

// Clicks until an entity of that name is selected. The page draws in software: a click may take
// effect seconds later.
async function select(page, name, places) {
  const chosen = () => page.evaluate((wanted) => window.events.flatMap((e) => e.items ?? [])
    .find((item) => new RegExp(wanted).test(item.entity_path ?? "")), name);
  for (const place of places) {
    await page.mouse.click(...place);
    for (let i = 0; i < 16; ++i) {
      await page.waitForTimeout(500);
      const item = await chosen();
      if (item) return item;
    }
  }
  return null;
}

async function look(url) {
  const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: kChromium });
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  const errors = [];
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  page.on("pageerror", (error) => errors.push(String(error)));
  await page.goto(url);
  await page.waitForFunction(() => window.events?.some((e) => e.type === "recording_open"), null,
    { timeout: 120000 });
  const span = await untilWhole(page);
  const camera = await select(page, "/camera$", kImage);
  const row = await select(page, "/log$|/referee$", kRows);
  await page.screenshot({ path: picture });
  const events = await page.evaluate(() => window.events);
  await browser.close();
  const opened = events.find((event) => event.type === "recording_open");
  return { source: opened.source, span_s: span, errors, camera, row };
}

const server = createServer(answer).listen(0, "127.0.0.1", async () => {
  console.log(JSON.stringify(await look(`http://127.0.0.1:${server.address().port}/`)));
  server.close();
});
