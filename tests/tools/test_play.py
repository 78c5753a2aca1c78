# SPDX-License-Identifier: Apache-2.0
"""What a match leaves and tells: goals as they fall, files in proportion, films that can be
interrupted, and logs whose images were not all kept."""

import json
import os
import re
import signal
import subprocess
import time

import pytest
from conftest import BIN, ROOT, agent, complaint, kelpie, on_a_terminal


@pytest.fixture(scope="session")
def long_match(tmp_path_factory):
    """22 simulated seconds: the images of the last two are pictures only."""
    out = tmp_path_factory.mktemp("long")
    result = kelpie("play", "--seconds", "22", "--goals", "99", "--seed", "4", "--out", out,
                    "--no-film")
    assert (out / "match.mcap").exists(), result.stderr
    return out / "match.mcap"


def topics_of(log):
    """{topic: number of messages}"""
    lines = kelpie("info", log).stdout.splitlines()
    return {words[0]: int(words[2]) for words in map(str.split, lines) if words[0][0] == "/"}


def start_match(out, *words, tmp, **options):
    return subprocess.Popen([BIN / "kelpie", "play", "--out", out, *words], cwd=ROOT, text=True,
                            env=dict(os.environ, TMPDIR=str(tmp)), stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, **options)


def test_the_last_line_tells_every_goal_and_the_others_what_each_file_is(tmp_path):
    result = kelpie("play", "--fast", "--seconds", "90", "--goals", "2", "--seed", "7", "--out",
                    tmp_path)
    assert result.returncode == 0, result.stderr
    *files, last = result.stdout.splitlines()
    goals = re.fullmatch(r"GOAL after ([\d.]+), ([\d.]+) s \(seed 7, ([\d.]+) simulated seconds in "
                         r"[\d.]+ s\)", last)
    assert goals and float(goals[1]) < float(goals[2]) <= float(goals[3])
    assert [line.split(": ")[0] for line in files] == [
        str(tmp_path / name) for name in ("match.png", "match.mp4", "match.mcap")]
    assert "--images all" in files[2]
    assert result.stderr.startswith("playing: seed 7")  # in a pipe: when it begins ...
    reported = re.findall(r"^GOAL after ([\d.]+) s$", result.stderr, re.M)
    assert reported == [goals[1], goals[2]] and "own goal" not in result.stderr
    assert re.search(r"film: \d+ frames\nfilm: (\d+) of \1 frames in \d+ s\n$", result.stderr)


def test_the_log_of_a_longer_match_is_small_and_replays_with_the_same_bits(long_match):
    topics = topics_of(long_match)
    assert topics["/frame/input"] == 600 and topics["/frame/picture"] == 60
    result = kelpie("replay", long_match, "--check")
    assert result.returncode == 0, result.stderr
    assert "660 frames" in result.stdout and ", 0 differ" in result.stdout
    assert "vision ran again on 600 frames" in result.stdout


def test_other_parameters_are_noticed_on_frames_without_images(long_match, tmp_path):
    params = tmp_path / "p.toml"
    params.write_text("[gps.gates]\nmaxHeadingSd = '1deg'\n")
    result = kelpie("replay", long_match, "--check", "--params", params)
    assert result.returncode == 1, result.stdout + result.stderr


def test_frames_without_images_can_be_shown_filmed_and_compressed(long_match, tmp_path):
    assert kelpie("show", long_match, "--frame", 659, "--out", tmp_path / "f.png").returncode == 0
    assert kelpie("film", long_match, tmp_path / "f.mp4").returncode == 0
    assert kelpie("compress", long_match, "--out", tmp_path / "c.mcap").returncode == 0
    assert topics_of(tmp_path / "c.mcap")["/frame/plane"] == 660
    assert kelpie("replay", tmp_path / "c.mcap", "--check").returncode == 0


def test_a_log_without_all_images_cannot_go_through_the_camera_again(long_match, tmp_path):
    result = agent("--recording", long_match, "--log", tmp_path / "again.mcap")
    assert result.returncode == 1
    assert "--images all" in result.stderr


def test_all_images_are_kept_on_request(tmp_path):
    kelpie("play", "--seconds", "21", "--goals", "99", "--seed", "4", "--out", tmp_path,
           "--no-film", "--images", "all")
    topics = topics_of(tmp_path / "match.mcap")
    assert topics["/frame/input"] == 630 and "/frame/picture" not in topics


