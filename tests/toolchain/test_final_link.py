# SPDX-License-Identifier: Apache-2.0
"""The final link with an SDK's stand-in, which has two properties of the real one: its archives
want of the object what the SDK's do, and its headers print through streams. Planted faults of ours
in either end the link. What the link leaves beside the BIN tells where a program died. Run by
ctest, which builds the object and names the PC's programs."""

import gzip
import os
import re
import shutil
from pathlib import Path

import pytest

from test_object import FLAGS, ROOT, TOOLCHAIN, must, run

# What the SDK's archives want of a C++ library and of libgcc, and what the link must have in place
# of the SDK's own maths: names given by openr.md 3.5 and openr-measured.md 4, not by our sources.
WANTED = """_ZSt4cout _ZStlsISt11char_traitsIcEERSt13basic_ostreamIcT_ES5_PKc _ZNSolsEl _ZNSolsEm
_ZNSolsEPKv _ZNSolsEPFRSoS_E _ZSt4endlIcSt11char_traitsIcEERSt13basic_ostreamIT_T0_ES6_
_ZNSt8ios_base4InitC1Ev _ZNSt8ios_base4InitD1Ev
_ZNSt24__default_alloc_templateILb1ELi0EE8allocateEj
_ZNSt24__default_alloc_templateILb1ELi0EE10deallocateEPvj _ZTVN10__cxxabiv117__class_type_infoE
_ZTVN10__cxxabiv120__si_class_type_infoE __gxx_personality_v0 __cxa_pure_virtual
_Znwj _Znaj _ZdlPv _ZdaPv floor ceil lround __clzsi2""".split()
ARCHIVES = [f"OPEN_R/lib/lib{name}.a" for name in (
    "ObjectComm", "OPENR", "antMCOOP", "Internet", "apsys", "OFSpub", "c-", "mcoopstub", "nosys")]
ARCHIVES += ["mipsel-linux/lib/libm.a", "lib/gcc-lib/mipsel-linux/3.3.6/libgcc.a"]

STUBGEN = f"""grep -q '^ObjectName : Agent' "$1" || exit 1
cp {ROOT}/robot/openr/stub/*.h .
echo '#include "Agent.h"
Agent Self;
extern "C" void Exit();
extern "C" void InitOfSelf(const OSystemEvent& event) {{ Self.DoInit(event); Exit(); }}
extern "C" void NotifyOfSelf(const ONotifyEvent& event) {{ Self.NotifySensor(event); }}' \\
> AgentStub.cc"""
# Links all for 0x400000, and again for 0, where only _gp is what it was.
MKBIN = """here=$(dirname "$0")
echo "$@" > "$here/asked"
[ "$1 $2 $4 $5 $7" = "--nodefaultlib -p -o agent.bin agent.ocf" ] || exit 1
object=$6; shift 7
link() {
  script=$1; shift
  mipsel-linux-gnu-ld -EL -m elf32ltsmip -static --no-warn-rwx-segments -N -T "$here/$script" "$@"
}
link nosnap.ld -Map agent.map --no-demangle -o agent.nosnap.elf "$object" "$@" || exit 1
link merge.ld -o agent.bin "$object" "$@" || exit 1
pointer=$(mipsel-linux-gnu-nm agent.nosnap.elf | sed -n 's/ . _gp$//p')
mipsel-linux-gnu-objcopy --strip-symbol=_gp --add-symbol=_gp=0x$pointer agent.bin"""
STRIP = 'mipsel-linux-gnu-strip --strip-debug "$1"'
PRINTS = """
#include <iostream>
inline void kelpieCounted(int count) { std::cout << "regions " << long(count) << std::endl; }
inline void kelpieFailed(const void* at) { std::cerr << "failed at " << at << std::endl; }
"""


def tool(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)


def provided_names():
    rows = [line.split() for line in (TOOLCHAIN / "openr/undefined.txt").read_text().splitlines()
            if line and line[0] != "#"]
    return [name for name, library in rows if library not in ("linker", "nobody")]


