# SPDX-License-Identifier: Apache-2.0
"""kelpie new-team makes a folder that plays at once, and only where nothing is lost by it."""

import subprocess

import pytest
from conftest import ROOT, complaint, kelpie


@pytest.fixture(scope="module", name="team")
def a_new_team(tmp_path_factory):
    folder = tmp_path_factory.mktemp("teams") / "foxes"
    result = kelpie("new-team", folder)
    assert result.returncode == 0, result.stderr
    return folder


def test_its_behaviour_is_short_and_its_page_names_the_folder(team):
    code = [line for line in (team / "main.py").read_text().splitlines()
            if line and not line.startswith("#")]
    assert len(code) <= 15
    assert "kelpie play --pycode foxes" in (team / "README.md").read_text()


def test_its_own_test_passes_and_notices_a_robot_that_never_kicks(team):
    def tested():
        return subprocess.run(["/usr/bin/python3", team / "test/test_main.py"], check=False,
                              capture_output=True, text=True, timeout=60)

    assert tested().returncode == 0, tested().stderr
    main = team / "main.py"
    good = main.read_text()
    main.write_text(good.replace("kelpie.KICK_FORWARD", "kelpie.NO_MOTION"))
    failed = tested()
    main.write_text(good)
    assert "test_a_ball_before_the_paws_is_kicked" in failed.stderr and failed.returncode == 1


def test_it_walks_to_the_ball_and_kicks(team, tmp_path):
    played = kelpie("play", "--fast", "--pycode", team, "--seed", "2", "--seconds", "20",
                    "--no-film", "--out", tmp_path)
    assert played.returncode == 0 and "behaviour:" not in played.stderr, played.stderr
    said = kelpie("replay", tmp_path / "match.mcap", "--pycode", team, "--jsonl", "-").stdout
    assert '"motion":3' in said  # KICK_FORWARD


def test_it_plays_a_match_and_a_league_as_a_side(team, tmp_path):
    words = ["--robots", "1v1", "--fast", "--percepts", "--minutes", "0.1"]
    played = kelpie("play", *words, "--red", team, "--no-film", "--out", tmp_path / "match")
    assert played.returncode == 0 and "behaviour:" not in played.stderr, played.stderr
    league = kelpie("league", team, ROOT / "teams/thesis", *words, "--matches", "2", "--out",
                    tmp_path / "league")
    assert league.returncode == 0 and "foxes" in league.stdout, league.stderr


@pytest.mark.parametrize("name", ["full", "file"])
def test_what_is_there_is_left_alone_with_one_line(name, tmp_path):
    (tmp_path / "full").mkdir()
    (tmp_path / "full/mine.py").write_text("precious\n")
    (tmp_path / "file").write_text("precious\n")
    result = kelpie("new-team", tmp_path / name)
    assert result.returncode == 2
    assert complaint(result) == f"kelpie: {tmp_path / name}: is there already, and no empty folder"
    assert [path.name for path in (tmp_path / "full").iterdir()] == ["mine.py"]


def test_an_empty_folder_is_taken_and_one_that_cannot_be_made_is_refused(tmp_path):
    (tmp_path / "empty").mkdir()
    assert kelpie("new-team", tmp_path / "empty").returncode == 0
    assert (tmp_path / "empty/main.py").is_file()
    result = kelpie("new-team", "/proc/none/team")
    assert result.returncode == 3 and complaint(result)
