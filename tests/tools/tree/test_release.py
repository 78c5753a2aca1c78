# SPDX-License-Identifier: Apache-2.0
"""What a package carries beside the programs: their manual, what bash completes, what is linked
with which licences, and the version. Packages themselves are made by tools/package --check."""

import json
import os
import shutil
import subprocess

import pytest
from conftest import BIN, ROOT, kelpie

BUILD = BIN.parent
PROGRAMS = [BIN / "kelpie", BIN / "kelpie-world"]
EXPERIMENTS = BIN / "kelpie-experiments"


def run(*words, **more):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True,
                          check=False, timeout=120, **more)


@pytest.fixture(scope="module", name="release")
def files_of_a_release(tmp_path_factory):
    out = tmp_path_factory.mktemp("release")
    for words in (["manual.py", BIN / "kelpie", out],
                  ["sbom.py", "write", out, "--build", BUILD, *PROGRAMS]):
        done = run("/usr/bin/python3", ROOT / "tools/release" / words[0], *words[1:], "--version",
                   "1.2", env={**os.environ, "SOURCE_DATE_EPOCH": "86400"})
        assert done.returncode == 0, done.stderr
    return out


@pytest.fixture(scope="module", name="dev_release")
def files_of_the_second_package(tmp_path_factory):
    if not EXPERIMENTS.is_file():
        pytest.skip("kelpie-experiments is not built")
    out = tmp_path_factory.mktemp("dev")
    for words in (["manual.py", EXPERIMENTS, out, "--of", "evaluate"],
                  ["sbom.py", "write", out, "--build", BUILD, "--name", "kelpie-dev",
                   EXPERIMENTS]):
        done = run("/usr/bin/python3", ROOT / "tools/release" / words[0], *words[1:], "--version",
                   "1.2")
        assert done.returncode == 0, done.stderr
    return out


def manual(release, name="kelpie"):
    return run("zcat", release / f"{name}.1.gz").stdout.replace("\\-", "-")


def test_the_manual_has_every_subcommand_and_its_options(release):
    page, said = manual(release), kelpie("--help").stdout
    names = [line.split()[0] for line in said.split("Subcommands:\n")[1].split("\n\n")[0]
             .splitlines()]
    assert len(names) > 20
    for name in set(names) - {"farm", "evaluate"}:
        assert f".SH KELPIE {name.upper()}\n" in page, name
    assert ".SH KELPIE CALIBRATE RING\n" in page
    assert "\\fB--opponent" in page and '"1970-01-02" "kelpie 1.2"' in page


def test_the_manual_shows_installed_paths(release):
    page = manual(release)
    assert "/usr/share/kelpie/pycode" in page and str(ROOT) not in page


def test_the_second_package_has_a_page_of_every_option_and_experiment(dev_release):
    page, said = manual(dev_release, "kelpie-evaluate"), run(EXPERIMENTS, "--help").stdout
    names = [line.split()[0] for line in said.split("Experiments:\n")[1].splitlines() if line]
    assert len(names) > 40 and page.startswith('.TH KELPIE-EVALUATE 1 "')
    for name in names:
        assert f"\n.TP\n\\fB{name}\\fR\n" in page, name
    assert "\\fB--trials" in page and ".B kelpie evaluate\n" in page and str(ROOT) not in page
    assert {path.name for path in dev_release.glob("*.gz")} == {"kelpie-evaluate.1.gz"}


def test_bash_completes_subcommands_options_and_those_of_a_subcommand(release):
    def completed(*words):
        listed = " ".join(f"'{word}'" for word in words)
        return run("bash", "-c", f". {release / 'kelpie'}; COMP_WORDS=({listed}); "
                   f"COMP_CWORD={len(words) - 1}; _kelpie; echo ${{COMPREPLY[@]}}").stdout.split()

    assert completed("kelpie", "new") == ["new-team"]
    assert "--opponent" in completed("kelpie", "play", "--")
    assert completed("kelpie", "play", "--seed", "3", "--opp") == ["--opponent"]
    assert completed("kelpie", "calibrate", "ri") == ["ring"]


def check(release, *programs, name="kelpie"):
    return run("/usr/bin/python3", ROOT / "tools/release/sbom.py", "check",
               release / f"{name}.spdx.json", *programs)


