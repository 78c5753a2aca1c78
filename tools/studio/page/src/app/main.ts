// SPDX-License-Identifier: Apache-2.0
// Opens what the server has and starts the page. Whatever fails is said in a line of the page.
import { bodyOf, type Body } from "../model/body";
import { matchOf, readConfig, type OpenLog } from "../model/match";
import { fetchJson, type Session, type SessionLog } from "../model/session";
import { HttpFile } from "../reading/httpFile";
import { Types } from "../reading/decoder";
import { LogFile } from "../reading/logFile";
import { Notes } from "../panels/notes";
import { comparedOf } from "./address";
import { byId, make } from "./dom";
import { addSecond, askCompared } from "./compare";
import { startFacts } from "./background";
import { startLive } from "./live";
import { report } from "./report";
import { Studio } from "./studio";

const wordsOf = (error: unknown) => (error instanceof Error ? error.message : String(error));

async function openLog(
  log: SessionLog,
  place: number,
  types: Types,
  notes: Notes,
): Promise<OpenLog[]> {
  for (const note of log.notes) notes.say(`${log.name}: ${note}`);
  try {
    const file = await LogFile.open(new HttpFile(log.url, log.bytes), types);
    if (file.chunks.length === 0) notes.say(`${log.name} holds no messages.`);
    return [{ name: log.name, place, file, config: await readConfig(file) }];
  } catch (error) {
    notes.say(`${log.name} cannot be read: ${wordsOf(error)}`, "error");
    return [];
  }
}

// The two logs to compare, if the address asks for it.
function comparedLogs(logs: OpenLog[], notes: Notes): [OpenLog, OpenLog] | undefined {
  const places = comparedOf(location.search);
  if (!places) return undefined;
  const [a, b] = places.map((place) => logs.find((log) => log.place === place));
  if (a && b) return [a, b];
  notes.say("There are no two logs of these numbers to compare.", "error");
  return undefined;
}

async function start(notes: Notes): Promise<void> {
  const session = await fetchJson<Session>("/api/session");
  const body = await fetchJson<Parameters<typeof bodyOf>[0]>(session.body)
    .then(bodyOf)
    .catch((error: unknown): Body => {
      notes.say(`The robot's body is not known, so no robot is drawn: ${wordsOf(error)}`, "error");
      return { links: [] };
    });
  const types = new Types();
  const live = session.live;
  const asked = new URLSearchParams(location.search);
  const waits = live && (live.playing !== false || session.logs.length === 0);
  if (live && waits && !asked.has("logs")) return startLive(session, live, body, notes);
  const logs = (
    await Promise.all(session.logs.map((log, place) => openLog(log, place, types, notes)))
  ).flat();
  if (logs.length === 0) {
    notes.say("There is no log to show. Start kelpie studio with the logs of a match.");
    byId("title").append(make("h1", {}, "Kelpie ", make("span", {}, "studio")));
    byId("main").classList.add("empty");
    return;
  }
  showLogs(session, logs, body, notes);
  if (live && !asked.has("logs")) watchForMatch(notes);
}

// Who looks at a match that was played hears of the next in its folder.
function watchForMatch(notes: Notes): void {
  const timer = window.setInterval(() => {
    void fetchJson<Session>("/api/session")
      .then((session) => {
        if (session.live?.playing !== true) return;
        window.clearInterval(timer);
        notes.say("A match is being played: load the page again to watch it.");
      })
      .catch(() => window.clearInterval(timer));
  }, 5000);
}

function showLogs(session: Session, logs: OpenLog[], body: Body, notes: Notes): void {
  const compared = comparedLogs(logs, notes);
  const match = matchOf(compared ? [compared[0]] : logs);
  for (const note of match.notes) notes.say(note);
  const studio = new Studio(match, body, notes);
  const names = (compared ?? logs).map((log) => log.name);
  studio.title.names(names.join(compared ? " and " : ", "), session.version);
  report(studio, notes);
  if (compared) addSecond(studio, compared[1], body);
  const background = startFacts(studio, session.logs, match.truthLog);
  if (compared) askCompared(studio, background, compared);
}

const notes = new Notes(byId("notes"));
start(notes).catch((error: unknown) =>
  notes.say(`The studio cannot start: ${wordsOf(error)}`, "error"),
);
