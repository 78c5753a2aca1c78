# SPDX-License-Identifier: Apache-2.0
"""Matches of two teams, as a user asks for them, and what becomes of them when something breaks."""

import json
import math
import os
import re
import select
import shutil
import signal
import socket
import subprocess
import threading
import time

import pytest
from conftest import BIN, PLANE, ROOT, agent, complaint, kelpie, on_a_terminal

# They stand before the whistle, so that no kick-off waits for them.
SPEAKS = """import kelpie


def decide(world):
    note = kelpie.TeamNote(role=kelpie.STRIKER, time_to_ball=float(world.game.player))
    turn = 40.0 if world.game.state == kelpie.PLAYING else 0.0
    return kelpie.Command(team=note, walk=kelpie.WalkRequest(turn_deg=turn))
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
    reported = kelpie("replay", log, "--jsonl", "-").stdout
    return [json.loads(line) for line in reported.splitlines()]


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


def test_a_script_that_fails_is_reported_once_and_its_robots_stand(tmp_path, team):
    (team / "main.py").write_text(BREAKS)
    result = match(team, tmp_path / "out", seconds="2")
    assert result.returncode == 0, result.stderr
    reported = [line for line in result.stderr.splitlines() if "a skill that fails" in line]
    assert len(reported) == 4, result.stderr  # once of each robot


def test_the_logs_of_all_robots_hold_class_planes_and_keep_within_their_budget(tmp_path):
    out = tmp_path / "out"
    result = kelpie("play", "--robots", "2v2", "--fast", "--seconds", "2", "--no-film", "--logs",
                    "all", "--out", out)
    assert result.returncode == 0, result.stderr
    logs = sorted(out.glob("*.mcap"))
    assert [log.name for log in logs] == ["blue-1.mcap", "blue-2.mcap", "match.mcap", "red-1.mcap"]
    for log in logs:
        topics = topics_of(log)
        seconds = topics["/frame/output"] / 30
        assert topics["/frame/plane"] == math.ceil(topics["/frame/output"] / 15)
        assert topics["/frame/plane"] + topics["/frame/picture"] == topics["/frame/output"]
        # 150 MB for eight robots in 14 minutes, in which there are ten of play; what a log begins
        # with comes once: the configuration and the message types.
        assert log.stat().st_size < 100_000 + 150e6 / 8 * seconds / (14 * 60)
        reported = frames(log)
        assert len(reported) == topics["/frame/output"] and reported[-1]["command"]["trace"]
        assert reported[-1]["truth"]["x_cm"] > -50
    assert kelpie("show", logs[0], "--frame", 30, "--out", tmp_path / "f.png").returncode == 0
    refused = kelpie("show", logs[0], "--frame", 31, "--out", tmp_path / "f.png")
    assert "keeps no image of frame 31; it does of 30 and 45" in complaint(refused)
    assert "do not replay" in complaint(kelpie("replay", logs[0], "--check"))
    assert kelpie("why", logs[0], "--at", 4).returncode == 0


def topics_of(log):
    """{topic: number of messages}"""
    lines = kelpie("info", log).stdout.splitlines()
    return {words[0]: int(words[2]) for words in map(str.split, lines) if words[0][0] == "/"}


def test_a_ball_that_is_taken_away_comes_back_and_play_goes_on(tmp_path):
    result = match_of_ours(tmp_path / "out", "--take-ball", "8:3:100,200", "--images", "planes")
    assert result.returncode == 0, result.stderr
    assert "8.0 s: the ball is taken away" in result.stderr
    assert "11.0 s: the ball is back at (100, 200)" in result.stderr
    reported = frames(tmp_path / "out/match.mcap")
    assert reported[-1]["t_s"] > 20
    assert {frame["command"]["fallback"] for frame in reported} == {0}, "no script failed"


def match_of_ours(out, *words):
    return kelpie("play", "--robots", "1v1", "--fast", "--seconds", "12", "--no-film", "--seed",
                  "11", "--out", out, *words)


def test_a_robot_that_is_carried_off_knows_where_it_is_within_20_s(tmp_path):
    result = kelpie("play", "--robots", "1v1", "--fast", "--seconds", "14", "--no-film", "--seed",
                    "11", "--images", "planes", "--carry", "26:red:1:300,90,90", "--out",
                    tmp_path / "out")
    assert result.returncode == 0, result.stderr
    carried = re.search(r"^([\d.]+) s: red 1 is carried to \(300, 90\)$", result.stderr, re.M)
    assert carried, result.stderr
    at = float(carried[1])

    def error(frame):
        return math.dist(*[[frame[key][axis] for axis in ("x_cm", "y_cm")]
                           for key in ("pose", "truth")])

    reported = frames(tmp_path / "out/match.mcap")
    assert any(error(frame) > 200 for frame in reported if at < frame["t_s"] < at + 1)
    found = [error(frame) for frame in reported if at + 19 < frame["t_s"] < at + 20]
    assert found and min(found) < 50


STATES = """import kelpie


