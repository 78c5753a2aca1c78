# SPDX-License-Identifier: Apache-2.0
"""kelpie import: somebody's own images and joint angles become a log like any other."""

import json
import math
import struct
import subprocess
import zlib

import pytest
from conftest import BIN, HEADER, PLANE, complaint, kelpie, make_recording

GREY = bytes([90]) * PLANE + bytes([128]) * (2 * PLANE)
GREEN = bytes([77]) * PLANE + bytes([103]) * PLANE + bytes([97]) * PLANE


def refusal(folder, out):
    """The one line that import gives; nothing is left behind."""
    result = kelpie("import", folder, "--out", out)
    assert result.returncode == 2, result.stdout
    assert not list(out.parent.glob("*.mcap*"))
    return complaint(result)


def refusal_of_table(tmp_path, text, frames=2):
    folder = make_recording(tmp_path / "r", [GREY] * frames)
    (folder / "sensors.csv").write_text(text)
    return refusal(folder, tmp_path / "r.mcap")


def png_of(colour):
    """A picture of 208 x 160 pixels of one RGB colour, as any PNG writer makes it."""
    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))
    rows = (b"\0" + bytes(colour) * 208) * 160
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 208, 160, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


@pytest.fixture(scope="module", name="log")
def imported_log(tmp_path_factory):
    folder = tmp_path_factory.mktemp("import")
    make_recording(folder / "r", [GREY, GREEN, GREY, GREEN, GREY])
    result = kelpie("import", folder / "r", "--out", folder / "r.mcap")
    assert result.returncode == 0, result.stderr
    assert result.stderr == ""  # no progress where nobody looks
    return folder / "r.mcap"


def test_the_example_of_the_help_is_accepted_as_it_is(tmp_path):
    text = kelpie("import", "--help").stdout
    example = [HEADER] + text.split(HEADER + "\n")[1].split()
    assert len(example) == 3
    folder = make_recording(tmp_path / "r", [GREY, GREEN])
    (folder / "sensors.csv").write_text("\n".join(example) + "\n")
    result = kelpie("import", folder, "--out", tmp_path / "r.mcap")
    assert result.returncode == 0, result.stderr
    assert "replayed 2 frames" in kelpie("replay", tmp_path / "r.mcap").stdout


def test_the_help_alone_tells_the_layout():
    text = kelpie("import", "--help").stdout
    for fact in ("frames/000000.yuv", "sensors.csv", "99840 bytes", "Y, Cr, Cb", "208 x 160",
                 "Cr comes before Cb", "RGB", "left and up\npositive", "nose down positive",
                 "--pycode"):
        assert fact in text, fact
    for column in HEADER.split(","):
        assert f"\n  {column} " in text, column
    assert max(map(len, text.splitlines())) < 120


def test_an_imported_log_is_checked_shown_and_filmed_like_any_other(log, tmp_path):
    check = kelpie("replay", log, "--check")
    assert check.returncode == 0, check.stderr
    assert "5 outputs compared, 0 differ" in check.stdout
    assert kelpie("show", log, "--frame", "4", "--out", tmp_path / "4.png").returncode == 0
    assert kelpie("film", log, tmp_path / "r.mp4").returncode == 0
    assert (tmp_path / "r.mp4").stat().st_size > 1000
    objects = kelpie("replay", log, "--jsonl", "-").stdout.splitlines()
    assert [json.loads(line)["frame"] for line in objects] == [0, 1, 2, 3, 4]


def test_outputs_come_from_the_behaviours_given(log, tmp_path):
    (tmp_path / "main.py").write_text("import kelpie\ndef decide(world):\n    return "
                                      "kelpie.Command(walk=kelpie.WalkRequest(forward=7))\n")
    other = tmp_path / "r.mcap"
    assert kelpie("import", log.parent / "r", "--pycode", tmp_path, "--out", other).returncode == 0
    assert kelpie("replay", other, "--check", "--pycode", tmp_path).returncode == 0
    result = kelpie("replay", other, "--check")
    assert result.returncode == 1 and "command" in result.stderr


