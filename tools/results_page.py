# SPDX-License-Identifier: Apache-2.0
"""docs/results.md as text, from the rows of the data file and the figures that are kept. The same
figures and the same tree give the same bytes. A figure that is not there is said to be missing,
and is a problem unless its run was never measured."""

from pathlib import Path

from results_data import (COMPARE, SEED_STEP, Missing, command_of, expression, is_plain, seeds_of)

SHARED = Path(__file__).resolve().parent.parent.parent / "shared/data"
HEAD = """# Results

**Simulation is no proof for a robot.** Every figure here is one of simulation, of a PC or of a
recording.

`tools/results` measures what is stale and writes this page. Rows are added and changed in
tools/experiments/results.toml, figures are kept in tools/experiments/measured.json. A figure says
"code changed since" when files that it depends on are others than at its commit: it may be another
one now. What is marked here was so when the page was written: `tools/results --page` marks it
again, and `tools/results --list` says what is stale in a tree, why, and how long it takes to
measure. What was tried and decided with such figures is in decisions.md. `tools/figures` holds a
few figures against bounds at each change.

A figure is the mean over the seeds of its run; in brackets stand the smallest and the largest,
where they differ in the digits shown. The seeds are {seeds} where nothing else is said.
A command has the first one: seed {first} is `--seed {first_word}`, since the trials of an
experiment count up from it.

| mark | meaning |
|---|---|
| met | every seed meets what is required |
| met on average | the mean meets it, not every seed |
| **missed** | the mean does not meet it |
| not measured | the experiment was not run yet, failed, or does not have this figure |
| - | nothing is required; in the column elsewhere: nothing to compare with |
| code changed since | files that the figure depends on have changed since; the last table names \
those of runs |
| stale | measured with other seeds or options, or of a commit that is not in the history |
| by hand | by that command on that day; the commit is the one that recorded it |
"""
CHANGED = "code changed since"


def in_digits(row, value):
    text = f"{value:.{row.get('digits', 2)}f}"
    return text.lstrip("-") if float(text) == 0 else text


def with_unit(row, value):
    return f"{in_digits(row, value)} {row.get('unit', '')}".rstrip()


def mean(values):
    return sum(values) / len(values)


def with_spread(row, values):
    """Mean over the seeds, and smallest and largest where these differ as shown."""
    low, high = in_digits(row, min(values)), in_digits(row, max(values))
    spread = f" ({low} to {high})" if low != high else ""
    return with_unit(row, mean(values)) + spread


def verdict_of(row, values, limits):
    if "required" not in row:
        return "-"
    meets = COMPARE[row["required"].split()[0]]
    if all(meets(value, limit) for value, limit in zip(values, limits)):
        return "met"
    return "met on average" if meets(mean(values), mean(limits)) else "**missed**"


def mark_of(reason):
    """How a cell ends whose figure is stale for that reason."""
    if not reason:
        return ""
    return f" {CHANGED}" if reason.startswith("changed: ") else " stale"


def requirement_of(row):
    if "required" not in row:
        return "-"
    if "stated" in row or not is_plain(row["required"].split()[1]):
        return row.get("required_says", row["required"])
    return f"{row['required']} {row.get('unit', '')}".rstrip()


def table(head, rows):
    cells = [[cell.replace("|", "\\|") for cell in row] for row in rows]
    return ["| " + " | ".join(head) + " |", "|" + "---|" * len(head),
            *("| " + " | ".join(row) + " |" for row in cells)]