def decide(world):
    return kelpie.Command(team=kelpie.TeamNote(time_to_ball=float(world.game.state)))
"""


def test_after_a_goal_there_is_a_kick_off_again_and_play_goes_on(team, tmp_path):
    (team / "main.py").write_text(STATES)
    result = match(team, tmp_path / "out", "--throw", "14:180,500,0,250", "--images", "planes",
                   robots="1v0", seconds="16")
    assert result.returncode == 0, result.stderr
    assert "GOAL of red after 14." in result.stderr and "red 1 : 0 blue" in result.stdout
    states = [frame["command"]["team"]["time_to_ball_s"]
              for frame in frames(tmp_path / "out/match.mcap")]
    changes = [b for a, b in zip([None] + states, states) if a != b]
    assert changes[:8] == [0, 1, 2, 3, 1, 2, 3, 0], "initial, ready, set, playing; after a goal"


def test_when_the_world_dies_all_end_with_one_line_and_whole_logs(team, tmp_path):
    play = started(team, tmp_path / "out", tmp_path, "--logs", "all", "--respawn")
    agents = agents_of(play)
    listing = subprocess.run(["pgrep", "-P", str(play.pid), "kelpie-world"], capture_output=True,
                             text=True, check=False).stdout.split()
    os.kill(int(listing[0]), signal.SIGKILL)
    _, errors = play.communicate(timeout=30)
    assert play.returncode == 3
    reported = [line for line in errors.splitlines() if line.startswith("kelpie: ")]
    assert len(reported) == 1 and "the world died (signal 9)" in reported[0], errors
    assert not any(os.path.exists(f"/proc/{pid}") for pid in agents.values())
    for name in ("match", "red-1", "blue-1", "blue-2"):
        log = tmp_path / "out" / f"{name}.mcap"
        assert kelpie("info", log).returncode == 0 and frames(log)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out", "team"]


def spoil(path):
    text = path.read_text()
    begun = "def decide(world) -> kelpie.Command:\n"
    assert begun in text
    path.write_text(text.replace(begun, begun + "    if world.game.player == 2:\n"
                                        "        raise ValueError('a skill that fails')\n"))
    return text


def test_a_script_mended_while_the_match_goes_on_plays_again(tmp_path):
    ours = tmp_path / "team"
    shutil.copytree(ROOT / "pycode", ours, ignore=shutil.ignore_patterns("__pycache__"))
    play = started(ours, tmp_path / "out", tmp_path, "--images", "planes")
    whole = spoil(ours / "main.py")
    time.sleep(3.0)
    (ours / "main.py").write_text(whole)
    time.sleep(3.0)
    _, errors = interrupted(play)
    lines = [line for line in errors.splitlines() if "a skill that fails" in line]
    assert len(lines) == 2, errors  # once of each team's number 2, for both use the folder
    assert any("blue 2" in line for line in lines)
    reported = [frame["command"]["fallback"] for frame in frames(tmp_path / "out/match.mcap")]
    failed = [i for i, fallback in enumerate(reported) if fallback == 2]
    assert failed and failed[0] > 0 and not any(reported[failed[-1] + 1:])
    assert len(reported) - failed[-1] > 10 and failed[-1] - failed[0] + 1 == len(failed)


def test_on_a_terminal_one_line_tells_how_far_the_match_is(team, tmp_path):
    (team / "main.py").write_text(STATES)  # they stand, so that a kick-off does not wait
    began = time.monotonic()
    seen, code = on_a_terminal("play", "--robots", "1v1", "--fast", "--red", team, "--blue", team,
                               "--seconds", "60", "--no-film", "--out", tmp_path / "out")
    assert code == 0
    lines = re.findall(rb"\r\x1b\[K(\d:\d\d) of 1:00  (first|second) half, (\w+)  red 0 : 0 blue  "
                       rb"[\d.]+ x real time", seen)
    assert lines and (lines[0][1], lines[-1][1]) == (b"first", b"second")
    assert len(lines) <= 2 * (time.monotonic() - began) + 1


def started(team, out, tmp_path, *words):
    play = subprocess.Popen([BIN / "kelpie", "play", "--robots", "2v2", "--fast", "--red", team,
                             "--blue", team, "--seconds", "3000", "--no-film", "--out", out,
                             *words], stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                            cwd=ROOT, env=dict(os.environ, TMPDIR=str(tmp_path)))
    for _ in range(100):
        if len(agents_of(play)) == 4:
            break
        time.sleep(0.1)
    log = out / "playing/match.mcap"
    for _ in range(300):  # until it holds more than what it begins with
        if log.exists() and log.stat().st_size > 330_000:
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
        if len(option) < 2:  # just killed: it has no words any more
            continue
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
    killed = time.monotonic()
    while agents_of(play).get(robot, first) == first and time.monotonic() - killed < 5:
        time.sleep(0.05)
    assert agents_of(play).get(robot, first) != first and time.monotonic() - killed < 5
    time.sleep(1.0)
    assert len(agents_of(play)) == 4
    _, errors = interrupted(play)
    assert "it is started again" in errors and "is there again" in errors, errors
    assert frames(tmp_path / "out/match.mcap")
    assert (tmp_path / "out/match-2.mcap").exists() is (robot == ("red", 2))
    assert robot != ("red", 2) or frames(tmp_path / "out/match-2.mcap")


@pytest.mark.parametrize("robot", [("blue", 1), ("red", 2)])
def test_an_agent_that_comes_back_while_its_script_is_broken_waits_for_it(robot, team, tmp_path):
    whole = (team / "main.py").read_text()
    play = started(team, tmp_path / "out", tmp_path, "--respawn", "--images", "planes")
    (team / "main.py").write_text(whole + "\nbroken = (\n")
    time.sleep(1.0)
    os.kill(agents_of(play)[robot], signal.SIGKILL)
    time.sleep(3.0)
    assert len(agents_of(play)) == 4 and play.poll() is None
    (team / "main.py").write_text(whole)
    time.sleep(3.0)
    _, errors = interrupted(play)
    assert play.returncode == 130 and "is there again" in errors
    reported = frames(tmp_path / "out" / ("match-2.mcap" if robot == ("red", 2) else "match.mcap"))
    assert reported[-1]["command"]["fallback"] == 0
    assert robot != ("red", 2) or reported[0]["command"]["fallback"] == 1  # not loaded


def test_without_respawn_the_match_ends_with_one_line_and_a_whole_log(team, tmp_path):
    play = started(team, tmp_path / "out", tmp_path)
    os.kill(agents_of(play)["red", 1], signal.SIGKILL)
    _, errors = play.communicate(timeout=60)
    assert play.returncode == 3 and "the mate red 1 died (signal 9)" in errors
    assert frames(tmp_path / "out/match.mcap")


def test_an_interrupted_match_leaves_log_and_nothing_else_behind(team, tmp_path):
    play = started(team, tmp_path / "out", tmp_path)
    interrupted(play)
    assert frames(tmp_path / "out/match.mcap")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out", "team"]


@pytest.mark.parametrize("words, reported", [
    (["--robots", "5v4"], "'5v4': teams are written as 4v4"),
    (["--robots", "0v0"], "'0v0': teams are written as 4v4"),
    (["--red", "docs"], "'docs': holds neither main.py nor team.toml"),
    (["--robots", "4v4", "--minutes", "0"], "minutes"),
    (["--robots", "4v4", "--radio", "morse"], "morse"),
    (["--robots", "4v4", "--opponent", "goalie"], "--opponent"),
    (["--robots", "2v2", "--place", "red:3:1,2,3"], "no red 3 is there"),
    (["--robots", "2v2", "--take-ball", "soon"], "'soon': the ball is taken away at T, T:SECONDS"),
    (["--robots", "2v2", "--take-ball", "9:3:400,10"], "the ball at (400, 10) is off the field"),
    (["--robots", "2v2", "--carry", "9:red:1"], "'9:red:1': a robot is carried at T:TEAM:PLAYER"),
    (["--robots", "2v2", "--carry", "9:red:4:1,2,3"], "no red 4 is there to be carried"),
    (["--robots", "2v2", "--carry", "9:red:1:-9,2,3"], "red 1 at (-9, 2) is off the field"),
    (["--robots", "2v2", "--logs", "some"], "--logs"),
])
def test_what_is_no_match_is_refused_in_one_line(words, reported, tmp_path):
    result = kelpie("play", *words, "--out", tmp_path / "out")
    assert result.returncode == 2
    assert reported in complaint(result) and result.stderr.count("\n") == 1
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
    assert result.stderr.startswith("2 of 2 matches to play, ")
    for name in ("table.txt", "table.html", "table.png", "league.jsonl"):
        assert (tmp_path / "league" / name).stat().st_size > 0
    again = league(tmp_path, team)
    assert again.returncode == 0 and again.stderr == ""
    shown = kelpie("league", "--out", tmp_path / "league", "--table")
    assert shown.returncode == 0 and "other" in shown.stdout


def test_a_league_says_once_that_a_teams_behaviours_fail(team, tmp_path):
    (team / "main.py").write_text(BREAKS)
    result = league(tmp_path, team)
    assert result.returncode == 0, result.stderr
    assert result.stderr.count("a skill that fails") == 1 and "team - other" in result.stderr


def test_a_league_with_void_matches_ends_with_1_each_time(team, tmp_path):
    (team / "main.py").write_text("def decide(world)\n")
    for _ in range(2):
        result = league(tmp_path, team)
        assert result.returncode == 1 and "2 of 2 matches are void" in result.stderr


def test_a_league_with_other_behaviours_is_another_league(team, tmp_path):
    assert league(tmp_path, team).returncode == 0
    (team / "main.py").write_text(SPEAKS + "\n")
    result = league(tmp_path, team)
    assert result.returncode == 2 and complaint(result)


@pytest.mark.parametrize("words, reported", [
    ([], "two teams"), (["docs"], "'docs': holds neither main.py nor team.toml"),
    (["teams/thesis", "--robots", "9v9"], "'9v9': teams are written as 4v4")])
def test_what_is_no_league_is_refused_before_anything_is_written(words, reported, team, tmp_path):
    result = kelpie("league", team, *words, "--out", tmp_path / "league")
    assert result.returncode == 2 and reported in complaint(result)
    assert not (tmp_path / "league").exists()


def relay(near, far, bytes_to_carry):
    """Carries a connection of an agent to the world until so many bytes have come from the world,
    then cuts it on both sides."""
    listener = socket.socket(socket.AF_UNIX)
    listener.bind(str(near))
    listener.listen(1)

    def carry():
        agent, _ = listener.accept()
        world = socket.socket(socket.AF_UNIX)
        world.connect(str(far))
        carried = 0
        while carried < bytes_to_carry:
            for one in select.select([agent, world], [], [], 30)[0]:
                data = one.recv(1 << 16)
                (world if one is agent else agent).sendall(data)
                carried += len(data) if one is world else 0
        for end in (agent, world, listener):
            end.close()

    thread = threading.Thread(target=carry, daemon=True)
    thread.start()
    return thread


def test_a_world_and_an_agent_whose_socket_is_cut_end_with_one_line_each_and_whole_logs(tmp_path):
    world = subprocess.Popen([BIN / "kelpie-world", "--socket", tmp_path / "world", "--seconds",
                              "60", "--truth", tmp_path / "truth.mcap"],
                             stderr=subprocess.PIPE, text=True)
    deadline = time.monotonic() + 20
    while not (tmp_path / "world").exists() and time.monotonic() < deadline:
        time.sleep(0.02)
    thread = relay(tmp_path / "relay", tmp_path / "world", 60 * 3 * PLANE)
    player = agent("--socket", tmp_path / "relay", "--log", tmp_path / "agent.mcap")
    thread.join(timeout=30)
    _, said = world.communicate(timeout=30)
    assert world.returncode != 0 and player.returncode != 0
    for errors in (said, player.stderr):
        assert len(errors.strip().splitlines()) == 1, errors
    for log in ("truth.mcap", "agent.mcap"):
        assert kelpie("info", tmp_path / log).returncode == 0
    assert len(frames(tmp_path / "agent.mcap")) > 30