def test_an_interrupted_film_ends_at_once_and_keeps_log_and_picture(tmp_path):
    out = tmp_path / "out"
    play = start_match(out, "--fast", "--seconds", "90", "--goals", "99", tmp=tmp_path)
    for line in play.stderr:
        if line.startswith("film: "):
            break
    before = time.monotonic()
    play.send_signal(signal.SIGINT)
    said, errors = play.communicate(timeout=30)
    assert time.monotonic() - before < 10  # a film of 90 s takes longer; it should be one second
    assert sorted(p.name for p in out.iterdir()) == ["match.mcap", "match.png"]
    assert "the film was left out; kelpie film" in said
    assert kelpie("replay", out / "match.mcap", "--check").returncode == 0


def test_a_film_by_hand_leaves_nothing_when_it_is_interrupted(long_match, tmp_path):
    film = subprocess.Popen([BIN / "kelpie", "film", long_match, tmp_path / "f.mp4"],
                            stderr=subprocess.PIPE, text=True)
    film.stderr.readline()
    film.send_signal(signal.SIGINT)
    _, errors = film.communicate(timeout=30)
    assert film.returncode == 130 and "interrupted" in errors
    assert list(tmp_path.iterdir()) == []


def test_a_match_in_real_time_goes_on_until_it_is_stopped(tmp_path):
    out, began = tmp_path / "out", time.monotonic()
    play = start_match(out, "--real-time", "--no-film", tmp=tmp_path)
    log = out / "playing/match.mcap"
    while time.monotonic() < began + 60 and not (log.exists() and log.stat().st_size > 5_000_000):
        time.sleep(0.1)  # a second has thirty images of 100 KB
    assert play.poll() is None
    play.send_signal(signal.SIGINT)
    lasted = time.monotonic() - began
    said, errors = play.communicate(timeout=30)
    assert play.returncode == 0, errors
    played = float(re.search(r"([\d.]+) simulated seconds", said)[1])
    assert 1.0 < played < lasted + 0.5  # no faster than a clock
    assert [p.name for p in tmp_path.iterdir()] == ["out"]


def agent_of(play):
    for _ in range(100):
        listing = subprocess.run(["pgrep", "-P", str(play.pid), "kelpie-agent"],
                                 capture_output=True, text=True, check=False).stdout.split()
        if listing:
            return int(listing[0])
        time.sleep(0.1)
    raise AssertionError("no agent started")


def test_an_agent_that_does_not_answer_is_killed_after_an_interrupt(tmp_path):
    out = tmp_path / "out"
    play = start_match(out, "--real-time", "--no-film", tmp=tmp_path)
    os.kill(agent_of(play), signal.SIGSTOP)
    play.send_signal(signal.SIGINT)
    _, errors = play.communicate(timeout=60)
    assert play.returncode == 130 and "interrupted" in errors
    assert [p.name for p in tmp_path.iterdir()] == ["out"]


def test_goals_come_while_the_match_goes_on(tmp_path):
    play = start_match(tmp_path / "out", "--seed", "7", "--seconds", "600", "--goals", "99",
                       "--no-film", tmp=tmp_path)
    assert play.stderr.readline().startswith("playing")
    assert play.stderr.readline().startswith("GOAL after ")
    assert play.poll() is None
    play.send_signal(signal.SIGINT)
    said, _ = play.communicate(timeout=60)
    assert "GOAL after" in said and play.returncode == 130


def test_an_interrupted_compress_leaves_nothing(long_match, tmp_path):
    command = subprocess.Popen([BIN / "kelpie", "compress", long_match, "--out",
                                tmp_path / "c.mcap"], stderr=subprocess.PIPE, text=True)
    while command.poll() is None and not (tmp_path / "c.mcap.part").exists():
        time.sleep(0.01)
    command.send_signal(signal.SIGINT)
    _, errors = command.communicate(timeout=30)
    assert command.returncode == 2 and errors.count("interrupted") == 1
    assert list(tmp_path.iterdir()) == []


def folders_of_matches(tmp):
    return sorted(p for p in tmp.iterdir() if p.name.startswith("kelpie-play-"))


