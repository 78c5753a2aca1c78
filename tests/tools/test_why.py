# SPDX-License-Identifier: Apache-2.0
"""Why the robot did what it did, its decision tree, and what its skills ask for."""

import json
import re
import struct

import pytest
from conftest import ROOT, complaint, kelpie

MAIN = """
import kelpie


def decide(world):
    leaf = 'kick' if world.frame < 20 else 'turn'
    why = [(kelpie.LAYER_PLAYER, 'forward', 'play', 'play is on'),
           (kelpie.LAYER_DECISION, 'tree', leaf, 'frame {}', world.frame)]
    if 15 <= world.frame < 20:
        why.append((kelpie.LAYER_DECISION, 'leaf_by_map', 'kick_ahead', 'worth it'))
    if world.task.player == kelpie.ONE_SKILL:
        return kelpie.Command(walk=kelpie.WalkRequest(forward=10.0))
    return kelpie.Command(trace=why if world.frame >= 5 else [])


def tree():
    return [('0', '', '', 'near?', False), ('y', '0', 'yes', 'kick', True),
            ('n', '0', 'no', 'turn', True)]


def skill_names():
    return ['walk', 'stand']
"""


def played(out, pycode, seconds=1):
    result = kelpie("play", "--fast", "--seconds", seconds, "--seed", "2", "--no-film", "--pycode",
                    pycode, "--out", out)
    assert (out / "match.mcap").exists(), result.stderr
    return out / "match.mcap"


@pytest.fixture(name="pycode", scope="module")
def behaviours(tmp_path_factory):
    folder = tmp_path_factory.mktemp("pycode")
    (folder / "main.py").write_text(MAIN)
    return folder


@pytest.fixture(name="log", scope="module")
def log_with_reasons(pycode, tmp_path_factory):
    return played(tmp_path_factory.mktemp("log"), pycode)


@pytest.fixture(name="silent", scope="module")
def log_without_reasons(tmp_path_factory):
    return played(tmp_path_factory.mktemp("silent"), ROOT / "tools/calibrate/looking")


def size_of(png):
    data = png.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    return struct.unpack(">II", data[16:24])


def refused(*words):
    result = kelpie(*words)
    assert result.returncode == 2 and result.stdout == ""
    return complaint(result)


def test_a_frames_reasons_are_sentences_from_the_player_down(log):
    result = kelpie("why", log, "--at", "0.5")
    assert result.returncode == 0, result.stderr
    first, why, player, tree = result.stdout.splitlines()
    frame = int(re.match(r"At 0\.[45]\d s \(frame (\d+)\) red player 1 asks its body to stand;",
                         first).group(1))
    assert why == "Why:"
    assert player == "  The player forward chose play: play is on."
    assert tree == f"  The decision tree chose kick: frame {frame}."


def test_every_change_of_a_decision_is_a_line(log):
    result = kelpie("why", log, "--from", "0", "--to", "9")
    assert result.returncode == 0, result.stderr
    lines = [line.split(" s  ", 1)[1] for line in result.stdout.splitlines()]
    assert lines == ["no reason given", "forward: play > tree: kick - play is on",
                     "forward: play > tree: kick > leaf_by_map: kick_ahead - worth it",
                     "forward: play > tree: turn - frame 20"]


def test_reasons_of_a_real_match_reach_from_the_player_to_a_skill(match):
    result = kelpie("why", match, "--at", "2")
    assert result.returncode == 0, result.stderr
    sentences = result.stdout.splitlines()[2:]
    assert sentences[0].startswith("  The player forward chose ")
    assert sentences[-1].startswith("  The skill ")
    assert all(s.endswith(".") and "{" not in s and "?" not in s for s in sentences)


def test_a_log_with_reasons_replays_bit_for_bit_and_its_lines_hold_them(log, pycode):
    result = kelpie("replay", log, "--check", "--pycode", pycode, "--jsonl", "-")
    assert result.returncode == 0, result.stderr
    frames = [json.loads(line) for line in result.stdout.splitlines()]
    assert frames[4]["command"]["trace"] == []
    assert frames[9]["command"]["trace"][1] == {
        "layer": "decision", "module": "tree", "branch": "kick", "reason": "frame {}",
        "numbers": [9.0]}


def test_why_refuses_what_it_cannot_answer_in_one_line(log, silent, tmp_path):
    junk = tmp_path / "junk.mcap"
    junk.write_bytes(b"this is no log" * 100)
    assert str(junk) in refused("why", junk, "--at", "1")
    assert "none.mcap" in refused("why", tmp_path / "none.mcap", "--from", "1")
    assert "no frame at 50 s; there are frames from 0.0" in refused("why", log, "--at", "50")
    assert "no frame from 60 to 70 s" in refused("why", log, "--from", "60", "--to", "70")
    assert "no reasons at 0." in refused("why", silent, "--at", "0.5")
    assert "no reasons from 0 to 1 s" in refused("why", silent, "--from", "0", "--to", "1")
    assert "no reasons at 0.0" in refused("why", log, "--at", "0")
    assert "--from 2 is after --to 1" in refused("why", log, "--from", "2", "--to", "1")
    assert "takes --at, or --from and --to" in refused("why", log)
    assert "takes --at, or --from and --to" in refused("why", log, "--at", "1", "--to", "2")
    assert "x is not a number" in refused("why", log, "--at", "x")


