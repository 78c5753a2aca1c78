// SPDX-License-Identifier: Apache-2.0
// The facts of all logs as they come in, chunk by chunk in any order, joined where they touch.
import { ROWS, emptyRows, type Mark, type Possession, type Rows, type Segment } from "./facts";

const TOUCH = 120e3; // us
const SAME_MARK = 1.5e6; // us; the same again sooner is one that goes on in the next chunk

export function joinSegments(lists: Segment[][]): Segment[] {
  const joined: Segment[] = [];
  for (const list of lists)
    for (const segment of list) {
      const last = joined[joined.length - 1];
      if (last && last.label === segment.label && segment.from - last.to < TOUCH)
        last.to = Math.max(last.to, segment.to);
      else joined.push({ ...segment });
    }
  return joined;
}

// Adds to the list itself; a time before the list's end begins it anew.
function joinTail(list: Segment[], more: Segment[]): Segment[] {
  for (const segment of more) {
    const last = list[list.length - 1];
    if (last && segment.to < last.from) list.length = 0;
    if (last && last.label === segment.label && segment.from - last.to < TOUCH)
      last.to = Math.max(last.to, segment.to);
    else list.push(segment);
  }
  return list;
}

export function joinMarks(marks: Mark[]): Mark[] {
  const last = new Map<string, number>();
  return marks
    .slice()
    .sort((a, b) => a.time - b.time)
    .filter(({ time, kind, text }) => {
      const before = last.get(`${kind} ${text}`);
      last.set(`${kind} ${text}`, time);
      return (
        kind === "referee" || kind === "goal" || before === undefined || time - before > SAME_MARK
      );
    });
}

export class FactStore {
  private readonly rows = new Map<string, Map<number, Rows>>(); // by robot, by chunk
  private readonly joined = new Map<string, Rows>();
  private readonly possessions = new Map<number, Possession[]>();
  private allMarks: Mark[] = [];
  private shownMarks: Mark[] | undefined;
  private shownPossession: Possession[] | undefined;

  addRows(robot: string, chunk: number, rows: Rows): void {
    let chunks = this.rows.get(robot);
    if (!chunks) this.rows.set(robot, (chunks = new Map()));
    chunks.set(chunk, rows);
    this.joined.delete(robot);
  }

  // Of a live match: what follows all that was.
  appendRows(robot: string, rows: Rows): void {
    let chunks = this.rows.get(robot);
    if (!chunks) this.rows.set(robot, (chunks = new Map()));
    const last = chunks.get(0);
    if (!last) chunks.set(0, rows);
    else for (const row of ROWS) last[row] = joinTail(last[row], rows[row]);
    this.joined.set(robot, chunks.get(0)!);
  }

  addMarks(marks: readonly Mark[]): void {
    if (marks.length === 0) return;
    this.allMarks.push(...marks);
    this.shownMarks = undefined;
  }

  addPossession(chunk: number, list: Possession[]): void {
    this.possessions.set(chunk, list);
    this.shownPossession = undefined;
  }

  // Of a live match only the last minutes are kept.
  forgetBefore(time: number): void {
    for (const [robot, chunks] of this.rows) {
      const live = chunks.get(0);
      if (live && chunks.size === 1) {
        for (const row of ROWS) live[row] = live[row].filter((s) => s.to >= time);
        this.joined.set(robot, live);
        continue;
      }
      for (const [chunk, rows] of chunks)
        if (ROWS.every((row) => (rows[row][rows[row].length - 1]?.to ?? 0) < time))
          chunks.delete(chunk);
      this.joined.delete(robot);
    }
    for (const [chunk, list] of this.possessions)
      if ((list[list.length - 1]?.to ?? 0) < time) this.possessions.delete(chunk);
    this.shownPossession = undefined;
  }

  rowsOf(robot: string): Rows {
    const before = this.joined.get(robot);
    if (before) return before;
    const chunks = [...(this.rows.get(robot) ?? [])].sort((a, b) => a[0] - b[0]);
    const rows = emptyRows();
    for (const row of ROWS) rows[row] = joinSegments(chunks.map(([, list]) => list[row]));
    this.joined.set(robot, rows);
    return rows;
  }

  get marks(): readonly Mark[] {
    this.shownMarks ??= joinMarks(this.allMarks);
    return this.shownMarks;
  }

  get possession(): readonly Possession[] {
    this.shownPossession ??= [...this.possessions]
      .sort((a, b) => a[0] - b[0])
      .flatMap(([, list]) => list);
    return this.shownPossession;
  }

  get segments(): number {
    let count = 0;
    for (const robot of this.rows.keys())
      for (const row of ROWS) count += this.rowsOf(robot)[row].length;
    return count;
  }
}
