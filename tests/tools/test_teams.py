# SPDX-License-Identifier: Apache-2.0
"""Matches of two teams, as a user asks for them, and what becomes of them when something breaks."""

import json
import os
import signal
import subprocess
import time

import pytest
from conftest import BIN, ROOT, complaint, kelpie

SPEAKS = """import kelpie


def decide(world):
    note = kelpie.TeamNote(role=kelpie.STRIKER, time_to_ball=float(world.game.player))
    return kelpie.Command(team=note, walk=kelpie.WalkRequest(turn_deg=40.0))
"""
BREAKS = """import kelpie


def decide(world):
    if world.game.state == kelpie.PLAYING:
        raise ValueError('a skill that fails')
    return kelpie.Command()
"""


@pytest.fixture
def team(tmp_path):
    folder = tmp_path / "team"
    folder.mkdir()
    (folder / "main.py").write_text(SPEAKS)
    return folder


def match(team, out, *words, robots="2v2", seconds="4"):
    return kelpie("play", "--robots", robots, "--fast", "--red", team, "--blue", team, "--seconds",
                  seconds, "--no-film", "--out", out, *words)


def frames(log):
    told = kelpie("replay", log, "--jsonl", "-").stdout
    return [json.loads(line) for line in told.splitlines()]


def test_a_match_by_the_rules_ends_well_without_a_goal_and_tells_the_score(team, tmp_path):
    result = match(team, tmp_path / "out")
    assert result.returncode == 0, result.stderr
    assert "red 0 : 0 blue" in result.stdout
    assert (tmp_path / "out/match.png").exists()


def test_mates_hear_what_behaviours_tell_and_a_replay_gives_the_same(team, tmp_path):
    match(team, tmp_path / "out")
    log = tmp_path / "out/match.mcap"
    heard = [mate for frame in frames(log) for mate in frame["teammates"]]
    assert heard and {mate["player"] for mate in heard} == {1}
    assert heard[-1]["note"]["role"] == 3
    assert kelpie("replay", log, "--check", "--pycode", team).returncode == 0


def test_the_same_seed_is_the_same_match_losses_of_the_radio_included(team, tmp_path):
    logs = []
    for name in ("a", "b"):
        match(team, tmp_path / name, "--seed", "5")
        logs.append(kelpie("replay", tmp_path / name / "match.mcap", "--jsonl", "-").stdout)
    assert logs[0] == logs[1] and logs[0].count("\n") > 300


def test_a_team_without_radio_plays_on_and_hears_nobody(team, tmp_path):
    assert match(team, tmp_path / "out", "--radio", "none").returncode == 0
    assert not any(frame["teammates"] for frame in frames(tmp_path / "out/match.mcap"))


def test_teams_are_heard_by_sockets_of_this_machine_too(team, tmp_path):
    assert match(team, tmp_path / "out", "--radio", "udp").returncode == 0
    assert any(frame["teammates"] for frame in frames(tmp_path / "out/match.mcap"))


def test_a_script_that_fails_is_told_once_and_its_robots_stand(tmp_path, team):
    (team / "main.py").write_text(BREAKS)
    result = match(team, tmp_path / "out", seconds="2")
    assert result.returncode == 0, result.stderr
    told = [line for line in result.stderr.splitlines() if "a skill that fails" in line]
    assert len(told) == 4, result.stderr  # once of each robot


def started(team, out, tmp_path, *words):
    play = subprocess.Popen([BIN / "kelpie", "play", "--robots", "2v2", "--fast", "--red", team,
                             "--blue", team, "--seconds", "3000", "--no-film", "--out", out,
                             *words], stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                            cwd=ROOT, env=dict(os.environ, TMPDIR=str(tmp_path)))
    for _ in range(100):
        if len(agents_of(play)) == 4:
            break
        time.sleep(0.1)
    time.sleep(1.5)
    return play


def agents_of(play):
    """The processes of the robots: ("red", 2) -> pid."""
    listing = subprocess.run(["pgrep", "-a", "-P", str(play.pid), "kelpie-agent"],
                             capture_output=True, text=True, check=False).stdout.splitlines()
    agents = {}
    for line in listing:
        words = line.split()
        option = {a: b for a, b in zip(words, words[1:]) if a in ("--team", "--player")}
        agents[option["--team"], int(option["--player"])] = int(words[0])
    return agents