class Page:
    def __init__(self, data, seeds, measured, reasons, history):
        """reasons: {run: why it is stale}, empty where it is not."""
        self.data, self.seeds, self.measured, self.reasons = data, seeds, measured, reasons
        self.history = history
        self.problems = []  # one line each
        self.verdicts = []  # (subject, what, figure, required, verdict, mark) of what is required

    def kept(self, row, key):
        """A value for each seed, in the row's own unit."""
        entry = self.measured.runs.get(row["run"])
        if entry is None:
            raise Missing("not run yet")
        values = entry["figures"].get(expression(row, key))
        if values is None or None in values:
            raise Missing(f"no key {key!r}")
        return [value * row.get("factor", 1) for value in values]

    def limits(self, row, count):
        wanted = row.get("required", "= 0").split()[1]
        return [float(wanted)] * count if is_plain(wanted) else self.kept(row, wanted)

    def figure(self, row):
        """Cells of figure, verdict and what others have."""
        try:
            values = self.kept(row, row["key"])
            verdict = verdict_of(row, values, self.limits(row, len(values)))
            reference = row.get("reference", "")
            if "reference_key" in row:
                reference = with_unit(row, mean(self.kept(row, row["reference_key"])))
            return with_spread(row, values), verdict, reference
        except Missing as error:
            if row.get("needs_data") and not SHARED.is_dir():
                return "needs ../shared/data", "-", row.get("reference", "")
            if row["run"] in self.measured.runs:
                self.problems.append(f"{row['run']}: {error}")
            unknown = "not measured" if "required" in row else "-"
            return f"not measured ({error})", unknown, row.get("reference", "")

    def command(self, name):
        if name in self.measured.runs:
            return self.measured.runs[name]["command"]
        return command_of(self.data["run"][name], self.seeds[0])

    def when(self, name):
        """Commit and day of a run's figures, and whether they are stale."""
        entry = self.measured.runs.get(name)
        if entry is None:
            return "-"
        return f"{entry['commit']} {entry['date']}" + mark_of(self.reasons[name])

    @staticmethod
    def by_hand(row):
        """Cells of figure, verdict and what others have of a row that no run measures."""
        if "value" in row:
            limit = [float(row.get("required", "= 0").split()[1])]
            return with_unit(row, row["value"]), verdict_of(row, [row["value"]], limit), \
                row.get("reference", "")
        verdict = {"missed": "**missed**"}.get(row.get("verdict"), row.get("verdict", "-"))
        return row["stated"], verdict, row.get("reference", "")

    def cells(self, row, last_command):
        if "key" in row:
            figure, verdict, reference = self.figure(row)
            command, when = f"`{self.command(row['run'])}`", self.when(row["run"])
        else:
            figure, verdict, reference = self.by_hand(row)
            command = row["command"] if row["command"] == "the same" else f"`{row['command']}`"
            when = f"{row['commit']} {row['date']} by hand" + mark_of(self.history.reason(row))
        if reference and "source" in row:
            reference += f" ({row['source']})"
        return [row["what"], "the same" if command == last_command else command, figure,
                requirement_of(row), verdict, reference or "-", when], command

    def subject(self, subject):
        rows, command = [], None
        for row in subject["rows"]:
            cells, command = self.cells(row, command)
            rows.append(cells)
            if "required" in row:
                self.verdicts.append((subject["title"], row["what"], *cells[2:5], cells[6]))
        head = ["what", "command", "figure", "required", "mark", "elsewhere", "measured"]
        text = [subject["text"].strip(), ""] if subject.get("text") else []
        return [f"## {subject['title']}", "", *text, *table(head, rows), ""]

    def summary(self):
        marks = [mark for *_, mark, _ in self.verdicts]
        behind = sum(mark != "not measured" and when.endswith(CHANGED)
                     for *_, mark, when in self.verdicts)
        stale = sum(map(bool, self.reasons.values()))
        lines = [f"{len(marks)} figures have a requirement: {marks.count('met')} met, "
                 f"{marks.count('met on average')} met on average, "
                 f"{marks.count('**missed**')} missed, {marks.count('not measured')} not measured. "
                 f"Of those measured the code of {behind} has changed since.",
                 f"{stale} of {len(self.reasons)} runs are stale or were never measured.", ""]
        others = [[mark, title, what, figure, required, when]
                  for title, what, figure, required, mark, when in self.verdicts
                  if mark not in ("met", "not measured")]
        head = ["mark", "table", "what", "figure", "required", "measured"]
        return lines + ([*table(head, others), ""] if others else [])

    def runs(self):
        rows, whole = [], 0.0
        for name in self.data["run"]:
            entry = self.measured.runs.get(name, {})
            taken = entry.get("cpu_s", [])
            whole += sum(taken)
            seeds = seeds_of(self.data["run"][name], self.seeds)
            others = "" if entry.get("seeds", seeds) == seeds else f", seeds {entry['seeds']}"
            rows.append([name, f"`{self.command(name)}`{others}",
                         f"{mean(taken):.1f}" if taken else "-", self.when(name),
                         self.reasons[name] or "-"])
        head = ["run", "command, first seed", "seconds of one core a seed", "measured", "stale"]
        return ["## What was run", "", *table(head, rows), "",
                f"Together {whole / 60:.0f} minutes of one core."]

    def text(self):
        head = HEAD.format(seeds=" and ".join(map(str, self.seeds)), first=self.seeds[0],
                           first_word=self.seeds[0] * SEED_STEP).splitlines()
        tables = [line for subject in self.data["subject"] for line in self.subject(subject)]
        return "\n".join([*head, "", *self.summary(), *tables, *self.runs()]) + "\n"
