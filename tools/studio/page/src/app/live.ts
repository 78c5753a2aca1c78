// SPDX-License-Identifier: Apache-2.0
// A match that is being played: its messages go into the same panels as those of logs, and the
// cursor follows the newest until somebody goes back.
import { Dragging, type Held } from "../drawing/dragging";
import type { Body } from "../model/body";
import { FactStore } from "../model/factStore";
import type { Point } from "../model/field";
import { LiveMatch, wantedTopic } from "../model/liveMatch";
import { fetchJson, type Live, type Session } from "../model/session";
import { Editor } from "../panels/editor";
import { LivePanel, httpOrders } from "../panels/livePanel";
import type { Notes } from "../panels/notes";
import { LiveLink } from "../reading/liveLink";
import { byId } from "./dom";
import { addLivePlots } from "./plotting";
import { report } from "./report";
import { Studio } from "./studio";

const LOST = "Connection lost, trying again.";
const OVER = "The match is over.";
const BEHIND = 90e3; // us behind the newest message, so that there is one to interpolate to

function addressOf(url: string): string {
  const address = new URL(url, location.href);
  address.protocol = address.protocol === "https:" ? "wss:" : "ws:";
  return address.href;
}

export function startLive(session: Session, live: Live, body: Body, notes: Notes): void {
  const facts = new FactStore();
  const match = new LiveMatch(facts);
  const lines: string[] = [];
  match.onLine = (line) => lines.push(line);
  notes.say("Waiting for the match.");
  match.onField = () => {
    notes.take("Waiting for the match.");
    show(new Studio(match.match, body, notes, facts), match, live, lines);
  };
  const onState = (connected: boolean) => {
    if (connected) notes.take(LOST);
    else void sayWhy(notes);
  };
  new LiveLink(addressOf(live.url), wantedTopic, {
    state: onState,
    channel: (channel) => match.addChannel(channel),
    message: (channel, _time, bytes) => match.addMessage(channel, bytes),
    said: (line) => notes.say(line === "the match is over" ? OVER : line),
    anotherMatch: () => location.reload(),
  });
  document.title = `${live.title}: Kelpie studio`;
  void session;
}

async function sayWhy(notes: Notes): Promise<void> {
  const now = await fetchJson<Session>("/api/session").catch(() => undefined);
  const over = now !== undefined && (!now.live || now.live.playing === false);
  notes.take(over ? LOST : OVER);
  notes.say(over ? OVER : LOST);
}

function show(studio: Studio, match: LiveMatch, live: Live, lines: string[]): void {
  const { cursor, notes } = studio;
  studio.title.names(live.title, "live");
  report(studio, notes);
  match.onRobots = () => studio.robotsChanged();
  const panel = live.controls ? new LivePanel(httpOrders) : undefined;
  if (panel) byId("dock").prepend(panel.element);
  if (panel) addDragging(studio, panel);
  const plots = addLivePlots(studio);
  window.setInterval(() => {
    plots.fillSources();
    plots.refresh();
  }, 2000);
  const editor = new Editor(live.behaviours);
  studio.tabs.add("Behaviours", editor.element);
  studio.tabs.choose("Decisions");
  match.onLine = (line) => editor.addLine(line);
  for (const line of lines.splice(0)) editor.addLine(line);
  cursor.following = true;
  studio.onEnd = () => (cursor.following = true);
  follow(studio, panel);
}

// At every picture the cursor takes a part of the way to the end that it follows.
function follow(studio: Studio, panel: LivePanel | undefined): void {
  const { cursor, axis, match } = studio;
  let grown = 0;
  let chosen = false;
  const step = () => {
    requestAnimationFrame(step);
    cursor.from = match.from;
    cursor.grow(Math.max(match.from, match.to - BEHIND));
    if (match.to - grown > 5e5 || match.to < grown) {
      grown = match.to;
      axis.grow(match.from, match.to);
      studio.lanes.redrawSoon();
      studio.timeLine.redrawSoon();
    }
    if (studio.moment) panel?.show(studio.moment);
    const first = match.robots[0];
    if (first && !chosen) studio.select(first.key);
    chosen ||= first !== undefined;
    const left = cursor.to - cursor.time;
    if (cursor.following && left > 1000)
      cursor.set(left > 1e6 ? cursor.to : cursor.time + 0.25 * left);
  };
  step();
}

function addDragging(studio: Studio, panel: LivePanel): void {
  const field = studio.field;
  if (!field) return;
  const drop = (held: Held, place: Point) => {
    if ("ball" in held) return void panel.putBall(place);
    const { team, player, truth, belief } = held.robot;
    const heading = (((truth ?? belief)?.heading ?? 0) * 180) / Math.PI;
    void panel.putRobot(team, player, place, heading);
  };
  const dragging = new Dragging(
    field.stage.renderer.domElement,
    field.stage.camera,
    () => studio.moment,
    (on) => (field.views.controls.enabled = on),
    () => field.dragTo(dragging.held ? dragging.place : undefined),
    drop,
  );
}
