// SPDX-License-Identifier: Apache-2.0
// Which numbers there are to plot, and where they are read: of logs by the worker, of a live match
// from what is in memory.
import { numberPaths } from "../model/schemaTree";
import type { RobotStreams } from "../model/match";
import { Decoder } from "../reading/decoder";
import { RingStream } from "../reading/ringStream";
import type { Stream } from "../reading/stream";
import { Plots, type Plottable, type ReadSeries } from "../panels/plots";
import { valueOf, wantedOf } from "../worker/series";
import type { Background } from "./background";
import type { Studio } from "./studio";

const WORLD = "world";

function streamsOf(robot: RobotStreams): Stream[] {
  return [...(robot.output ? [robot.output] : []), ...robot.inputs];
}

function sourcesOf(studio: Studio): Map<string, string[]> {
  const paths = (streams: readonly Stream[]) =>
    streams.flatMap((stream) => numberPaths(stream.type).map((path) => `${stream.topic} ${path}`));
  const sources = new Map(studio.match.robots.map((robot) => [robot.key, paths(streamsOf(robot))]));
  const world = [studio.match.truth].filter((s) => s !== undefined);
  if (world.length > 0) sources.set(WORLD, paths(world));
  return sources;
}

function addTab(studio: Studio, read: ReadSeries): Plots {
  const plots = new Plots(() => sourcesOf(studio), read, studio.cursor, studio.axis);
  studio.tabs.add("Plots", plots.element, () => plots.themeChanged());
  studio.tabs.choose("Decisions");
  return plots;
}

export function addPlots(studio: Studio, background: Background): Plots {
  return addTab(studio, ({ source, topic, path }, take) => {
    const log =
      source === WORLD
        ? studio.match.truthLog
        : studio.match.robots.find((r) => r.key === source)?.log;
    if (log !== undefined && log >= 0) background.askSeries(log, topic, path, take);
  });
}

function streamOf(studio: Studio, { source, topic }: Plottable): Stream | undefined {
  if (source === WORLD) return studio.match.truth;
  const robot = studio.match.robots.find((r) => r.key === source);
  return robot && streamsOf(robot).find((stream) => stream.topic === topic);
}

export function addLivePlots(studio: Studio): Plots {
  return addTab(studio, (what, take) => {
    const stream = streamOf(studio, what);
    if (!(stream instanceof RingStream)) return;
    const decoder = new Decoder(stream.type, wantedOf(what.path));
    const messages = stream.all;
    take(
      Float64Array.from(messages, (m) => m.time),
      Float64Array.from(messages, (m) => valueOf(decoder.decode(m.bytes), what.path)),
      true,
    );
  });
}