def make_archives(sdk):
    """All functions are in one of them, which also wants all that the SDK's want; an object that
    calls one of them gets them all. Weak, since robot/openr's headers define two themselves."""
    functions = "".join(f".weak {name}\n{name}:\n" for name in provided_names())
    words = "".join(f".word {name}\n" for name in WANTED)
    (sdk / "all.s").write_text(f".text\n{functions}jr $31\nnop\n.data\n{words}")
    must("mipsel-linux-gnu-gcc", *[flag for flag in FLAGS if flag[:3] in ("-EL", "-ma", "-mf")],
         "-fPIC", "-c", "-o", sdk / "all.o", sdk / "all.s")
    for name in ARCHIVES:
        (sdk / name).parent.mkdir(parents=True, exist_ok=True)
        must("mipsel-linux-gnu-ar", "rc", sdk / name, *([sdk / "all.o"] if "OPENR" in name else []))


def make_headers(include):
    for header in (ROOT / "robot/openr/include").rglob("*.h"):
        to = include / header.relative_to(ROOT / "robot/openr/include")
        to.parent.mkdir(parents=True, exist_ok=True)
        to.write_text(header.read_text() + (PRINTS if header.name == "RCRegion.h" else ""))


def stand_in_sdk(folder):
    """Not an SDK: its headers are robot/openr's, its stub is two functions, its archives do
    nothing."""
    sdk = folder / "sdk"
    tool(sdk / "OPEN_R/bin/stubgen2", STUBGEN)
    tool(sdk / "OPEN_R/bin/mkbin", MKBIN)
    tool(sdk / "bin/mipsel-linux-strip", STRIP)
    script = (TOOLCHAIN / "openr/emulated/image.ld").read_text()
    for name, base in (("nosnap", "0x400000"), ("merge", "0")):
        (sdk / f"OPEN_R/bin/{name}.ld").write_text(
            script.replace(". = 0x10000;", f". = {base};").replace("ENTRY(kelpieBuffer)", ""))
    make_headers(sdk / "OPEN_R/include")
    make_archives(sdk)
    return sdk


def link(tmp_path, sdk, tree=ROOT):
    return run(tree / "toolchain/link-object", tmp_path / "AGENT.BIN",
               env={**os.environ, "OPENR_SDK": str(sdk)})


def planted(folder, file, change):
    """A tree like ours, of links, but for one file."""
    tree, ours = folder / "tree", ROOT
    for part in Path(file).parts:
        tree.mkdir()
        for entry in ours.iterdir():
            if entry.name != part:
                (tree / entry.name).symlink_to(entry)
        tree, ours = tree / part, ours / part
    text = ours.read_text()
    assert change(text) != text
    tree.write_text(change(text))
    tree.chmod(0o755)
    return folder / "tree"


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """The folder of a BIN that was linked, with what the link made on its way."""
    folder = tmp_path_factory.mktemp("linked")
    done = link(folder, stand_in_sdk(folder))
    assert done.returncode == 0, done.stderr
    assert "all.o: 13 gates, no fault" in done.stdout
    assert "not tried on a robot" in done.stdout and "agent.nosnap.elf" in done.stdout
    for name in ("agent.map", "agent.bin", "Agent.o"):
        shutil.copy(ROOT / "build/openr/final" / name, folder)
    return folder


def test_final_link_hands_the_whole_object_to_the_sdks_tools(made):
    asked = (made / "sdk/OPEN_R/bin/asked").read_text()
    assert "--nodefaultlib" in asked and "agent.ocf" in asked and "-lObjectComm -lOPENR" in asked
    (made / "packed").write_bytes(gzip.decompress((made / "AGENT.BIN").read_bytes()))
    for file in ("packed", "agent.nosnap.elf"):
        names = must("mipsel-linux-gnu-nm", "-C", made / file)
        assert " Self\n" in names and "kelpie::agent::FrameLoop::step" in names
        assert "kelpie::agent::Agent::NotifySensor" in names


def test_headers_that_print_give_the_object_no_constructor_of_streams(made):
    names = must("mipsel-linux-gnu-nm", made / "Agent.o")
    assert "_ZNSt8ios_base4InitC1Ev" not in names