def test_of_a_cut_log_what_is_whole_is_reported(log, tmp_path):
    cut = tmp_path / "cut.mcap"
    cut.write_bytes(log.read_bytes()[:-200_000])
    result = kelpie("why", cut, "--at", "0.3")
    assert result.returncode == 2 and "cut off at byte" in complaint(result)
    assert "The player forward chose play" in result.stdout


def test_frames_of_a_log_are_shown_and_filmed_with_their_reasons(log, silent, tmp_path):
    with_reasons, without = tmp_path / "a.png", tmp_path / "b.png"
    assert kelpie("show", log, "--frame", "10", "--out", with_reasons).returncode == 0
    assert kelpie("show", silent, "--frame", "10", "--out", without).returncode == 0
    assert size_of(with_reasons)[0] == size_of(without)[0]
    assert with_reasons.read_bytes() != without.read_bytes()
    assert kelpie("film", log, tmp_path / "a.mp4").returncode == 0


def test_the_shipped_tree_is_drawn(tmp_path):
    out = tmp_path / "tree.png"
    result = kelpie("tree", "--out", out)
    assert result.returncode == 0, result.stderr
    width, height = size_of(out)
    assert width > 1000 and height > 500


def test_a_logs_leaves_are_counted(log, pycode, tmp_path):
    out = tmp_path / "tree.png"
    result = kelpie("tree", log, "--pycode", pycode, "--out", out)
    assert result.returncode == 0, result.stderr
    rows = [line.split() for line in result.stdout.splitlines()]
    assert " ".join(rows[0]) == "the tree named played"
    frames = int(rows[1][-2])
    counts = {row[6]: [int(row[at]) for at in (0, 2, 3, 5)] for row in rows[2:5]}
    assert counts == {"kick": [15, 1, 10, 1], "turn": [frames - 20, 1, frames - 20, 1],
                      "kick_ahead": [0, 0, 5, 1]}
    assert size_of(out)[0] > 100


def test_leaves_that_are_not_in_the_tree_are_marked(log, tmp_path):
    result = kelpie("tree", log, "--out", tmp_path / "tree.png")
    assert result.returncode == 0, result.stderr
    assert "kick (not in this tree)" in result.stdout


def test_tree_refuses_what_it_cannot_draw_in_one_line(log, silent, pycode, tmp_path):
    out = tmp_path / "tree.png"
    assert "holds no decision of the tree" in refused("tree", silent, "--out", out)
    assert "main.py: does not exist" in refused("tree", "--pycode", tmp_path, "--out", out)
    (tmp_path / "main.py").write_text("def decide(world):\n    return None\n")
    assert "main.py has no tree()" in refused("tree", "--pycode", tmp_path, "--out", out)
    (tmp_path / "main.py").write_text("def decide(world):\n    return\n\ndef tree():\n    1 / 0\n")
    assert "main.py:5: ZeroDivisionError" in refused("tree", "--pycode", tmp_path, "--out", out)
    (tmp_path / "main.py").write_text("def decide(w):\n    1\n\ndef tree():\n    return 'ab'\n")
    assert "row 0: not (id, " in refused("tree", "--pycode", tmp_path, "--out", out)
    assert "is the log itself" in refused("tree", log, "--pycode", pycode, "--out", log)
    assert not out.exists()


def test_a_vector_field_is_drawn(pycode, tmp_path):
    out = tmp_path / "v.png"
    result = kelpie("vectors", "walk", "--pycode", pycode, "--ball", "100,300", "--out", out)
    assert result.returncode == 0, result.stderr
    assert size_of(out) == (900, 1344)


@pytest.mark.parametrize("heading", [[], ["--heading", "90"]])
def test_every_shipped_skill_has_a_vector_field(heading, tmp_path):
    said = refused("vectors", "love", "--out", tmp_path / "x.png")
    names = said.split("there are ", 1)[1].split(", ")
    assert "attacker" in names
    for name in names:
        result = kelpie("vectors", name, "--step", "60", *heading, "--out", tmp_path / "x.png")
        assert result.returncode == 0, result.stderr


def test_vectors_refuses_what_it_cannot_draw_in_one_line(pycode, tmp_path):
    out = tmp_path / "v.png"
    mine = ("--pycode", pycode, "--out", out)
    assert "no skill 'love'; there are walk, stand" in refused("vectors", "love", *mine)
    for ball in ("400,100", "1", "a,b", "1,2,3", "nan,5"):
        assert f"--ball {ball}: not x,y in cm" in refused("vectors", "walk", "--ball", ball, *mine)
    assert "not a number" in refused("vectors", "walk", "--step", "0", *mine)
    assert "no field '1999'" in refused("vectors", "walk", "--field", "1999", *mine)
    main = tmp_path / "main.py"
    main.write_text("def decide(world):\n    return 1\n\ndef skill_names():\n    return ['a']\n")
    said = refused("vectors", "a", "--pycode", tmp_path, "--out", out)
    assert "decide returned a int" in said and "robot at 10, 10" in said
    assert not out.exists()