def test_a_script_that_does_not_load_is_reported_before_the_work(log, tmp_path):
    (tmp_path / "main.py").write_text("def decide(world)\n")
    result = kelpie("import", log.parent / "r", "--pycode", tmp_path, "--out", tmp_path / "x.mcap")
    assert result.returncode == 2 and "main.py:1: SyntaxError" in complaint(result)
    assert not list(tmp_path.glob("*.mcap*"))


def test_a_reddish_picture_is_bright_in_the_second_plane(tmp_path):
    planes = bytes([102]) * PLANE + bytes([198]) * PLANE + bytes([104]) * PLANE  # by JPEG's formula
    logs = []
    for name in ("planes", "picture"):
        folder = make_recording(tmp_path / name, [planes])
        if name == "picture":
            (folder / "frames" / "000000.yuv").unlink()
            (folder / "frames" / "000000.png").write_bytes(png_of((200, 60, 60)))
        logs.append(tmp_path / f"{name}.mcap")
        assert kelpie("import", folder, "--out", logs[-1]).returncode == 0
    assert logs[0].read_bytes() == logs[1].read_bytes()


def test_all_complaints_about_a_header_come_at_once(tmp_path):
    reported = refusal_of_table(tmp_path, "t,head_pan_deg,head_pan_deg,neck\n0,1,2,3\n")
    assert "sensors.csv:1: missing t_s, neck_tilt_deg, head_nod_deg" in reported
    assert "unknown 't', 'neck'" in reported and "more than once head_pan_deg" in reported
    assert "the header must be " + HEADER in reported


def test_columns_in_another_order_are_reported_as_such(tmp_path):
    columns = HEADER.split(",")
    reported = refusal_of_table(tmp_path, ",".join([*columns[1:], columns[0]]) + "\n")
    assert "sensors.csv:1: the columns are in the wrong order" in reported


def test_an_empty_table_is_a_missing_header(tmp_path):
    assert "sensors.csv:1: missing t_s" in refusal_of_table(tmp_path, "")


GOOD = "{},-20,0,0,14.25,100,0,0,0"


@pytest.mark.parametrize("row, reported", [
    ("0.0334,1e308,0,0,14.25,100,0,0,0", "neck_tilt_deg: 1e+308, expected angles in -360..360"),
    ("0.0334,-20,oops,0,14.25,100,0,0,0", "head_pan_deg: 'oops' is not a number"),
    ("0.0334,-20,,0,14.25,100,0,0,0", "head_pan_deg: '' is not a number"),
    ("0.0334,-20,0,0,14.25,100,0,0", "8 columns, expected 9"),
    ("0.0334;-20;0;0;14.25;100;0;0;0", "1 columns, expected 9"),
    ("0.0000001,-20,0,0,14.25,100,0,0,0", "time does not increase"),
    ("-1,-20,0,0,14.25,100,0,0,0", "t_s: -1, expected 0..1000000 s"),
    ("0.0044,-20,85,0,14.25,100,0,0,0", "headRate.headPan"),
    ("99,-20,0,0,14.25,100,0,0,0", "elapsed"),
])
def test_rows_that_no_robot_could_give_are_named(tmp_path, row, reported):
    line = refusal_of_table(tmp_path, "\n".join([HEADER, GOOD.format(0), row]) + "\n")
    assert reported in line and "sensors.csv:3:" in line and "more" not in line


def test_the_first_wrong_row_is_named_and_the_others_are_counted(tmp_path):
    rows = [GOOD.format(f"{i / 30:.4f}") for i in range(8)]
    for wrong in (2, 5):
        rows[wrong] = rows[wrong].replace("-20", "down")
    text = "\n".join([HEADER, *rows]) + "\n"
    reported = refusal_of_table(tmp_path, text, 8)
    assert reported.endswith("'down' is not a number; 1 more row is wrong")
    reported = refusal_of_table(tmp_path / "b", text + "wrong too\n", 8)
    assert "sensors.csv:4:" in reported and reported.endswith("; 2 more rows are wrong")


