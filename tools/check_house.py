#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Fails on what the house style bans in every file: no SPDX line, #ifdef for host or robot, #pragma
to silence a warning, clocks and unseeded randomness in the stages, paths of one machine, and words
that gave way to the field's own."""

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
    "in the mean": "on average",
    "of late": "recently",
    "wished for": "requested",
    "no number": "NaN, or not finite",
}
RETIRED_WORD = re.compile(r"\b(" + "|".join(RETIRED) + r")\b")


def tracked(*patterns):
    return subprocess.run(["git", "ls-files", *patterns], cwd=ROOT, check=True,
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


def main():
    found = [p for path in tracked("*.h", "*.cpp") for p in code_problems(path)]
    for path in tracked("*.h", "*.cpp", "*.py", "*.md"):
        if path != "tools/check_house.py":
            found += retired_words(path)
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
