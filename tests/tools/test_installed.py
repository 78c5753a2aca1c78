# SPDX-License-Identifier: Apache-2.0
"""Programs that were installed elsewhere find their data beside themselves, never in the source
tree, and write only where the user stands. Takes the programs that are built."""

import os
import re
import shutil
import subprocess

import pytest
from conftest import BIN, ROOT

BUILD = BIN.parent


@pytest.fixture(scope="module", name="place")
def installed(tmp_path_factory):
    """The runtime component, as a package would put it under /usr."""
    place = tmp_path_factory.mktemp("usr")
    subprocess.run(["cmake", "--install", BUILD, "--prefix", place, "--component", "runtime",
                    "--strip"], check=True, capture_output=True)
    return place


def files_in(folder):
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}


def play(place, stand, *words):
    return subprocess.run([place / "bin/kelpie", "play", "--fast", "--seed", "4", "--seconds", "1",
                           "--no-film", *words], cwd=stand, capture_output=True, text=True,
                          timeout=120, check=False)


def test_an_installed_program_plays_with_the_behaviours_beside_it(place, tmp_path):
    main = place / "share/kelpie/pycode/main.py"
    good = main.read_text()
    try:
        main.write_text("boom(\n")
        said = play(place, tmp_path).stderr
    finally:
        main.write_text(good)
    assert f"{main}:1: SyntaxError" in said
    assert str(ROOT) not in said


def test_without_its_data_it_says_which_file_is_missing(place, tmp_path):
    shutil.copytree(place / "bin", tmp_path / "bin")
    result = play(tmp_path, tmp_path)
    assert result.returncode == 2
    assert f"{tmp_path}/share/kelpie/pycode: does not exist" in result.stderr


def test_it_writes_only_where_the_user_stands(place, tmp_path):
    before = files_in(place)
    home, stand, temporary = (tmp_path / name for name in ("home", "stand", "tmp"))
    for folder in (home, stand, temporary):
        folder.mkdir()
    env = {"PATH": os.environ["PATH"], "HOME": str(home), "TMPDIR": str(temporary)}
    result = subprocess.run([place / "bin/kelpie", "play", "--fast", "--seconds", "1", "--no-film"],
                            cwd=stand, env=env, capture_output=True, text=True, timeout=120,
                            check=False)
    assert result.returncode == 0, result.stderr
    assert files_in(stand) >= {"out/match.mcap", "out/match.png"}
    assert files_in(place) == before
    assert files_in(temporary) == set()
    assert {name for name in files_in(home) if "fontconfig" not in name} == set()


def test_the_programs_know_no_path_of_the_machine_that_built_them(place):
    for program in (place / "bin").iterdir():
        assert str(ROOT).encode() not in program.read_bytes(), program.name


def test_the_second_component_holds_what_the_first_does_not(place, tmp_path):
    if not (BIN / "kelpie-experiments").is_file():
        pytest.skip("kelpie-experiments is not built")
    subprocess.run(["cmake", "--install", BUILD, "--prefix", tmp_path, "--component", "dev"],
                   check=True, capture_output=True)
    dev = files_in(tmp_path)
    assert not dev & files_in(place)
    assert {"bin/kelpie-experiments", "share/kelpie/toolchain/check-object"} <= dev


def test_each_guide_that_a_guide_names_is_there(place):
    guides = place / "share/doc/kelpie"
    named = {name for guide in guides.glob("*.md")
             for name in re.findall(r"docs/([\w./-]+\.(?:md|png|json))", guide.read_text())}
    assert len(named) > 5
    assert {name for name in named if not (guides / name).is_file()} == set()


def test_a_team_that_comes_with_kelpie_is_found_from_anywhere(place, tmp_path):
    done = subprocess.run([place / "bin/kelpie", "league", "teams/kelpie", "teams/thesis",
                           "--matches", "2", "--minutes", "0.1", "--robots", "1v1", "--percepts"],
                          cwd=tmp_path, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    assert "thesis" in done.stdout


def test_a_team_of_the_user_s_goes_before_one_of_the_same_name(place, tmp_path):
    mine = tmp_path / "teams/thesis/main.py"
    mine.parent.mkdir(parents=True)
    mine.write_text("boom(\n")
    said = play(place, tmp_path, "--robots", "1v1", "--red", "teams/thesis").stderr
    assert "teams/thesis/main.py:1: SyntaxError" in said
    assert str(place) not in said