def test_blanks_a_mark_and_carriage_returns_do_no_harm(tmp_path):
    folder = make_recording(tmp_path / "r", [GREY])
    rows = (HEADER.replace(",", ", "), GOOD.format(0).replace(",", " ,"))
    table = "\ufeff" + "\r\n".join(rows) + "\r\n"
    (folder / "sensors.csv").write_bytes(table.encode() + b"\r\n")
    result = kelpie("import", folder, "--out", tmp_path / "r.mcap")
    assert result.returncode == 0, result.stderr


def test_frames_and_rows_must_be_as_many(tmp_path):
    reported = refusal_of_table(tmp_path, HEADER + "\n" + GOOD.format(0) + "\n")
    assert "sensors.csv: 1 rows for 2 frames" in reported


def test_a_gap_in_the_numbers_of_the_frames_is_named(tmp_path):
    folder = make_recording(tmp_path / "r", [GREY] * 3)
    (folder / "frames" / "000001.yuv").rename(folder / "frames" / "000003.yuv")
    reported = refusal(folder, tmp_path / "r.mcap")
    assert "000002.yuv follows 000000.yuv" in reported
    (folder / "frames" / "000003.yuv").rename(folder / "frames" / "000002.png")
    assert "numbers must follow without a gap" in refusal(folder, tmp_path / "r.mcap")
    (folder / "frames" / "000002.png").rename(folder / "frames" / "first.png")
    assert "first.png: its name must be its number" in refusal(folder, tmp_path / "r.mcap")


def test_frames_follow_by_number_not_by_spelling(tmp_path):
    folder = make_recording(tmp_path / "r", [GREY] * 11)
    for i in range(11):
        (folder / "frames" / f"{i:06d}.yuv").rename(folder / "frames" / f"{i}.yuv")
    (folder / "frames" / "10.yuv").write_bytes(bytes(100))
    assert "10.yuv" in refusal(folder, tmp_path / "r.mcap")
    (folder / "frames" / "10.yuv").write_bytes(GREY)
    assert kelpie("import", folder, "--out", tmp_path / "r.mcap").returncode == 0


def test_the_frame_of_a_wrong_size_is_named(tmp_path):
    folder = make_recording(tmp_path / "r", [GREY, bytes(100)])
    reported = refusal(folder, tmp_path / "r.mcap")
    assert "000001.yuv: 100 bytes, expected 99840" in reported


def test_an_earlier_log_survives_a_recording_that_is_no_good(tmp_path):
    folder = make_recording(tmp_path / "r", [GREY, bytes(100)])
    (tmp_path / "r.mcap").write_bytes(b"precious")
    assert kelpie("import", folder, "--out", tmp_path / "r.mcap").returncode == 2
    assert (tmp_path / "r.mcap").read_bytes() == b"precious"
    assert not (tmp_path / "r.mcap.part").exists()


def test_the_log_never_takes_the_place_of_the_recording(tmp_path):
    folder = make_recording(tmp_path / "r", [GREY])
    for name in ("sensors.csv", "frames/000000.yuv"):
        before = (folder / name).read_bytes()
        assert "is part of the recording itself" in refusal(folder, folder / name)
        assert (folder / name).read_bytes() == before


def test_a_known_start_is_where_the_robot_is(log):
    result = kelpie("replay", log, "--jsonl", "-", "--init", "180,100,90")
    assert result.returncode == 0, result.stderr
    first = json.loads(result.stdout.splitlines()[0])
    assert abs(first["pose"]["x_cm"] - 180) < 1 and first["percepts"] == []


