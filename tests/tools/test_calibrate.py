# SPDX-License-Identifier: Apache-2.0
"""kelpie calibrate: tables from sheets, logs, labelled pixels and other tables."""

import math
import random

import pytest
from conftest import PLANE, complaint, kelpie, make_recording

RING_BYTES = 6 + 3 * 149 * 256  # of a ring table file, before its checksum: centres, channels
PAPERS = [(82, 121, 167), (189, 124, 129), (120, 160, 61)]


def sheet(paper, seed):
    """Planes of a sheet that loses a quarter of its light towards the corners, with noise."""
    noise = random.Random(seed)
    planes = bytearray()
    for value in paper:
        for y in range(160):
            for x in range(208):
                d = math.hypot(x - 103.5, y - 79.5) / 130
                planes.append(max(0, min(255, round(value * (1 - 0.25 * d * d)
                                                    + noise.gauss(0, 2)))))
    return bytes(planes)


def ring_data(path):
    return path.read_bytes()[-RING_BYTES - 4:-4]


@pytest.fixture(scope="module")
def sheets():
    return [sheet(paper, i) for i, paper in enumerate(PAPERS)]


def test_ring_table_from_a_folder_of_sheets_says_where_it_came_from(sheets, tmp_path):
    for i, planes in enumerate(sheets):
        (tmp_path / f"{i}.yuv").write_bytes(planes)
    table = tmp_path / "ring.kt"
    result = kelpie("calibrate", "ring", tmp_path, "--out", table, "--note", "my lab")
    assert result.returncode == 0, result.stderr
    assert "3 sheets" in result.stdout and "centre 10" in result.stdout
    shown = kelpie("calibrate", "show", table).stdout
    assert "ring table" in shown and "3 sheets" in shown and "my lab" in shown


def test_ring_table_from_a_log_is_the_one_from_its_images(sheets, tmp_path):
    folder = make_recording(tmp_path / "recording", sheets)
    log = tmp_path / "sheets.mcap"
    assert kelpie("import", folder, "--out", log).returncode == 0
    for source, out in ((log, "a.kt"), (folder / "frames", "b.kt")):
        assert kelpie("calibrate", "ring", source, "--out", tmp_path / out).returncode == 0
    assert ring_data(tmp_path / "a.kt") == ring_data(tmp_path / "b.kt")


def test_the_robots_shift_goes_into_its_ring_table(tmp_path):
    rows = ["date,dog,mac_low4,base_dog,paper,y_dog,y_base_mean,u_dog,u_base_mean,v_dog,"
            "v_base_mean"]
    for value in (50, 100, 150):
        rows.append(f"day,r1,c6240000,b1,paper,{value},{value + 7},{value},{value},{value},{value}")
    samples = tmp_path / "samples.csv"
    samples.write_text("\n".join(rows) + "\n")
    table = tmp_path / "ring.kt"
    assert kelpie("calibrate", "ring", "none", "--shift", samples, "--robot", "r1", "--out",
                  table).returncode == 0
    data = ring_data(table)[6:]
    assert data[100] == 107 and data[149 * 256 + 100] == 100
    assert "c6240000,3,1,7," in kelpie("calibrate", "shift", samples).stdout
    result = kelpie("calibrate", "ring", "none", "--shift", samples, "--robot", "r9", "--out",
                    table)
    assert result.returncode == 2 and "no robot 'r9'" in complaint(result)


def test_colour_table_from_labels_prints_the_confusion_and_draws_a_picture(tmp_path):
    chance = random.Random(1)
    rows = ["Y,Cr,Cb,class"]
    for paper, number in ((PAPERS[0], 1), (PAPERS[1], 9), (PAPERS[2], 3)):
        for _ in range(200):
            rows.append(",".join(str(v + chance.randint(-5, 5)) for v in paper) + f",{number}")
    labels = tmp_path / "labels.csv"
    labels.write_text("\n".join(rows) + "\n")
    table, picture = tmp_path / "colour.kt", tmp_path / "table.png"
    result = kelpie("calibrate", "colour", labels, "--out", table, "--picture", picture)
    assert result.returncode == 0, result.stderr
    assert "robotBlue" in result.stdout and "1.000 of 150 held out are right" in result.stdout
    assert picture.read_bytes()[:4] == b"\x89PNG"


def test_tables_are_converted_as_well(tmp_path):
    for words in (("ring", "2006"), ("colour", "nominal")):
        table = tmp_path / f"{words[0]}.kt"
        assert kelpie("calibrate", *words, "--out", table).returncode == 0
        assert f"{words[0]} table" in kelpie("calibrate", "show", table).stdout


@pytest.mark.parametrize("words, part", [
    (("ring", "no_such_folder"), "no_such_folder: no such folder or log"),
    (("colour", "no_such.csv"), "no_such.csv: cannot be opened"),
    (("colour", "no_such.txt"), "no_such.txt: cannot be opened"),
    (("shift", "no_such.csv"), "no_such.csv: cannot be opened"),
])
def test_what_is_not_there_is_one_line(words, part, tmp_path):
    result = kelpie("calibrate", *words, "--out", tmp_path / "out")
    assert result.returncode == 2
    assert part in complaint(result)
    assert not (tmp_path / "out").exists()


def test_one_sheet_a_short_file_and_an_empty_folder_are_one_line(sheets, tmp_path):
    out = tmp_path / "ring.kt"
    empty, one, short = (tmp_path / name for name in ("empty", "one", "short"))
    for folder in (empty, one, short):
        folder.mkdir()
    (one / "a.yuv").write_bytes(sheets[0])
    (short / "a.yuv").write_bytes(sheets[0][:PLANE])
    for folder, part in ((empty, "no .png, .yuv or .bin images"), (one, "one sheet cannot tell"),
                         (short, "33280 bytes, expected 99840")):
        result = kelpie("calibrate", "ring", folder, "--out", out)
        assert result.returncode == 2
        assert part in complaint(result)
    assert not out.exists()


def test_a_folder_in_place_of_a_table_is_named(tmp_path):
    for words in (("colour", tmp_path, "--out", tmp_path / "t"), ("show", tmp_path)):
        result = kelpie("calibrate", *words)
        assert result.returncode == 2
        assert f"{tmp_path}: cannot be read" in complaint(result)


def test_an_earlier_table_survives_a_picture_that_cannot_be_drawn(tmp_path):
    table = tmp_path / "t.kt"
    table.write_bytes(b"precious")
    result = kelpie("calibrate", "colour", "nominal", "--out", table, "--picture",
                    tmp_path / "none" / "t.png")
    assert result.returncode == 2 and "cannot be written" in complaint(result)
    assert table.read_bytes() == b"precious"


def test_labels_as_a_spreadsheet_writes_them_are_read(tmp_path):
    labels = tmp_path / "l.csv"
    labels.write_bytes("\ufeffY,Cr,Cb,class\r\n".encode() + b"74,191,99,0\r\n18,127,128,10\r\n" * 8)
    assert kelpie("calibrate", "colour", labels, "--out", tmp_path / "t").returncode == 0
    labels.write_text("Y,Cr,Cb,class\n74,191,99,0\n")
    result = kelpie("calibrate", "colour", labels, "--out", tmp_path / "u")
    assert result.returncode == 2 and "1 labelled pixels, too few" in complaint(result)
