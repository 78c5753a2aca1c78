#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""object_sbom.py OBJECT: what the robot's object (build/openr/agent.o) is made of, as
AGENT.spdx.json (SPDX 2.3) in the folder agent.licences beside it, with the licences' texts.

Nothing is listed by hand. Archives and their members come from the linker's map, OBJECT.map, which
toolchain/openr/partial-link leaves; the sources of a member from what ninja recorded of its
compilation; CPython's and glibc's versions and checksums from python-openr/source.sha256 and their
licences from what its fetch unpacked; headers, and the modules of Python's library that are frozen
in, from Debian's packages. A member whose sources nobody owns ends it with exit code 2. What the
SDK adds in the final link is not in it. Same inputs, same bytes."""

import hashlib
import importlib.machinery
import importlib.util
import os
import re
import shutil
import sys
from collections import Counter, defaultdict
from pathlib import Path

import sbom
from sbom import ROOT, Trouble

PYTHON_OPENR = ROOT / "toolchain/python-openr"
MEMBER = re.compile(r"(?m)^(/\S+\.a)\((\S+)\)$")
LOOSE = re.compile(r"(?m)^LOAD (\S+)(?<!\.a)$")
TARBALL = re.compile(r"(?m)^(\w{64})  (\S+/([a-z]+)\S*_([\d.]+)\.orig\.tar\.\w+)$")
HOLDER = re.compile(r"Copyright[^\n]*\b(?:19|20)\d\d[^\n]*")
# By the folder that fetch unpacks each into: SPDX's name of its licence and the file of its text.
TERMS = {"python": ("Python-2.0", "LICENSE"), "glibc": ("LGPL-2.1-or-later", "COPYING.LIB")}


def members(object_file):
    """Archive -> names of the members that the linker took of it, by its map."""
    found, text = defaultdict(set), Path(f"{object_file}.map").read_text()
    for archive, member in MEMBER.findall(text):
        found[Path(archive)].add(member)
    loose = LOOSE.findall(text)
    if loose or not found:
        raise Trouble(f"{loose[0]}: is linked, and is no archive" if loose else
                      f"{object_file}.map: names no member of an archive")
    return found


def folder_of(archive):
    """The build folder that it lies in."""
    for folder in archive.parents:
        if (folder / "build.ninja").is_file():
            return folder
    raise Trouble(f"{archive}: is linked, and no build.ninja above it says what it is made of")


def linked_files(object_file):
    """(archive, its folder, [files that a member's compiler read]) of each member."""
    for archive, names in sorted(members(object_file).items()):
        folder = folder_of(archive)
        # CMake's names of targets begin at the folder, those of python-openr at the root.
        whole = f"build {archive}:" in (folder / "build.ninja").read_text()
        made_of = sbom.objects(folder, [archive if whole else archive.relative_to(folder)])
        taken = {path for path in made_of if os.path.basename(path) in names}
        if names - {os.path.basename(path) for path in taken}:
            raise Trouble(f"{archive}: ninja makes it without a member of the linker's map")
        for _, files in sorted(sbom.files_of(folder, taken).items()):
            yield archive, folder, files


def fetched_in(folder):
    """Name in TERMS -> where its sources lie, of a folder that python-openr/build has made."""
    found = re.search(r"(?m)^python = (.*)$", (folder / "build.ninja").read_text())
    return {name: Path(found[1]).parent / name for name in TERMS} if found else {}


def owner(path, fetched):
    for name, folder in fetched.items():
        if Path(path).is_relative_to(folder):
            return name
    if Path(path).is_relative_to(ROOT):
        return "kelpie"
    if path.startswith("/usr/"):
        return "debian"
    raise Trouble(f"{path}: is linked, and is of no source that is known")


class Parts:
    """Of an object, by owner: how many members of which archives, and what their compilers read."""

    def __init__(self, object_file):
        found = list(linked_files(object_file))
        self.fetched = {}
        for folder in sorted({folder for _, folder, _ in found}):
            self.fetched.update(fetched_in(folder))
        self.archives, self.files = defaultdict(Counter), defaultdict(set)
        for archive, _, files in found:
            self.archives[owner(files[0], self.fetched)][archive.name] += 1
            for path in files:
                self.files[owner(path, self.fetched)].add(path)

    def linked(self, name):
        return ", ".join(f"{archive} ({count})"
                         for archive, count in sorted(self.archives[name].items()))


def fetched_entry(name, parts):
    """With the holders that the sources name which are linked."""
    tarballs = {found[2]: found for found in TARBALL.findall(
        (PYTHON_OPENR / "source.sha256").read_text())}
    checksum, path, _, version = tarballs[name]
    texts = (Path(file).read_text(errors="replace") for file in parts.files[name])
    holders = {line.strip(" */") for text in texts for line in HOLDER.findall(text)}
    return sbom.entry(name, version, TERMS[name][0],
                      downloadLocation=f"https://deb.debian.org/debian/pool/main/{path[0]}/{path}",
                      checksums=[{"algorithm": "SHA256", "checksumValue": checksum}],
                      copyrightText="\n".join(sorted(holders)) or "NOASSERTION",
                      sourceInfo=f"linked: {parts.linked(name)}")


def frozen_files():
    """Modules of Python's own library that python-openr/freeze puts in."""
    loader = importlib.machinery.SourceFileLoader("freeze", str(PYTHON_OPENR / "freeze"))
    freeze = importlib.util.module_from_spec(importlib.util.spec_from_loader("freeze", loader))
    loader.exec_module(freeze)
    return [str(freeze.STDLIB / path) for path in freeze.NEEDED.values()]


def own_entry(object_file, parts):
    cache = (object_file.parent / "CMakeCache.txt").read_text()
    version = re.search(r"CMAKE_PROJECT_VERSION:STATIC=(\S+)", cache)[1]
    digest = hashlib.sha256(object_file.read_bytes()).hexdigest()
    return sbom.entry(f"kelpie-{object_file.stem}", version, "Apache-2.0",
                      checksums=[{"algorithm": "SHA256", "checksumValue": digest}],
                      sourceInfo=f"linked: {parts.linked('kelpie')}")


def write(object_file):
    parts = Parts(object_file)
    fetched = sorted(parts.archives.keys() & TERMS.keys())
    compiled = sbom.owners(parts.files["debian"])
    frozen = sbom.owners(frozen_files()) if "python" in fetched else {}
    groups = [
        ("STATIC_LINK", [fetched_entry(name, parts) for name in fetched]),
        ("STATIC_LINK", sbom.compiled_entries(compiled)),
        ("CONTAINS", [sbom.debian_entry(package, map(os.path.basename, files), "frozen in")
                      for package, files in sorted(frozen.items())])]
    out = object_file.with_suffix(".licences")
    sbom.copy_licences({*compiled, *frozen}, out)
    shutil.copyfile(ROOT / "LICENSE", out / "kelpie")
    for name in fetched:
        shutil.copyfile(parts.fetched[name] / TERMS[name][1], out / name)
    made = sbom.document(own_entry(object_file, parts), groups, "object_sbom.py")
    sbom.save(made, out / f"{object_file.stem.upper()}.spdx.json")


if __name__ == "__main__":
    try:
        if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
            raise Trouble("usage: object_sbom.py OBJECT")
        write(Path(sys.argv[1]).resolve())
    except (Trouble, OSError) as error:
        print(f"object_sbom.py: {error}", file=sys.stderr)
        sys.exit(2)