def test_names_in_capitals_as_a_fat_stick_has_them_are_taken(log, tmp_path):
    folder = tmp_path / "R"
    (folder / "FRAMES").mkdir(parents=True)
    for i, planes in enumerate([GREY, GREEN, GREY, GREEN, GREY]):
        (folder / "FRAMES" / f"FRAME{i:03d}.YUV").write_bytes(planes)
    (folder / "SENSORS.CSV").write_bytes((log.parent / "r" / "sensors.csv").read_bytes())
    result = kelpie("import", folder, "--out", tmp_path / "R.MCAP")
    assert result.returncode == 0, result.stderr
    assert (tmp_path / "R.MCAP").read_bytes() == log.read_bytes()
    assert kelpie("replay", tmp_path / "R.MCAP", "--check").returncode == 0
    ring = kelpie("calibrate", "ring", tmp_path / "R.MCAP", "--out", tmp_path / "X.KT")
    assert "no such folder or log" not in ring.stderr and "no table" not in ring.stderr
    assert "is part of the recording itself" in refusal(folder, folder / "SENSORS.CSV")


def test_a_decimal_comma_is_reported_with_its_line_and_what_to_write(tmp_path):
    reported = refusal_of_table(tmp_path, "\n".join([HEADER, GOOD.format(0), "0,0334,-20,0,0,14,25,"
                                                 "100,0,0,0"]) + "\n")
    assert ":3: 11 columns, expected 9; write numbers with a decimal point" in reported


FRAMES_OF_WALK = 120
HEADING = math.radians(75)


def place_at(frame):
    return 120 + 0.8 * frame * math.cos(HEADING), 120 + 0.8 * frame * math.sin(HEADING)


def pan_at(seconds):
    return 60 * math.sin(math.pi * seconds)


def imported_walk(folder, tilt=0.0, lag=0.0):
    """What a walking robot sees that pans its head; its table says nothing of tilt and lag."""
    (folder / "frames").mkdir(parents=True)
    rows = [HEADER]
    for frame in range(FRAMES_OF_WALK):
        seconds = frame / 30
        rows.append(f"{seconds:.4f},-10,{pan_at(seconds):.4f},0,14.25,100,{0.8 if frame else 0},"
                    "0,0")
        rate = 60 * math.pi * math.cos(math.pi * (seconds - lag))
        words = ["--pose", *place_at(frame), 75, "--head", -10, pan_at(seconds - lag), 0,
                 "--pan-rate", rate, "--tilt-error", tilt, "--seed", 3, "--ball", 300, 500,
                 "--others", 0, "--ideal", "--small", "--out",
                 folder / "frames" / f"{frame:06d}.png"]
        subprocess.run([BIN / "sim_snapshot", *map(str, words)], check=True, capture_output=True)
    (folder / "sensors.csv").write_text("\n".join(rows) + "\n")
    log = folder / "walk.mcap"
    result = kelpie("import", folder, "--ring", "none", "--init", "120,120,75", "--out", log)
    assert result.returncode == 0, result.stderr
    return log


def frames_and_error(log):
    """The frames, and how far the believed place is from the true one at the end."""
    frames = [json.loads(line)
              for line in kelpie("replay", log, "--jsonl", "-").stdout.splitlines()]
    where = (frames[-1]["pose"]["x_cm"], frames[-1]["pose"]["y_cm"])
    return frames, math.dist(where, place_at(FRAMES_OF_WALK - 1))


def elevation_errors(frames):
    """deg by which landmarks are seen higher than they stand, with the tilt they were read with."""
    return [abs(seen["elevation_error"]["value_deg"]) for frame in frames
            for seen in frame["percepts"] if "elevation_error" in seen]


def test_a_tilt_that_nobody_knows_is_found_in_an_imported_walk(tmp_path):
    log = imported_walk(tmp_path / "w", tilt=3.0)
    frames, off = frames_and_error(log)
    assert off < 4
    assert -3.6 < frames[-1]["camera_tilt"]["tilt_deg"] < -2.4
    errors = elevation_errors(frames[60:])
    assert len(errors) > 10 and sum(errors) / len(errors) < 1.0
    assert kelpie("replay", log, "--check").returncode == 0


def test_a_lag_that_nobody_knows_is_found_in_an_imported_walk(tmp_path):
    log = imported_walk(tmp_path / "w", lag=0.02)
    frames, off = frames_and_error(log)
    assert off < 4
    assert abs(frames[-1]["image_lag_s"] - 0.02) < 0.003
    assert kelpie("replay", log, "--check").returncode == 0