def interrupted(play):
    play.send_signal(signal.SIGINT)
    return play.communicate(timeout=60)


@pytest.mark.parametrize("robot", [("red", 1), ("blue", 2), ("red", 2)])
def test_an_agent_that_is_killed_comes_back_and_the_log_is_whole(robot, team, tmp_path):
    play = started(team, tmp_path / "out", tmp_path, "--respawn")
    first = agents_of(play)[robot]
    os.kill(first, signal.SIGKILL)
    for _ in range(50):
        time.sleep(0.1)
        if agents_of(play).get(robot, first) != first:
            break
    assert agents_of(play)[robot] != first
    time.sleep(1.0)
    assert len(agents_of(play)) == 4
    _, errors = interrupted(play)
    assert "it is started again" in errors and "is there again" in errors, errors
    assert frames(tmp_path / "out/match.mcap")
    assert (tmp_path / "out/match-2.mcap").exists() is (robot == ("red", 2))
    assert robot != ("red", 2) or frames(tmp_path / "out/match-2.mcap")


def test_without_respawn_the_match_ends_with_one_line_and_a_whole_log(team, tmp_path):
    play = started(team, tmp_path / "out", tmp_path)
    os.kill(agents_of(play)["red", 1], signal.SIGKILL)
    _, errors = play.communicate(timeout=60)
    assert play.returncode == 1 and "the mate red 1 died (signal 9)" in errors
    assert frames(tmp_path / "out/match.mcap")


def test_an_interrupted_match_leaves_log_and_nothing_else_behind(team, tmp_path):
    play = started(team, tmp_path / "out", tmp_path)
    interrupted(play)
    assert frames(tmp_path / "out/match.mcap")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out", "team"]


@pytest.mark.parametrize("words, told", [
    (["--robots", "5v4"], "'5v4': teams are written as 4v4"),
    (["--robots", "0v0"], "'0v0': teams are written as 4v4"),
    (["--red", "docs"], "'docs': holds neither main.py nor team.toml"),
    (["--robots", "4v4", "--minutes", "0"], "minutes"),
    (["--robots", "4v4", "--radio", "morse"], "morse"),
    (["--robots", "4v4", "--opponent", "goalie"], "--opponent"),
    (["--robots", "2v2", "--place", "red:3:1,2,3"], "no red 3 is there"),
])
def test_what_is_no_match_is_refused_in_one_line(words, told, tmp_path):
    result = kelpie("play", *words, "--out", tmp_path / "out")
    assert result.returncode == 2
    assert told in complaint(result) and result.stderr.count("\n") == 1
    assert not (tmp_path / "out").exists()


def league(tmp_path, team, *words):
    other = tmp_path / "other"
    other.mkdir(exist_ok=True)
    (other / "main.py").write_text(SPEAKS)
    return kelpie("league", team, other, "--out", tmp_path / "league", "--matches", "2",
                  "--minutes", "0.1", "--robots", "1v1", *words)


def test_a_league_plays_every_seed_in_both_colours_and_goes_on_where_it_was(team, tmp_path):
    result = league(tmp_path, team)
    assert result.returncode == 0, result.stderr
    assert "2/2" in result.stderr and "other" in result.stdout
    for name in ("table.txt", "table.html", "table.png", "league.jsonl"):
        assert (tmp_path / "league" / name).stat().st_size > 0
    again = league(tmp_path, team)
    assert again.returncode == 0 and "2/2" not in again.stderr
    shown = kelpie("league", "--out", tmp_path / "league", "--table")
    assert shown.returncode == 0 and "other" in shown.stdout


def test_a_league_with_other_behaviours_is_another_league(team, tmp_path):
    assert league(tmp_path, team).returncode == 0
    (team / "main.py").write_text(SPEAKS + "\n")
    result = league(tmp_path, team)
    assert result.returncode == 2 and complaint(result)


@pytest.mark.parametrize("words, told", [
    ([], "two teams"), (["docs"], "'docs': holds neither main.py nor team.toml"),
    (["teams/thesis", "--robots", "9v9"], "'9v9': teams are written as 4v4")])
def test_what_is_no_league_is_refused_before_anything_is_written(words, told, team, tmp_path):
    result = kelpie("league", team, *words, "--out", tmp_path / "league")
    assert result.returncode == 2 and told in complaint(result)
    assert not (tmp_path / "league").exists()
