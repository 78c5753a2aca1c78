// SPDX-License-Identifier: Apache-2.0
// Two logs of the same frames side by side: a second field, a second lane, and on the time line the
// frames whose outputs differ.
import { FieldView } from "../drawing/fieldView";
import type { Body } from "../model/body";
import { matchOf, robotKey, type LogConfig, type Match, type OpenLog } from "../model/match";
import { loadMoment, momentAt } from "../model/moment";
import { clockOf } from "../model/words";
import type { LaneRobot } from "../panels/lanes";
import type { Background } from "./background";
import { byId, make } from "./dom";
import type { Studio } from "./studio";

export function addSecond(studio: Studio, log: OpenLog, body: Body): void {
  const match = matchOf([log]);
  const first = studio.field;
  if (!first || !match.field) return;
  const box = make("div", { class: "second" });
  const canvas = make("canvas", {
    class: "scene",
    role: "img",
    "aria-label": `Field of ${log.name}`,
  });
  const over = make("div", { class: "over" });
  box.append(canvas, over, make("span", { class: "which-log" }, log.name));
  byId("field").classList.add("split");
  byId("field").after(box);
  byId("main").classList.add("comparing");
  const view = new FieldView(canvas, over, match.field, body, (key) => studio.select(key));
  const resize = () => view.stage.resize(box.clientWidth, box.clientHeight);
  new ResizeObserver(resize).observe(box);
  follow(studio, match, first, view);
}

function follow(studio: Studio, match: Match, first: FieldView, view: FieldView): void {
  const show = (time: number) => {
    view.selected = studio.selected;
    view.layers.clear();
    for (const layer of first.layers) view.layers.add(layer);
    if (view.views.mode !== first.views.mode) view.setView(first.views.mode);
    const moment = momentAt(match, time);
    if (moment.complete) return view.show(moment);
    void loadMoment(match, time)
      .then(() => view.show(momentAt(match, studio.cursor.time)))
      .catch(() => undefined);
  };
  studio.onShown = () => show(studio.cursor.time);
  studio.onTheme = (dark) => view.stage.setDark(dark);
  view.stage.setDark(document.documentElement.dataset["theme"] === "dark");
  show(studio.cursor.time);
}

export function askCompared(studio: Studio, background: Background, logs: OpenLog[]): void {
  const [a, b] = logs;
  if (!a || !b) return;
  background.onCompared = (times, frames, onlyOne) => {
    studio.timeLine.differences = times;
    studio.timeLine.redraw();
    const first = times[0];
    const more = onlyOne > 0 ? ` ${onlyOne} frames are in one of them only.` : "";
    studio.notes.say(
      first === undefined
        ? `All ${frames} frames that both logs have are the same.${more}`
        : `${times.length} of ${frames} frames differ, the first at ` +
            `${clockOf(first / 1e6, true)} ` +
            `(key d).${more}`,
    );
  };
  background.ask({ ask: "compare", a: a.place, b: b.place });
  const second = b.config;
  if (second) studio.extraLanes.push(laneOf(second, a.config));
  studio.robotsChanged();
}

// The second log's lane; of the same robot it has a name of its own.
function laneOf({ team, player }: LogConfig, first: LogConfig | undefined): LaneRobot {
  const key = robotKey(team, player);
  const same = first?.team === team && first.player === player;
  return { key: same ? `${key} b` : key, team, player, name: same ? " b" : "" };
}