def test_every_library_that_the_loader_loads_is_named(release, tmp_path):
    assert check(release, *PROGRAMS).returncode == 0
    document = json.loads((release / "kelpie.spdx.json").read_text())
    document["packages"] = [one for one in document["packages"] if one["name"] != "libmujoco2.2.2"
                            and not one["name"].startswith("libmujoco")]
    (tmp_path / "kelpie.spdx.json").write_text(json.dumps(document))
    failed = check(tmp_path, BIN / "kelpie")
    assert failed.returncode == 1 and "does not name libmujoco" in failed.stdout


def test_all_that_is_linked_compiled_in_or_bundled_has_a_licence(release):
    packages = json.loads((release / "kelpie.spdx.json").read_text())["packages"]
    names = {one["name"] for one in packages}
    assert {"kelpie", "libeigen3-dev", "libstdc++6", "three"} <= names
    for one in packages:
        if "supplier" in one:
            assert (release / "licences" / one["name"]).stat().st_size > 100, one["name"]
        else:
            assert one["licenseDeclared"] != "NOASSERTION", one["name"]


def test_the_second_package_names_what_its_program_loads_with_the_licences(dev_release):
    assert check(dev_release, EXPERIMENTS, name="kelpie-dev").returncode == 0
    packages = json.loads((dev_release / "kelpie-dev.spdx.json").read_text())["packages"]
    assert packages[0]["name"] == "kelpie-dev"
    assert "three" not in {one["name"] for one in packages}  # the studio's page is in the first
    for one in packages[1:]:
        assert (dev_release / "licences" / one["name"]).stat().st_size > 100, one["name"]
    assert "kelpie-dev.spdx.json" in (dev_release / "copyright").read_text()


def test_a_program_is_not_made_of_the_experiments_or_tests_that_are_built_beside_it():
    """The list would depend on how far those are."""
    code = (f"import sys; sys.path.insert(0, '{ROOT}/tools/release'); import sbom; "
            f"print(*sbom.objects('{BUILD}', ['bin/kelpie']))")
    objects = run("/usr/bin/python3", "-B", "-c", code).stdout.split()
    assert any(name.startswith("tools/cli/") for name in objects)
    assert not [name for name in objects if name.startswith(("tests/", "tools/experiments/"))]


def test_identifiers_are_unique_and_relationships_point_to_them(release):
    document = json.loads((release / "kelpie.spdx.json").read_text())
    known = [one["SPDXID"] for one in document["packages"]]
    assert len(known) == len(set(known))
    assert {one["relatedSpdxElement"] for one in document["relationships"]} == set(known[1:])


# ---- the version ----

VERSION = """include(%s/cmake/version.cmake)
kelpie_version(${SOURCE} 3.2 version)
message(NOTICE "${version}")
"""


@pytest.fixture(name="tree")
def a_tree_of_one_commit(tmp_path):
    def git(*words):
        env = {**os.environ, "GIT_COMMITTER_DATE": "2026-01-02T12:00:00Z"}
        done = run("git", "-C", tmp_path, "-c", "user.name=t", "-c", "user.email=t@t", *words,
                   env=env)
        assert done.returncode == 0, done.stderr
        return done.stdout.strip()

    def version():
        script = tmp_path / "ask.cmake"
        script.write_text(VERSION % ROOT)
        return run("cmake", "-D", f"SOURCE={tmp_path}", "-P", script).stderr.strip()

    git("init", "-q")
    (tmp_path / "a.txt").write_text("one")
    git("add", "a.txt")
    git("commit", "-qm", "first")
    return tmp_path, git, version


def sorts_before(a, b):
    return run("dpkg", "--compare-versions", a, "lt", b).returncode == 0


def test_a_version_is_the_tags_and_commits_after_it_sort_behind(tree):
    _, git, version = tree
    git("tag", "v3.4")
    assert version() == "3.4"
    git("commit", "-q", "--allow-empty", "-m", "second")
    assert version() == f"3.4+1.g{git('rev-parse', '--short=7', 'HEAD')}"
    assert sorts_before("3.4", version()) and sorts_before(version(), "3.5")


def test_without_a_tag_the_version_sorts_before_the_one_to_come(tree):
    folder, git, version = tree
    git("tag", "release")  # is no version's
    clean = version()
    assert clean == f"3.2~20260102.g{git('rev-parse', '--short=7', 'HEAD')}"
    (folder / "a.txt").write_text("two")
    assert version() == clean + ".dirty"
    assert sorts_before(clean, "3.2")
    shutil.rmtree(folder / ".git")
    assert version() == "3.2~unknown"
