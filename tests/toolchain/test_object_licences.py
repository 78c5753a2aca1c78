# SPDX-License-Identifier: Apache-2.0
"""What toolchain/build-object leaves in agent.licences: every archive of the link is named, what is
fetched or compiled in has its licence beside the list, and what nobody knows is refused. Run by
ctest, which builds the object."""

import hashlib
import json
import os
import re
import shutil
from pathlib import Path

import pytest

from test_object import OBJECT, ROOT, SIMPLE, must, run

SCRIPT = ROOT / "tools/release/object_sbom.py"
BUILD = OBJECT.parent


def listed(folder):
    return json.loads(next(folder.glob("*.spdx.json")).read_text())


def packages(folder):
    return {one["name"]: one for one in listed(folder)["packages"]}


def archives_named(folder):
    texts = [one["sourceInfo"] for one in listed(folder)["packages"]]
    return {name for text in texts if text.startswith("linked: ")
            for name in re.findall(r"(lib\w+\.a) \(\d+\)", text)}


def archives_linked(name):
    """Of the command that ninja links it by, those that the linker's map has a member of."""
    command = must("ninja", "-C", BUILD, "-t", "commands", name).splitlines()[-1]
    taken = (BUILD / f"{name}.map").read_text()
    return {Path(word).name for word in command.split()
            if word.endswith(".a") and f"\n{word}(" in taken}


@pytest.mark.parametrize("made", [OBJECT, SIMPLE])
def test_every_archive_that_is_linked_is_named(made):
    linked = archives_linked(made.name)
    assert len(linked) > 10 and archives_named(made.with_suffix(".licences")) == linked


@pytest.mark.parametrize("made", [OBJECT, SIMPLE])
def test_the_list_is_that_of_the_object_beside_it(made):
    own = listed(made.with_suffix(".licences"))["packages"][0]
    digest = hashlib.sha256(made.read_bytes()).hexdigest()
    assert own["name"] == f"kelpie-{made.stem}" and own["checksums"][0]["checksumValue"] == digest


def test_python_and_glibc_have_version_checksum_holders_and_the_licence_that_was_unpacked():
    ninja = (ROOT / "build/python-openr/build.ninja").read_text()
    source = Path(re.search(r"(?m)^python = (.*)$", ninja)[1])
    found = packages(OBJECT.with_suffix(".licences"))
    for name, text, licence in (("python", source / "LICENSE", "Python-2.0"),
                                ("glibc", source.parent / "glibc/COPYING.LIB",
                                 "LGPL-2.1-or-later")):
        checksum = found[name]["checksums"][0]["checksumValue"]
        line = re.search(rf"(?m)^{checksum}  .*_{re.escape(found[name]['versionInfo'])}\.orig",
                         (ROOT / "toolchain/python-openr/source.sha256").read_text())
        assert line and found[name]["licenseDeclared"] == licence
        assert (OBJECT.with_suffix(".licences") / name).read_bytes() == text.read_bytes()
    assert "Free Software Foundation" in found["glibc"]["copyrightText"]
    assert "Sun Microsystems" in found["glibc"]["copyrightText"]


def test_headers_and_frozen_modules_have_their_packages_licence():
    found = packages(OBJECT.with_suffix(".licences"))
    assert {"libeigen3-dev", "libpython3.11-minimal"} <= set(found)
    assert any(name.startswith("libstdc++-") for name in found)
    for name, one in found.items():
        if "supplier" in one:
            assert (OBJECT.with_suffix(".licences") / name).stat().st_size > 100, name


def test_the_object_with_the_simple_player_has_neither_python_nor_glibcs_maths():
    assert not set(packages(SIMPLE.with_suffix(".licences"))) & {"python", "glibc",
                                                                 "libpython3.11-minimal"}


@pytest.fixture(name="copied")
def an_object_that_may_be_changed(tmp_path):
    for name in (SIMPLE.name, SIMPLE.name + ".map", "CMakeCache.txt"):
        shutil.copyfile(BUILD / name, tmp_path / name)
    return tmp_path / SIMPLE.name


def written(path):
    return run("/usr/bin/python3", "-B", SCRIPT, path,
               env={**os.environ, "SOURCE_DATE_EPOCH": "86400"})


def test_the_same_object_gives_the_same_list(copied):
    lists = set()
    for _ in range(2):
        assert written(copied).returncode == 0
        lists.add((copied.with_suffix(".licences") / "SIMPLE.spdx.json").read_bytes())
    assert len(lists) == 1 and b'"created": "1970-01-02' in lists.pop()


@pytest.mark.parametrize("line, said", [
    ("\n/nowhere/libstrange.a(strange.o)\n", "/nowhere/libstrange.a: is linked, and no build"),
    ("\nLOAD /nowhere/strange.o\n", "/nowhere/strange.o: is linked, and is no archive"),
    (f"\n{BUILD}/robot/core/libkelpie_core.a(Strange.o)\n", "libkelpie_core.a: ninja makes it")])
def test_what_nobody_knows_the_sources_of_is_refused_by_name(copied, line, said):
    with open(f"{copied}.map", "a") as out:
        out.write(line)
    done = written(copied)
    assert done.returncode == 2 and said in done.stderr and done.stderr.count("\n") == 1


def test_an_object_without_a_map_is_refused(copied):
    Path(f"{copied}.map").unlink()
    done = written(copied)
    assert done.returncode == 2 and "simple.o.map" in done.stderr
