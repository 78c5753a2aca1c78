#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Fails on a citation of a fact, row, section, equation or data set that docs/sources.md does not
hold, on one that names a document and no place in it, and on a line there that nothing cites."""

import bisect
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SOURCES = "docs/sources.md"
EXEMPT = (SOURCES, "tools/check_sources.py", "tests/tools/tree/test_sources.py")
JOINT = r"(?:,? and |, | to |\.\.)"
NUMBER = r"\d+(?:\.\d+)*"
ROW = rf"[A-Z](?:-{NUMBER}|\d\d?)"
NUMBERS, ROWS = (rf"{item}(?:{JOINT}{item})*" for item in (NUMBER, ROW))
KIND = r"(chapter|section|equation|[Ff]ig|algorithm)(?:ure)?[s.]*"
PLACES = rf"{KIND} ({NUMBERS})"
NAME = r"facts-2005|peer-2005|(?:openr(?:-measured)?|cross|physics)\.md"
CITATION = re.compile(
    rf"\b(?P<name>{NAME})(?:,? sections?)? (?P<numbers>{NUMBERS})(?P<check> check \d+)?"
    rf"|\b[Cc]hecklist (?P<rows>{ROWS})|\b(?P<row>[GHKMU]\d\d)\b"
    rf"|(?:\b[Tt]hesis )?\b(?P<year>200[46]) \(?(?P<places>{PLACES}(?:, {PLACES})*)"
    rf"|\b[Tt]hesis (?P<bare_year>200[46]) (?P<sections>{NUMBERS})"
    r"|(?:shared/|(?<![\w/]))data/(?P<data>[a-z0-9-]+)(?![\w./-]*\.py)"
    rf"|\b(?P<vague>{NAME}|[Cc]hecklist)\b")
MARKER = re.compile(r"^\s*(?://+|#+|\*)?\s*")


def tracked(*patterns):
    return subprocess.run(["git", "ls-files", *patterns], cwd=ROOT, check=True,
                          capture_output=True, text=True).stdout.split()


def listed(text):
    """Every item of "2.1.2 to 2.1.4 and 2.2.3" or "K01..K03", those in between included."""
    parts = re.split(f"({JOINT})", text)
    items = parts[:1]
    for joint, item in zip(parts[1::2], parts[2::2]):
        head, start = re.fullmatch(r"(.*?)(\d+)", items[-1]).groups()
        end = item.removeprefix(head)
        if joint in (" to ", "..") and end.isdigit():
            items += [f"{head}{n:0{len(start)}}" for n in range(int(start) + 1, int(end))]
        items.append(item)
    return items


def ids_of(match):
    """The ids in one citation as docs/sources.md writes them; none in a vague one."""
    if match["name"]:
        return [f"{match['name']} {n}{match['check'] or ''}" for n in listed(match["numbers"])]
    if match["rows"] or match["row"]:
        return [f"checklist {row}" for row in listed(match["rows"] or match["row"])]
    if match["data"]:
        return [f"data/{match['data']}"]
    if match["sections"]:
        return [f"thesis {match['bare_year']} section {n}" for n in listed(match["sections"])]
    return [f"thesis {match['year']} {kind.lower().replace('fig', 'figure')} {n}"
            for kind, numbers in re.findall(PLACES, match["places"] or "")
            for n in listed(numbers)]


def citations(path):
    """(line, ids, text) of every citation in a file; it may go over the end of a line."""
    lines = [MARKER.sub("", line).replace("`", "") + " "
             for line in (ROOT / path).read_text().splitlines()]
    ends = [sum(map(len, lines[:n + 1])) for n in range(len(lines))]
    for match in CITATION.finditer("".join(lines)):
        yield bisect.bisect_right(ends, match.start()) + 1, ids_of(match), match.group()


def main():
    held = {}
    for number, line in enumerate((ROOT / SOURCES).read_text().splitlines(), 1):
        match = CITATION.fullmatch(line.split("|")[1].strip()) if line.startswith("|") else None
        held.update((name, number) for name in (ids_of(match) if match else ()))
    found, cited = [], set()
    for path in tracked("*.h", "*.cpp", "*.py", "*.md", "*.toml", "*CMakeLists.txt"):
        for number, ids, text in citations(path) if path not in EXEMPT else ():
            cited.update(ids)
            found += [f"{path}:{number}: {name} is not in {SOURCES}"
                      for name in ids if name not in held]
            if not ids:
                found.append(f"{path}:{number}: {text}: say which section or row")
    found += [f"{SOURCES}:{number}: nothing cites {name}"
              for name, number in held.items() if name not in cited]
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