@pytest.mark.parametrize("file, change, line", [
    ("robot/object/sdk/compat/iostream", lambda text: text.replace("<ostream>", "<iosfwd>"),
     "does not compile against"),
    ("toolchain/openr/roots.txt", lambda text: text.replace("_ZdaPv\n", ""),
     "undefined reference to `_ZdaPv'"),
    ("toolchain/link-object", lambda text: text.replace("Stub.o $work/Library33.o", "Stub.o"),
     "undefined reference to `__gxx_personality_v0'"),
    ("robot/object/sdk/Library33.cpp", lambda text: text.replace("_ZNSolsEPKv", "_ZNSolsEPKw"),
     "undefined reference to `_ZNSolsEPKv'")])
def test_fault_of_ours_that_the_sdk_would_refuse_ends_the_link(tmp_path, file, change, line):
    tree = planted(tmp_path, file, change)
    done = link(tmp_path, stand_in_sdk(tmp_path), tree)
    assert done.returncode == 2 and line in done.stderr + done.stdout
    assert done.stderr.splitlines()[-1].startswith("link-object: ")
    assert not (tmp_path / "AGENT.BIN").exists()


def test_object_with_the_sdks_headers_passes_the_gates_before_it_is_made_a_bin(tmp_path):
    """What only the final link has in it is looked at, too."""
    tree = planted(tmp_path, "robot/object/sdk/Library33.cpp", lambda text: text + (
        'extern "C" void* fopen(const char*, const char*);\n'
        'void* planted = fopen("/MS/A", "r");\n'))
    sdk = stand_in_sdk(tmp_path)
    done = link(tmp_path, sdk, tree)
    assert done.returncode == 2
    assert re.search(r"constructors: the static constructor \S+ reaches a file", done.stderr)
    assert done.stderr.splitlines()[-1].startswith("link-object: the object with the SDK's headers")
    assert not (sdk / "OPEN_R/bin/asked").exists() and not (tmp_path / "AGENT.BIN").exists()


def address_in_map(text, name):
    return int(re.search(rf"^ +0x([0-9a-f]+) +{name}\b", text, re.M)[1], 16)


def emon(folder, counter, pointer, program):
    (folder / "EMON.LOG").write_text(f"badvaddr: $8: 0x00000000, epc:$14: {counter:#010x}\n"
                                     f" gp:r28: {pointer:#010x}\n")
    kelpie = os.environ.get("KELPIE", ROOT / "build/host/bin/kelpie")
    return run(kelpie, "emon", folder / "EMON.LOG", "--object", program)


def test_emon_names_the_function_that_the_map_of_the_link_has_at_the_address(made):
    text = (made / "agent.map").read_text()
    moved = 0x22400000 - 0x400000
    pointer = address_in_map(text, "_gp") + moved
    for name, reported in (("_ZN6kelpie5agent5Agent12NotifySensorERK12ONotifyEvent",
                        "kelpie::agent::Agent::NotifySensor(ONotifyEvent const&) ("),
                       ("floor", "floor (")):
        counter = address_in_map(text, name) + moved + 8
        done = emon(made, counter, pointer, made / "agent.nosnap.elf")
        assert done.returncode == 0, done.stderr
        assert f"\ndied in    {reported}" in done.stdout
        assert f"loaded {moved:#010x} above its linked address\n" in done.stdout


def test_emon_refuses_the_program_that_was_moved_to_address_0(made):
    done = emon(made, 0x22400008, 0x22c00000, made / "agent.bin")
    assert done.returncode == 2 and "take the agent.nosnap.elf" in done.stderr


@pytest.mark.parametrize("words", [[], ["--simple"], ["--help"], ["a.bin", "b.bin"],
                                   ["a.bin", "--simple", "more"]])
def test_final_link_says_in_one_line_how_it_is_used(words):
    done = run(TOOLCHAIN / "link-object", *words)
    assert done.returncode == 2
    assert done.stderr == "link-object: usage: link-object BIN [--simple]\n"


@pytest.mark.parametrize("missing, line", [
    ("OPEN_R/bin/mkbin", "has no OPEN_R/bin/mkbin, so it is not the OPEN-R SDK"),
    ("OPEN_R/lib", "has no OPEN_R/lib, so it is not the OPEN-R SDK")])
def test_folder_that_is_no_sdk_is_refused(tmp_path, missing, line):
    sdk = stand_in_sdk(tmp_path)
    (sdk / missing).rename(tmp_path / "elsewhere")
    done = link(tmp_path, sdk)
    assert done.returncode == 2 and line in done.stderr
    assert not (tmp_path / "AGENT.BIN").exists()
