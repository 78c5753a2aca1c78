# SPDX-License-Identifier: Apache-2.0
"""What tools/results reads and keeps: the data file of runs and rows, the digests of the files that
a run depends on, and the measured figures. Figures of other files than those of the tree stay, and
are called stale."""

import fnmatch
import hashlib
import json
import operator
import shlex
import subprocess
import tomllib
from pathlib import Path

# Many experiments give their trials the seeds S, S + 1, ...: seeds of the page lie far apart.
SEED_STEP = 1_000_000
COMPARE = {"<": operator.lt, "<=": operator.le, "=": operator.eq, ">=": operator.ge,
           ">": operator.gt}
TAKE = {"max": max, "min": min, "sum": sum, "ratio": lambda values: values[0] / values[1]}
FIELDS = {
    "data file": {"seeds", "files", "run", "subject"},
    "run": {"experiment", "trials", "options", "seconds", "seeded", "files", "alone"},
    "subject": {"title", "text", "run", "rows", "files"},
    "measured": {"run", "what", "key", "take", "factor", "digits", "unit", "required",
                 "required_says", "reference", "reference_key", "source", "needs_data"},
    "by hand": {"what", "command", "value", "stated", "digits", "unit", "required", "verdict",
                "reference", "source", "date", "commit", "files"}}
# What no figure depends on, wherever it stands.
WITHOUT_EFFECT = ("*.md", "test_*", "*.png")


class Refused(Exception):
    pass


class Missing(Exception):
    """A figure that cannot be had."""


def is_plain(text):
    """Whether a requirement compares with a number, not with a key."""
    try:
        return float(text) is not None
    except ValueError:
        return False


# --- the data file -------------------------------------------------------------------------------

def check_fields(where, table, kind, *needed):
    strange = set(table) - FIELDS[kind]
    lacking = [name for name in needed if name not in table]
    if strange:
        raise Refused(f"{where}: unknown field {min(strange)!r}")
    if lacking:
        raise Refused(f"{where}: no {lacking[0]!r}")


def check_row(where, row, runs):
    if "key" not in row:
        check_fields(where, row, "by hand", "what", "command", "date", "commit")
        if ("value" in row) == ("stated" in row):
            raise Refused(f"{where}: needs key, value or stated")
        if "stated" in row and ("required" in row) != (row.get("verdict") in ("met", "missed")):
            raise Refused(f"{where}: a text that is required needs the verdict 'met' or 'missed'")
    else:
        check_fields(where, row, "measured", "what", "run")
        if row["run"] not in runs:
            raise Refused(f"{where}: no run {row['run']!r}")
        if row.get("take", "max") not in TAKE:
            raise Refused(f"{where}: take is one of {', '.join(TAKE)}")
    if "required" in row and "stated" not in row:
        parts = row["required"].split()
        if len(parts) != 2 or parts[0] not in COMPARE:
            raise Refused(f"{where}: required is a comparison ({' '.join(COMPARE)}) with a number "
                          "or a key")


def files_of(where, run, sets):
    """The folders and files of a run, sets of them resolved."""
    named = run.get("files", ["play"])
    paths = [path for name in named for path in sets.get(name, [name])]
    if not paths:
        raise Refused(f"{where}: depends on no files")
    return sorted(set(paths))


def read_data(path):
    try:
        data = tomllib.loads(path.read_text())
    except (OSError, tomllib.TOMLDecodeError) as error:
        raise Refused(f"{path}: {error}") from None
    check_fields(path.name, data, "data file", "seeds", "files", "run", "subject")
    for name, run in data["run"].items():
        where = f"{path.name}: run {name}"
        check_fields(where, run, "run")
        run.setdefault("experiment", name)
        run["files"] = files_of(where, run, data["files"])
    for subject in data["subject"]:
        where = f"{path.name}: subject {subject.get('title')!r}"
        check_fields(where, subject, "subject", "title", "rows")
        for row in subject["rows"]:
            if "key" in row:
                row.setdefault("run", subject.get("run"))
            check_row(f"{where}: {row.get('what')!r}", row, data["run"])
            if "key" not in row:
                named = row.get("files", subject.get("files", ["play"]))
                row["files"] = files_of(where, {"files": named}, data["files"])
    return data


