// SPDX-License-Identifier: Apache-2.0
// How the page is built: plain files, so that a strict content security policy holds, and the names
// that C++ gives to its numbers taken from the sources.
import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";
import { cppNames } from "./plugin/cppNames";

const here = fileURLToPath(new URL(".", import.meta.url));
const root = fileURLToPath(new URL("../../../", import.meta.url));

export default defineConfig({
  base: "./",
  plugins: [cppNames(root)],
  worker: { format: "es", plugins: () => [cppNames(root)] },
  build: {
    outDir: process.env["KELPIE_PAGE_OUT"] ?? `${root}build/studio/page`,
    emptyOutDir: true,
    target: "es2022",
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 1500,
  },
  root: here,
  test: { include: ["tests/**/*.test.ts"], environment: "node" },
});
