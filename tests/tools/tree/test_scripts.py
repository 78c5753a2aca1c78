# SPDX-License-Identifier: Apache-2.0
"""The scripts in tools/ that a newcomer meets: help, and one clear line when something is wrong."""

import os
import shutil
import subprocess

import pytest

from conftest import ROOT

TOOLS = ROOT / "tools"


def run(*command, **options):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True,
                          timeout=60, check=False, stdin=subprocess.DEVNULL, **options)


def path_with(folder, *programs):
    """A PATH where only these programs are."""
    folder.mkdir()
    for name in ("bash", "dirname", "id", *programs):
        (folder / name).symlink_to(shutil.which(name))
    return {"PATH": str(folder)}


@pytest.fixture
def built(tmp_path):
    """tools/build in a tree of its own with a cmake that notes how it is called and finds
    GoogleTest as $GTEST says."""
    (tmp_path / "tools").mkdir()
    for name in ("build", "progress"):
        shutil.copy(TOOLS / name, tmp_path / "tools")
    (tmp_path / "CMakePresets.json").write_text("{}")
    (tmp_path / "bin").mkdir()
    cmake = tmp_path / "bin/cmake"
    cmake.write_text("""#!/bin/sh
echo "$*" >>calls
[ "$1" = --preset ] || exit 0
mkdir -p build/$2 && touch build/$2/build.ninja
echo KELPIE_HAS_TESTS:INTERNAL=$GTEST >build/$2/CMakeCache.txt
""")
    cmake.chmod(0o755)

    def build(*words, gtest):
        (tmp_path / "calls").write_text("")
        result = run(tmp_path / "tools/build", *words, env={
            "PATH": f"{tmp_path}/bin:{os.environ['PATH']}", "GTEST": str(gtest)})
        return result, (tmp_path / "calls").read_text().splitlines()
    return build


@pytest.mark.parametrize("name", ["run", "test", "build", "install", "check", "bare", "fuzz",
                                  "package"])
def test_help_names_the_script_and_does_nothing_else(name):
    result = run(TOOLS / name, "--help")
    assert result.returncode == 0 and result.stderr == ""
    assert result.stdout.startswith(f"tools/{name} ") and "#" not in result.stdout


def test_programs_are_built_without_googletest(built):
    result, calls = built("host", "kelpie", gtest=0)
    assert result.returncode == 0
    assert calls == ["--preset host", "--build --preset host --target kelpie -- --quiet"]


def test_tests_that_would_not_be_built_are_an_error(built):
    result, calls = built("--tests", "host", gtest=0)
    assert result.returncode == 1 and calls == ["--preset host"]
    assert "has no tests: CMake finds no GoogleTest (package libgtest-dev)" in result.stderr


def test_folder_without_tests_gets_them_when_googletest_came_later(built):
    built("host", gtest=0)
    build = "--build --preset host -- --quiet"
    assert built("host", gtest=1)[1] == [build]
    assert built("--tests", "host", gtest=1)[1] == ["--preset host", build]
    assert built("--tests", "host", gtest=1)[1] == [build]


def test_stage_shows_what_a_failed_command_printed_and_keeps_its_code():
    failed = run("bash", "-c", ". tools/progress; stage Trying sh -c 'echo why; exit 7'", cwd=ROOT)
    assert failed.returncode == 7
    assert "why\nTrying: failed after" in failed.stderr and failed.stdout == ""
    done = run("bash", "-c", ". tools/progress; stage Trying echo noise", cwd=ROOT)
    assert done.returncode == 0 and "noise" not in done.stderr
    assert done.stderr.startswith("Trying ...\nTrying: ")


def test_fuzz_refuses_what_it_does_not_know():
    for words in (["--seconds", "0"], ["--seconds"], ["--minutes", "1"], ["seeds"], ["nothing"]):
        assert run(TOOLS / "fuzz", *words).returncode == 2, words
    assert "no target nothing" in run(TOOLS / "fuzz", "nothing").stderr


def test_unknown_purpose_is_refused():
    result = run(TOOLS / "install", "breakfast")
    assert result.returncode == 2
    assert result.stderr == "tools/install: tools/packages names nothing for breakfast\n"


@pytest.mark.skipif(os.getuid() != 0, reason="needs root to ask as root")
def test_bare_names_the_program_that_it_lacks(tmp_path):
    result = run("/bin/bash", TOOLS / "bare", "check", env=path_with(tmp_path / "bin"))
    assert result.returncode == 2
    assert result.stderr == "tools/bare: needs mmdebstrap or debootstrap: tools/install bare\n"


def test_bare_without_root_rights_says_so():
    drop = ["setpriv", "--reuid=65534", "--clear-groups"] if os.getuid() == 0 else []
    script = (TOOLS / "bare").read_text()  # as text: nobody may not be allowed to read the tree
    script = script.replace('cd "$(dirname "$0")/.."', "cd /").replace(". tools/progress", "true")
    result = run(*drop, "/bin/bash", "-c", script, "tools/bare", "run")
    assert result.returncode == 2
    assert result.stderr == "tools/bare: needs root, to make the folder of a machine\n"


@pytest.mark.parametrize("words, code", [
    (["--help"], 0), (["--sheets"], 2), (["one", "two"], 2),
    ([ROOT / "tests/data/record.sh"], 2)])
def test_the_recording_script_asked_wrongly_records_nothing(words, code):
    data = ROOT / "tests/data"
    before = {path: path.stat().st_mtime_ns for path in data.rglob("*")}
    result = run(data / "record.sh", *words)
    assert result.returncode == code and "Building" not in result.stdout + result.stderr
    assert {path: path.stat().st_mtime_ns for path in data.rglob("*")} == before