def words_of(run, seed):
    """The command that measures a run with a seed of the page."""
    words = shlex.split(run.get("command", f"kelpie evaluate {run['experiment']}"))
    if "trials" in run:
        words += ["--trials", str(run["trials"])]
    words += run.get("options", [])
    return words + (["--seed", str(seed * SEED_STEP)] if run.get("seeded", True) else [])


def command_of(run, seed):
    return shlex.join(words_of(run, seed))


def seeds_of(run, seeds):
    return seeds if run.get("seeded", True) else seeds[:1]


# --- figures -------------------------------------------------------------------------------------

def entries(place, name):
    if isinstance(place, dict):
        return list(place.values()) if name == "*" else [place[name]] if name in place else []
    field, is_entry, wanted = name.partition("=")
    if isinstance(place, list) and name.isdigit():
        return place[int(name):][:1]
    if not (isinstance(place, list) and is_entry):
        return []
    return [entry for entry in place if isinstance(entry, dict)
            and (str(entry.get(field)) == wanted or is_number(entry.get(field), wanted))][:1]


def is_number(value, text):
    try:
        return isinstance(value, (int, float)) and value == float(text)
    except ValueError:
        return False


def values_at(figures, key):
    """The numbers at a key like starts/start_cm=10/ours/success."""
    places = [figures]
    for name in key.split("/"):
        places = [entry for place in places for entry in entries(place, name)]
    if not places or not all(isinstance(place, (int, float)) for place in places):
        raise Missing(f"no key {key!r}")
    return places


def expression(row, key):
    """The name of a row's figure among those that are kept: its key, or what is made of several."""
    keys = key if isinstance(key, list) else [key]
    simple = len(keys) == 1 and "*" not in keys[0]
    return keys[0] if simple else f"{row.get('take', 'max')} of {' '.join(keys)}"


def expressions(data):
    """{run: {expression: (keys, take)}} of all that the rows name."""
    wanted = {name: {} for name in data["run"]}
    for row in (row for subject in data["subject"] for row in subject["rows"] if "key" in row):
        named = [row["key"], row.get("reference_key"), row.get("required", "= 0").split()[1]]
        for key in named:
            if key and not (isinstance(key, str) and is_plain(key)):
                keys = key if isinstance(key, list) else [key]
                wanted[row["run"]][expression(row, key)] = (keys, row.get("take", "max"))
    return wanted


def figure_at(figures, keys, take):
    """The figure in six digits; None where an experiment does not have it."""
    try:
        values = [value for key in keys for value in values_at(figures, key)]
        return float(f"{TAKE[take](values):.6g}")
    except (Missing, ZeroDivisionError):
        return None


# --- the files of the tree -----------------------------------------------------------------------

def git(root, *words):
    done = subprocess.run(["git", *words], cwd=root, capture_output=True, text=True, check=False)
    return done.stdout if done.returncode == 0 else None


def has_effect(path):
    return not any(fnmatch.fnmatch(Path(path).name, pattern) for pattern in WITHOUT_EFFECT)


def blob_hash(path):
    data = path.read_bytes()
    return hashlib.sha1(b"blob %d\0" % len(data) + data).hexdigest()


