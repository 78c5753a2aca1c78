# SPDX-License-Identifier: Apache-2.0
"""A match as a file for other people's viewers: what the command says and writes."""

import json
import re
import resource
import signal
import subprocess

import pytest
from conftest import BIN, ROOT, complaint, kelpie

START = "2006-06-14T10:00:00Z"
START_S = 1150279200


def exported(log, out, *words):
    result = kelpie("export", log, "--out", out, *words)
    assert result.returncode == 0, result.stderr
    return out


def topics_of(log):
    """topic -> (type, messages, first and last second), as `kelpie info` tells them."""
    rows = re.findall(r"^(/\S+)\s+(\S+)\s+(\d+)\s+\S+\s+(\S+)\s+(\S+)$",
                      kelpie("info", log).stdout, re.M)
    return {topic: (kind, int(count), float(first), float(last))
            for topic, kind, count, first, last in rows}


@pytest.fixture(name="viewer", scope="module")
def viewer_file(match, tmp_path_factory):
    return exported(match, tmp_path_factory.mktemp("viewer") / "viewer.mcap", "--start", START)


def test_each_frame_has_its_image_pose_and_body(match, viewer):
    frames = topics_of(match)["/frame/output"][1]
    topics = topics_of(viewer)
    assert frames > 80
    assert topics["/red1/camera"][:2] == ("foxglove.CompressedImage", frames)
    assert topics["/red1/pose"][:2] == ("foxglove.PoseInFrame", frames)
    assert topics["/red1/robot"][:2] == ("foxglove.SceneUpdate", frames)
    assert topics["/ball/true"][1] == topics_of(match)["/truth"][1]
    assert topics["/field"][1] == 1


def test_the_layout_shows_topics_that_an_export_has(viewer):
    layout = json.loads((ROOT / "docs" / "viewers" / "layout.json").read_text())
    panels = json.dumps(layout["layout"])
    assert all(f'"{name}"' in panels for name in layout["configById"])
    known = {re.sub("red1|red2", "ROBOT", topic) for topic in topics_of(viewer)}
    named = set(re.findall(r'"(/[^".]+)[".]', json.dumps(layout["configById"])))
    assert len(named) > 20
    assert {re.sub(r"(red|blue)\d", "ROBOT", topic) for topic in named} <= known | {"/robots"}


def test_time_0_of_the_log_is_the_start(match, viewer):
    first, last = topics_of(match)["/frame/output"][2:]
    assert topics_of(viewer)["/red1/pose"][2:] == pytest.approx(
        (START_S + first, START_S + last), rel=0.0, abs=0.0015)


def test_without_a_start_it_is_the_time_of_the_file(match, tmp_path):
    out = exported(match, tmp_path / "viewer.mcap")
    assert topics_of(out)["/field"][2] == int(match.stat().st_mtime)


def test_the_same_log_gives_the_same_bytes(match, viewer, tmp_path):
    again = exported(match, tmp_path / "again.mcap", "--start", START)
    assert again.read_bytes() == viewer.read_bytes()


def test_the_reasons_are_those_of_why(match, viewer):
    lines = kelpie("why", match, "--from", "0", "--to", "60").stdout.splitlines()
    assert topics_of(viewer)["/red1/log"][1] == len(lines) > 1


def test_of_a_cut_log_what_is_whole_is_exported(match, tmp_path):
    cut = tmp_path / "cut.mcap"
    cut.write_bytes(match.read_bytes()[: match.stat().st_size * 2 // 3])
    result = kelpie("export", cut, "--out", tmp_path / "viewer.mcap")
    assert result.returncode == 2
    assert "cut.mcap: cut off at byte" in complaint(result)
    assert topics_of(tmp_path / "viewer.mcap")["/red1/pose"][1] > 10


@pytest.mark.parametrize("start", ["yesterday", "2006", "2006-06-14T10:00",
                                   "2006-06-14T10:00:00+2"])
def test_a_start_that_is_no_time_is_named(match, tmp_path, start):
    result = kelpie("export", match, "--out", tmp_path / "viewer.mcap", "--start", start)
    assert result.returncode == 2
    assert f"--start {start}" in complaint(result)
    assert list(tmp_path.iterdir()) == []


def test_what_is_no_log_is_named_and_leaves_nothing(match, tmp_path):
    out = tmp_path / "viewer.mcap"
    foreign = tmp_path / "foreign.mcap"
    foreign.write_bytes(b"this is no log" * 100)
    for log, words in ((foreign, "not an MCAP log"), (tmp_path, "is a folder"),
                       (tmp_path / "none.mcap", "No such file")):
        result = kelpie("export", match, log, "--out", out)
        assert result.returncode == 2
        assert str(log) in complaint(result) and words in complaint(result)
    assert kelpie("export", match, match, "--out", out).returncode == 2
    assert [path.name for path in tmp_path.iterdir()] == ["foreign.mcap"]


def test_a_log_is_never_its_own_export(match):
    size = match.stat().st_size
    result = kelpie("export", match, "--out", match)
    assert result.returncode == 2 and "is one of the logs" in complaint(result)
    assert match.stat().st_size == size


def full_disk():
    """Files end at 40 KB, as on a disk that is full, and no signal tells."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (40_000, 40_000))


def test_a_full_disk_is_the_machines_failure_and_spares_what_was_there(match, tmp_path):
    out = tmp_path / "viewer.mcap"
    out.write_bytes(b"precious")
    result = subprocess.run([BIN / "kelpie", "export", match, "--out", out], capture_output=True,
                            text=True, timeout=240, check=False, preexec_fn=full_disk,
                            restore_signals=False)
    assert result.returncode == 3 and "cannot write" in complaint(result)
    assert out.read_bytes() == b"precious" and list(tmp_path.iterdir()) == [out]


def test_every_message_decodes_by_the_published_types(viewer):
    """As the viewers' makers publish them, which none of ours had a hand in."""
    reader = BIN.parent / "log_reader"
    if not (reader / "node_modules/@foxglove/schemas").is_dir():
        pytest.skip("no node packages: ctest -R third_party installs them where npm is")
    result = subprocess.run(["node", "check_viewer.mjs", viewer], cwd=reader, capture_output=True,
                            text=True, check=False, timeout=120)
    assert result.returncode == 0, result.stderr
    counts = json.loads(result.stdout)
    assert counts["foxglove.CompressedImage"] > 80 and counts["foxglove.SceneUpdate"] > 80
