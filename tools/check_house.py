#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Fails on what the house style bans in every file: no SPDX line, #ifdef for host or robot, #pragma
to silence a warning, clocks and unseeded randomness in the stages, paths of one machine, and words
that gave way to the field's own. In pages it fails on prose that is wider than a terminal, on
figures of a program that nobody else has, and on commit hashes, which make a guide a diary."""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
STAGES = ("robot/core/", "robot/body/", "robot/agent/", "vision/", "gps/", "actuator/")
RULES = [
    (re.compile(r"^\s*#\s*if(n?def|\s)"), (), "conditional compilation"),
    (re.compile(r"#\s*pragma\s+(?!once)|_Pragma"), (), "#pragma"),
    (re.compile(r"std::(rand|srand|random_device|mt19937)\b|\bchrono\b|\btime\(|gettimeofday"),
     STAGES, "clock or unseeded randomness in a stage"),
    (re.compile(r"\bthrow\b"), STAGES + ("behaviour/",), "exception in a stage"),
    (re.compile(r"std::(sin|cos|tan|atan2?|asin|acos|exp|log|pow|hypot)\("), STAGES,
     "C library function with other bits on the target; use kelpie::maths"),
]
MACHINE_PATH = re.compile(r"(^|[^A-Za-z0-9_.])/(work|root|home)/[A-Za-z]")
# What is no longer said, and what is said in its place.
RETIRED = {
    "unaskedWeight": "weightWithoutLineFit",
    "askLines": "fitLinesToHeaviest",
    "OthersParams": "PlayersParams",
    "OthersState": "PlayersState",
    "stepOthers": "stepPlayers",
    "AlikeUpdate": "SymmetryUpdate",
    "modesAlike": "symmetricModes",
    "posesAlike": "ambiguousPoses",
    "seenAlike": "movedWithFeature",
    "kMaxAlike": "kMaxAmbiguousPoses",
    "maxOffers": "maxPoses",
    "maxWorth": "maxCount",
    "wholeWorth": "fullWeightCount",
    "maxStrange": "maxUnmatchedShare",
    "bellOf": "fitPeak",
    "bellAtEdge": "fitEdgePeak",
    "GlobalSearch": "LinePoseSearch",
    "PinkSight": "PinkBearing",
    "PinkSights": "PinkBearings",
    "surprise": "squaredInnovation in a filter, nees of an estimate",
    "foretold": "predicted",
    "foretell": "predict",
    "hopeless": "degenerate",
    "kHopeless": "kDegenerateWeight",
    "standsOn": "tooCloseToLinearise",
    "noiseWeight": "outlierWeight",
    "leastAway": "minGoalLineDistance",
    "seenObliquely": "atGrazingAngle",
    "kWitness": "kMinGatingWeight",
    "ImageLevel": "HorizonFrame",
    "ImageUp": "ImageDirection",
    "levelPlace": "HorizonFrame::along",
    "LineScan": "BrightSegments",
    "brightStretches": "brightSegments",
    "risesOn": "risingEdges",
    "goalDoubt": "logOddsAgainst",
    "robotDoubt": "logOddsAgainst",
    "beaconDoubts": "logOddsAgainst",
    "weakCues": "logOddsAgainst",
    "seenWidth": "visibleWidth",
    "kPromising": "kRefineAboveShare",
    "postureIsSound": "poseIsInRange",
    "Workshop": "RunDirectory",
    "Crew": "ThreadPool",
    "UnlikeParams": "RandomisationParams",
    "UnlikeRobot": "RandomisedRobot",
    "UnlikeWorld": "RandomisedWorld",
    "SwayCurve": "OscillationCurve",
    "SwaySample": "OscillationSample",
    "WalkSway": "WalkOscillation",
    "takes_in": "would_own_goal",
    "holds_out": "hold_position",
    "harmless": "safe_walk",
    "worth_of": "utility_of",
    "kLeast": "kMin",
    "kMost": "kMax",
    "in the mean": "on average",
    "of late": "recently",
    "wished for": "requested",
    "no number": "NaN, or not finite",
}
RETIRED_WORD = re.compile(r"\b(" + "|".join(RETIRED) + r")\b")
PROSE_COLUMNS, PROSE_HASHES = 100, 5
# Records, which say of which commit a figure is.
RECORDS = ("docs/results.md", "docs/decisions.md")
# Written by a program, which wraps its lines as it can.
GENERATED = ("docs/results.md",)
CODE_LINE = re.compile(r" {4}")
HASH = re.compile(r"\b(?=[0-9]*[a-f])(?=[a-f]*[0-9])[0-9a-f]{7,40}\b")
NOBODY_HAS_IT = re.compile(r"not\s+in\s+the\s+tree")


def tracked(*patterns):
    return subprocess.run(["git", "ls-files", *patterns, ":!museum"], cwd=ROOT, check=True,
                          capture_output=True, text=True).stdout.split()


def code_problems(path):
    text = (ROOT / path).read_text()
    if "SPDX-License-Identifier: Apache-2.0" not in text[:400]:
        yield f"{path}:1: no SPDX line"
    for number, line in enumerate(text.splitlines(), 1):
        code = line.split("//")[0]
        for pattern, folders, what in RULES:
            if (not folders or path.startswith(folders)) and pattern.search(code):
                yield f"{path}:{number}: {what}"


def retired_words(path):
    for number, line in enumerate((ROOT / path).read_text().splitlines(), 1):
        for word in RETIRED_WORD.findall(line):
            yield f"{path}:{number}: '{word}': say {RETIRED[word]}"


def lines_beside_code(text):
    """Line numbers and lines of a page that are not code, tables included."""
    in_code = False
    for number, line in enumerate(text.splitlines(), 1):
        if line.lstrip().startswith("```"):
            in_code = not in_code
        elif not in_code and not CODE_LINE.match(line):
            yield number, line


def can_be_broken(line):
    """A row of a table, and a line that is one link or one word, have no place to break."""
    words = re.sub(r"\[[^\]]*\]\(", "(", line).removeprefix("- ").split()
    return len(words) > 1 and not line.startswith("|")


def excepted_pages():
    """Those that tools/size_exceptions lets be wider."""
    lines = (ROOT / "tools/size_exceptions").read_text().splitlines()
    return {line.split()[0] for line in lines if line and not line.startswith("#")}


def page_problems(path, text, excepted=()):
    if path not in GENERATED and path not in excepted:
        for number, line in lines_beside_code(text):
            if len(line) > PROSE_COLUMNS and can_be_broken(line):
                yield f"{path}:{number}: prose of {len(line)} columns, at most {PROSE_COLUMNS}"
    for match in NOBODY_HAS_IT.finditer(text):
        yield (f"{path}:{text.count(chr(10), 0, match.start()) + 1}: '{match.group()}': "
               "a figure has a command that repeats it, or is not written")


def hashes_in(path, text):
    """What looks like a commit's hash, of a page that is no record; code shows what a program
    prints."""
    if path in RECORDS:
        return []
    return [f"{path}:{number}: {commit}" for number, line in lines_beside_code(text)
            for commit in HASH.findall(line)]


def pages_problems(pages, excepted=()):
    """Of all pages together: path -> text."""
    found = [p for path, text in pages.items() for p in page_problems(path, text, excepted)]
    hashes = [h for path, text in pages.items() for h in hashes_in(path, text)]
    if len(hashes) > PROSE_HASHES:
        found += [f"{h}: a commit's hash; with the others {len(hashes)} outside "
                  f"{' and '.join(RECORDS)}, at most {PROSE_HASHES}" for h in hashes]
    return found


def main():
    found = [p for path in tracked("*.h", "*.cpp") for p in code_problems(path)]
    for path in tracked("*.h", "*.cpp", "*.py", "*.md"):
        if path != "tools/check_house.py":
            found += retired_words(path)
    found += pages_problems({path: (ROOT / path).read_text() for path in tracked("*.md")},
                            excepted_pages())
    for path in tracked("*.py", "tools/*", "toolchain/*", "*.cmake"):
        if not (ROOT / path).is_file() or path == "tools/check_house.py":
            continue
        for number, line in enumerate((ROOT / path).read_text().splitlines(), 1):
            if MACHINE_PATH.search(line):
                found.append(f"{path}:{number}: path of one machine")
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
