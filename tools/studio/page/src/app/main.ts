// SPDX-License-Identifier: Apache-2.0
// Opens what the server has and starts the page. Whatever fails is said in a line of the page.
import type { Body } from "../model/body";
import { matchOf, readConfig, type OpenLog } from "../model/match";
import { fetchJson, type Session, type SessionLog } from "../model/session";
import { HttpFile } from "../reading/httpFile";
import { LogFile } from "../reading/logFile";
import { Notes } from "../panels/notes";
import { comparedOf } from "./address";
import { byId } from "./dom";
import { startFacts } from "./background";
import { report } from "./report";
import { Studio } from "./studio";

const wordsOf = (error: unknown) => (error instanceof Error ? error.message : String(error));

async function openLog(log: SessionLog, place: number, notes: Notes): Promise<OpenLog[]> {
  for (const note of log.notes) notes.say(`${log.name}: ${note}`);
  try {
    const file = await LogFile.open(new HttpFile(log.url, log.bytes));
    if (file.chunks.length === 0) notes.say(`${log.name} holds no messages.`);
    return [{ name: log.name, place, file, config: await readConfig(file) }];
  } catch (error) {
    notes.say(`${log.name} cannot be read: ${wordsOf(error)}`, "error");
    return [];
  }
}

function shownLogs(session: Session, notes: Notes): SessionLog[] {
  const compared = comparedOf(location.search);
  if (!compared) return session.logs;
  if (compared.some((place) => !session.logs[place])) {
    notes.say("There are no two logs of these numbers to compare.", "error");
    return session.logs;
  }
  return session.logs;
}

async function start(notes: Notes): Promise<void> {
  const session = await fetchJson<Session>("/api/session");
  const body = await fetchJson<Body>(session.body).catch((error: unknown): Body => {
    notes.say(`The robot's body is not known, so no robot is drawn: ${wordsOf(error)}`, "error");
    return { links: [] };
  });
  const logs = (await Promise.all(shownLogs(session, notes).map((log, place) =>
    openLog(log, place, notes)))).flat();
  if (logs.length === 0) {
    notes.say("There is no log to show. Start kelpie studio with the logs of a match.");
    byId("main").classList.add("empty");
    return;
  }
  const match = matchOf(logs);
  for (const note of match.notes) notes.say(note);
  const studio = new Studio(match, body, notes);
  studio.title.names(session.logs.map((l) => l.name).join(", "), session.version);
  report(studio, notes);
  startFacts(studio, session.logs, match.truthLog);
}

const notes = new Notes(byId("notes"));
start(notes).catch((error: unknown) => notes.say(`The studio cannot start: ${wordsOf(error)}`,
  "error"));