class Tree:
    """Digests of folders as they are now, changes that are not committed included, or as they were
    at a commit. A digest is of the contents alone, so that a file may move within its folder."""

    def __init__(self, root, commit=None):
        self.blobs = self.of_commit(root, commit) if commit else self.of_files(root)
        self.digests = {}

    @staticmethod
    def of_files(root):
        said = git(root, "ls-files", "-z", "--cached", "--others", "--exclude-standard")
        if said is None:
            raise Refused(f"{root} is no clone of git: nothing tells what its files are")
        paths = {path for path in said.split("\0") if path}
        return {path: root / path for path in paths if (root / path).is_file()}

    @staticmethod
    def of_commit(root, commit):
        said = git(root, "ls-tree", "-r", "-z", commit)
        if said is None:
            raise Refused(f"commit {commit} of the programs is not in the history")
        lines = [line.partition("\t") for line in said.split("\0") if line]
        return {path: what.split()[2] for what, _, path in lines}

    def digest(self, prefix):
        if prefix not in self.digests:
            inside = [blob for path, blob in self.blobs.items() if has_effect(path)
                      and (path == prefix or path.startswith(prefix + "/"))]
            hashes = sorted(blob_hash(b) if isinstance(b, Path) else b for b in inside)
            self.digests[prefix] = hashlib.sha1("".join(hashes).encode()).hexdigest()[:8]
        return self.digests[prefix]

    def of(self, paths):
        return {path: self.digest(path) for path in paths}


class History:
    """What has changed since figures were taken by hand, of which only the commit is known."""

    def __init__(self, root, tree):
        self.root, self.tree = root, tree
        self.trees = {}

    def at(self, commit):
        if commit not in self.trees:
            known = git(self.root, "cat-file", "-e", commit + "^{commit}") is not None
            self.trees[commit] = Tree(self.root, commit) if known else None
        return self.trees[commit]

    def reason(self, row):
        """Why a row by hand is stale; nothing where its files are those of the tree."""
        then = self.at(row["commit"])
        if then is None:
            return f"commit {row['commit']} is not in the history"
        return changes({path: then.digest(path) for path in row["files"]}, self.tree, row["files"])


def changes(then, tree, paths):
    """What of the paths has changed since it had these digests; nothing where nothing has."""
    now = tree.of(paths)
    changed = sorted(path for path in now if then.get(path) != now[path])
    return f"changed: {' '.join(changed)}" if changed else ""


# --- what is measured ----------------------------------------------------------------------------

class Measured:
    """The figures of each run that the page needs, in a file of the tree. They stand for all seeds
    of a run at once; those of a run that was never measured are lacking."""

    def __init__(self, path):
        self.path = path
        try:
            self.runs = json.loads(path.read_text()) if path.exists() else {}
        except ValueError as error:
            raise Refused(f"{path}: {error}") from None

    def write(self):
        """A line for each field of a run: a new measurement is a short difference."""
        parts = []
        for name, entry in sorted(self.runs.items()):
            lines = ",\n".join(f"  {json.dumps(field)}: {json.dumps(value)}"
                               for field, value in entry.items())
            parts.append(f"{json.dumps(name)}: {{\n{lines}\n }}")
        write_whole(self.path, "{\n " + ",\n ".join(parts) + "\n}\n")

    def keep(self, name, wanted, answers):
        """answers: the whole figures of each seed, in the order of the seeds."""
        made_by = [figures["made_by"] for figures in answers]
        self.runs[name] = {
            "command": made_by[0]["command"], "commit": made_by[-1]["commit"],
            "date": made_by[-1]["date"], "seeds": [made["seed"] for made in made_by],
            "cpu_s": [made["cpu_s"] for made in made_by], "files": made_by[-1]["files"],
            "figures": {named: [figure_at(figures, *how) for figures in answers]
                        for named, how in sorted(wanted.items())}}
        self.write()

    def forget(self, name):
        """The figures stay for the page, and are stale."""
        if name in self.runs:
            self.runs[name]["files"] = {}
            self.write()

    def reason(self, name, run, seeds, tree, wanted):
        """Why a run is stale; nothing where its figures are those of the tree."""
        if name not in self.runs:
            return "never measured"
        entry = self.runs[name]
        if not entry["files"]:
            return "to be measured again"
        changed = changes(entry["files"], tree, run["files"])
        if changed:
            return changed
        if entry["seeds"] != seeds or entry["command"] != command_of(run, seeds[0]):
            return f"measured by {entry['command']}, seeds {entry['seeds']}"
        lacking = [named for named in wanted if named not in entry["figures"]]
        return f"new rows: {lacking[0]}" if lacking else ""


def write_whole(path, text):
    part = path.with_name(path.name + ".part")
    part.write_text(text)
    part.replace(path)