def test_killed_match_is_cleaned_up_by_the_next_and_a_running_one_is_spared(tmp_path):
    tmp = tmp_path / "t"  # short: it holds sockets
    tmp.mkdir()
    plays = [start_match(tmp_path / name, "--real-time", "--no-film", tmp=tmp)
             for name in ("killed", "running")]
    for play in plays:
        agent_of(play)  # both have begun
    assert len(folders_of_matches(tmp)) == 2
    plays[0].kill()
    plays[0].communicate(timeout=20)
    assert len(folders_of_matches(tmp)) == 2
    (tmp_path / "next").mkdir()
    (tmp_path / "next" / "match.mcap.part").write_bytes(b"half a log")
    own = tmp / "kelpie-play-mine"  # a user's folder
    own.mkdir()
    (own / "notes").write_text("of a match")
    for folder in folders_of_matches(tmp):
        os.utime(folder, (1e9, 1e9))  # as if it were old enough
    result = kelpie("play", "--seconds", "2", "--no-film", "--out", tmp_path / "next",
                    env=dict(os.environ, TMPDIR=str(tmp)))
    assert "no goal" in result.stdout, result.stderr
    assert len(folders_of_matches(tmp)) == 2 and plays[1].poll() is None
    plays[1].terminate()
    plays[1].communicate(timeout=60)
    assert folders_of_matches(tmp) == [own] and (own / "notes").exists()
    assert not list((tmp_path / "next").glob("*.part*"))


def test_frames_that_the_agent_never_got_are_counted_by_the_cameras_numbers(tmp_path):
    result = kelpie("play", "--seconds", "6", "--seed", "3", "--drop-rate", "0.2", "--no-film",
                    "--out", tmp_path)
    log = tmp_path / "match.mcap"
    frames = [json.loads(line) for line in
              kelpie("replay", log, "--jsonl", "-").stdout.splitlines()]
    dropped = [frame["dropped_frames"] for frame in frames]
    assert dropped == sorted(dropped) and dropped[0] == 0, result.stderr
    # 180 images in 6 s; those before the first and behind the last that came are nobody's loss.
    assert 175 <= len(frames) + dropped[-1] <= 180 and 20 <= dropped[-1] <= 55
    info = re.search(r"^(\d+) camera frames, (\d+) more dropped", kelpie("info", log).stdout, re.M)
    assert [int(info[1]), int(info[2])] == [len(frames), dropped[-1]]
    gaps = [(b["t_s"] - a["t_s"]) * 30 for a, b in zip(frames, frames[1:])]
    assert [round(g) - 1 for g in gaps] == [b - a for a, b in zip(dropped, dropped[1:])]


def test_a_folder_that_cannot_be_written_is_reported_before_the_match(tmp_path):
    (tmp_path / "out").mkdir()
    (tmp_path / "out/match.mcap").mkdir()
    result = kelpie("play", "--seconds", "5", "--out", tmp_path / "out")
    assert result.returncode == 2
    assert "cannot be written" in complaint(result) and "playing:" not in result.stderr


def test_on_a_terminal_the_line_is_alive(tmp_path):
    seen, _ = on_a_terminal("play", "--seconds", "3", "--no-film", "--out", tmp_path)
    assert seen.count(b"\r\x1b[K0:0  ") >= 4  # score and belief, twice a simulated second


def test_on_a_terminal_a_film_tells_how_long_it_will_take(long_match, tmp_path):
    seen, _ = on_a_terminal("film", long_match, tmp_path / "f.mp4")
    assert re.search(rb"\r\x1b\[Kfilm: \d+ of 660 frames, \d+ s left", seen)
    assert re.search(rb"\r\x1b\[Kfilm: 660 of 660 frames in \d+ s\r\n$", seen)


def test_json_lines_go_on_where_images_were_not_kept(long_match):
    result = kelpie("replay", long_match, "--jsonl", "-")
    frames = [json.loads(line)["frame"] for line in result.stdout.splitlines()]
    assert frames == list(range(660))


@pytest.mark.parametrize("field", ["2006", "osaka2005", "2004"])
def test_the_robot_scores_on_every_field(field, tmp_path):
    result = kelpie("play", "--field", field, "--seed", "6", "--seconds", "90", "--no-film",
                    "--out", tmp_path)
    assert result.returncode == 0, result.stdout + result.stderr


def test_a_field_of_other_sizes_is_a_file_of_parameters(match, tmp_path):
    params = tmp_path / "hall.toml"
    params.write_text("[field]\nwidth = '300cm'\n[field.rules]\nreadyTime = '30s'\n")
    result = kelpie("replay", match, "--check", "--params", params)
    assert result.returncode == 1 and "differ" in result.stdout  # it believes in another field
    params.write_text("[field]\nbreadth = '300cm'\n")
    assert "unknown key field.breadth" in complaint(kelpie("replay", match, "--params", params))


def test_every_artefact_can_be_left_out_by_its_name(tmp_path):
    result = kelpie("play", "--seconds", "1", "--no-film", "--out", tmp_path, "--without", "ring",
                    "centres", "noise", "shift", "rolling", "blur", "shine", "own-legs",
                    "spectators")
    assert result.returncode == 0, result.stderr  # nobody scores in a second
    assert (tmp_path / "match.mcap").exists(), result.stderr
