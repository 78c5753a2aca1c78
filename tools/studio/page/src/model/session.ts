// SPDX-License-Identifier: Apache-2.0
// What the server has: logs, perhaps a live match, the robot's body.
export interface SessionLog {
  name: string;
  url: string;
  bytes: number;
  notes: string[];
}
export interface Live {
  url: string;
  title: string;
  playing?: boolean; // absent: yes
  controls: boolean;
  behaviours: boolean;
}
export interface Session {
  version: string;
  logs: SessionLog[];
  live: Live | null;
  body: string;
}

export async function fetchJson<T>(url: string): Promise<T> {
  const answer = await fetch(url);
  if (!answer.ok) throw new Error(`${url} answers ${answer.status}`);
  return (await answer.json()) as T;
}
