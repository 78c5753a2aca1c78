# SPDX-License-Identifier: Apache-2.0
"""Pictures of single frames, and logs with class planes in place of images."""

import json
import struct

import pytest
from conftest import PLANE, agent, complaint, kelpie, make_recording


@pytest.fixture(name="small", scope="module")
def compressed(match, tmp_path_factory):
    log = tmp_path_factory.mktemp("small") / "small.mcap"
    result = kelpie("compress", match, "--out", log)
    assert result.returncode == 0, result.stderr
    return log


def size_of(png):
    data = png.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    return struct.unpack(">II", data[16:24])


def objects_of(log):
    result = kelpie("replay", log, "--jsonl", "-")
    assert result.returncode == 0, result.stderr
    return [json.loads(line) for line in result.stdout.splitlines()]


def test_a_frame_of_a_log_is_drawn(match, tmp_path):
    out = tmp_path / "frame.png"
    assert kelpie("show", match, "--frame", "40", "--out", out).returncode == 0
    width, height = size_of(out)
    assert width > 2 * 3 * 208 and height > 2 * 3 * 160
    assert [p.name for p in tmp_path.iterdir()] == ["frame.png"]


@pytest.mark.parametrize("name", ["frame.jpg", "FRAME.JPG", "frame.jpeg"])
def test_a_frame_is_drawn_as_jpeg_where_its_name_says_so(name, match, tmp_path):
    out = tmp_path / name
    assert kelpie("show", match, "--frame", "40", "--out", out).returncode == 0
    data = out.read_bytes()
    assert data[:3] == b"\xff\xd8\xff" and data[-2:] == b"\xff\xd9"
    assert [p.name for p in tmp_path.iterdir()] == [name]


@pytest.mark.parametrize("words, reported", [
    (("show", "--out", "f.gif"), "f.gif: show writes .png and .jpg"),
    (("film", "f.avi"), "f.avi: a film is an .mp4 file"),
    (("film", "f"), "f: a film is an .mp4 file")])
def test_what_cannot_be_written_is_refused_by_name(words, reported, match, tmp_path):
    command, *rest, name = words
    result = kelpie(command, match, *rest, tmp_path / name)
    assert result.returncode == 2 and reported in complaint(result)
    assert not list(tmp_path.iterdir())


def test_a_frame_of_a_folder_is_drawn(tmp_path):
    frames = [bytes([90]) * PLANE + bytes([128]) * (2 * PLANE)] * 2
    folder = make_recording(tmp_path / "r", frames)
    out = tmp_path / "frame.png"
    assert kelpie("show", folder, "--frame", "1", "--ring", "none", "--out", out).returncode == 0
    assert size_of(out)[0] > 1248


def test_a_frame_that_is_not_there_is_reported_with_their_number(match, tmp_path):
    folder = make_recording(tmp_path / "r", [bytes(3 * PLANE)] * 2)
    result = kelpie("show", folder, "--frame", "2", "--out", tmp_path / "x.png")
    assert result.returncode == 2
    assert "no frame 2, there are 2 (0 to 1)" in complaint(result)
    frames = len(objects_of(match))
    result = kelpie("show", match, "--frame", "99999", "--out", tmp_path / "x.png")
    assert result.returncode == 2
    assert f"there are {frames} (" in complaint(result)
    assert not list(tmp_path.glob("*.png"))


def test_bad_sources_get_one_line(match, tmp_path):
    junk = tmp_path / "junk.mcap"
    junk.write_bytes(b"this is no log" * 100)
    for source in (junk, tmp_path, tmp_path / "none.mcap"):
        for command in (["show", source, "--out", tmp_path / "x.png"],
                        ["compress", source, "--out", tmp_path / "x.mcap"]):
            result = kelpie(*command)
            assert result.returncode == 2
            assert str(source) in complaint(result)
    assert kelpie("show", match, "--out", match).returncode == 2
    assert kelpie("compress", match, "--out", match).returncode == 2
    assert [p.name for p in tmp_path.iterdir()] == ["junk.mcap"]


def test_of_a_cut_log_the_whole_frames_are_shown_and_kept(match, tmp_path):
    cut = tmp_path / "cut.mcap"
    cut.write_bytes(match.read_bytes()[:5_000_000])
    result = kelpie("show", cut, "--frame", "3", "--out", tmp_path / "x.png")
    assert result.returncode == 2 and "cut off at byte" in complaint(result)
    assert (tmp_path / "x.png").exists()
    result = kelpie("show", cut, "--frame", "999", "--out", tmp_path / "y.png")
    assert result.returncode == 2 and "there are" in complaint(result)
    result = kelpie("compress", cut, "--out", tmp_path / "small.mcap")
    assert result.returncode == 2 and "cut off at byte" in complaint(result)
    assert kelpie("replay", tmp_path / "small.mcap", "--check").returncode == 0


def test_a_compressed_log_is_a_fifth_and_replays_bit_for_bit(match, small):
    assert small.stat().st_size < match.stat().st_size / 5
    result = kelpie("replay", small, "--check")
    assert result.returncode == 0, result.stderr
    assert " 0 differ" in result.stdout
    assert "kelpie/PlaneFrame" in kelpie("info", small).stdout


def test_a_compressed_log_shows_the_same_balls(match, small):
    whole, planes = objects_of(match), objects_of(small)
    assert len(whole) == len(planes)

    def ball(frame):
        return next((p for p in frame["percepts"] if p["kind"] == "ball"), None)

    pairs = [(ball(a), ball(b)) for a, b in zip(whole, planes, strict=True)]
    same = [bool(a) == bool(b) for a, b in pairs]
    assert sum(same) >= 0.95 * len(same)
    near = [abs(b["distance_cm"] / a["distance_cm"] - 1) < 0.05 for a, b in pairs if a and b]
    assert near and sum(near) >= 0.9 * len(near)


def test_class_planes_do_not_pass_for_images_of_a_camera(small, tmp_path):
    result = agent("--recording", small, "--log", tmp_path / "again.mcap")
    assert result.returncode == 1
    assert "class planes" in result.stderr and "kelpie replay" in result.stderr
    assert result.stderr.count("\n") == 1


def test_compressing_twice_changes_no_frame(small, tmp_path):
    again = tmp_path / "again.mcap"
    assert kelpie("compress", small, "--out", again).returncode == 0
    assert objects_of(again) == objects_of(small)


def test_compressed_logs_are_shown_and_filmed(small, tmp_path):
    assert kelpie("show", small, "--frame", "5", "--out", tmp_path / "x.png").returncode == 0
    assert kelpie("film", small, tmp_path / "x.mp4").returncode == 0
