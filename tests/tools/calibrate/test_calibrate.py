# SPDX-License-Identifier: Apache-2.0
"""kelpie calibrate: tables from sheets, logs, labelled pixels and other tables."""

import math
import random
from pathlib import Path

import pytest
from conftest import PLANE, ROOT, complaint, kelpie, make_recording

RING_BYTES = 6 + 3 * 149 * 256  # of a ring table file, before its checksum: centres, channels
GENUINE = Path(ROOT).parent / "shared" / "data" / "frames-ers7"
CLASSES = "none, orange, blue, yellow, pink, robotBlue, robotRed, green, grey, white, black"
PAPERS = [(82, 121, 167), (189, 124, 129), (120, 160, 61)]


def sheet(paper, seed, loss=0.25):
    """Planes of a sheet that loses a quarter of its light towards the corners, with noise."""
    noise = random.Random(seed)
    planes = bytearray()
    for value in paper:
        for y in range(160):
            for x in range(208):
                d = math.hypot(x - 103.5, y - 79.5) / 130
                planes.append(max(0, min(255, round(value * (1 - loss * d * d)
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


def test_a_ring_table_that_helps_is_reported_without_a_warning(sheets, tmp_path):
    for i, planes in enumerate(sheets):
        (tmp_path / f"{i}.yuv").write_bytes(planes)
    result = kelpie("calibrate", "ring", tmp_path, "--out", tmp_path / "ring.kt")
    assert result.returncode == 0 and result.stderr == ""
    line = [line for line in result.stdout.splitlines() if line.startswith("unevenness")][0]
    assert "Y 0.1" in line and "2006: 1" in line and "none: 1" in line


def test_a_ring_table_worse_than_none_is_written_with_a_warning_of_levels(tmp_path):
    # The camera has no ring effect, and a heavy prior bends the table to that of 2006 all the same.
    for i, paper in enumerate(PAPERS):
        (tmp_path / f"{i}.yuv").write_bytes(sheet(paper, i, loss=0))
    table = tmp_path / "ring.kt"
    result = kelpie("calibrate", "ring", tmp_path, "--surface", "--prior", "5", "--out", table)
    assert result.returncode == 0, result.stderr
    reported = complaint(result)
    assert reported.startswith("kelpie: warning: the sheets look less even than before")
    for channel in ("Y 1", "Cr 1", "Cb 4"):
        assert channel in reported
    assert "2006: " in reported and "none: 0." in reported and result.stderr.count("\n") == 1
    assert "less even than before" in kelpie("calibrate", "show", table).stdout


@pytest.mark.skipif(not GENUINE.is_dir(), reason="../shared/data is not there: no genuine frames")
def test_three_busy_frames_teach_a_worse_table_than_2006_and_it_is_reported(tmp_path):
    result = kelpie("calibrate", "ring", GENUINE, "--surface", "--prior", "0.05", "--out",
                    tmp_path / "ring.kt")
    assert result.returncode == 0 and (tmp_path / "ring.kt").is_file()
    assert "Y 13." in complaint(result) and "2006: 10." in complaint(result)


@pytest.mark.parametrize("words, reported", [
    (("ring", "2006", "--surface"), "2006: is a table: --surface and --prior are for images"),
    (("ring", "none", "--prior", "0.1"), "none: is a table: --surface and --prior are for images"),
    (("ring", "2006", "--prior", "0"), "2006: is a table: --surface and --prior are for images"),
    (("ring", "2006", "--robot", "r1"), "--robot requires --shift"),
    (("colour", "nominal", "--seed", "3"), "--seed: only for labelled pixels"),
    (("colour", "labels.csv", "--ring", "none"), "--ring: only for a .txt of boxes"),
])
def test_an_option_without_effect_is_refused(words, reported, tmp_path):
    result = kelpie("calibrate", *words, "--out", tmp_path / "t.kt")
    assert result.returncode == 2
    assert reported in complaint(result)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("words", [("colour", "labels.csv", "--out", "labels.csv"),
                                   ("colour", "labels.csv", "--out", "t", "--picture",
                                    "labels.csv"),
                                   ("shift", "labels.csv", "--out", "labels.csv"),
                                   ("ring", "none", "--shift", "labels.csv", "--out", "labels.csv"),
                                   ("ring", "labels.csv", "--out", "labels.csv")])
def test_the_input_is_never_written_over(words, tmp_path):
    labels = tmp_path / "labels.csv"
    labels.write_text("precious")
    words = [labels if word == "labels.csv" else word for word in words]
    result = kelpie("calibrate", *words)
    assert result.returncode == 2 and "labels.csv: is the input itself" in complaint(result)
    assert labels.read_text() == "precious" and not (ROOT / "t").exists()


def test_the_help_alone_tells_what_a_file_of_labels_holds(tmp_path):
    text = kelpie("calibrate", "colour", "--help").stdout
    assert CLASSES in text and "3 yellow" in text and "\n  Y,Cr,Cb,class\n" in text
    rows = [line.strip() for line in text.splitlines() if line.strip().count(",") == 3]
    table = [row for row in rows if row == "Y,Cr,Cb,class" or row[0].isdigit()]
    (tmp_path / "l.csv").write_text("\n".join(table[:1] + table[1:] * 4) + "\n")
    assert len(table) == 3
    assert kelpie("calibrate", "colour", tmp_path / "l.csv", "--out",
                  tmp_path / "t.kt").returncode == 0


def test_a_table_is_the_same_from_names_as_from_numbers(tmp_path):
    for name, classes in (("names", ("orange", "black")), ("numbers", ("0", "10"))):
        rows = [f"{74 + i},191,99,{classes[0]}\n{18 + i},127,128,{classes[1]}" for i in range(9)]
        (tmp_path / f"{name}.csv").write_text("\n".join(["Y,Cr,Cb,class", *rows]) + "\n")
        assert kelpie("calibrate", "colour", tmp_path / f"{name}.csv", "--out",
                      tmp_path / name).returncode == 0
    tables = [(tmp_path / name).read_bytes()[-65540:-4] for name in ("names", "numbers")]
    assert tables[0] == tables[1] and len(set(tables[0])) > 1


@pytest.mark.parametrize("name, text", [("l.csv", "Y,Cr,Cb,class\n1,2,3,purple\n"),
                                        ("l.txt", "# boxes\na.png 0 0 9 9 purple\n")])
def test_an_unknown_class_is_one_line_with_file_line_and_the_classes(tmp_path, name, text):
    (tmp_path / name).write_text(text)
    result = kelpie("calibrate", "colour", tmp_path / name, "--out", tmp_path / "t.kt")
    assert result.returncode == 2
    assert f"{name}:2: no class 'purple', the classes are {CLASSES}" in complaint(result)


def test_ring_table_from_a_log_is_the_one_from_its_images(sheets, tmp_path):
    folder = make_recording(tmp_path / "recording", sheets)
    log = tmp_path / "sheets.mcap"
    assert kelpie("import", folder, "--out", log).returncode == 0
    for source, out in ((log, "a.kt"), (folder / "frames", "b.kt")):
        assert kelpie("calibrate", "ring", source, "--out", tmp_path / out).returncode == 0
    assert ring_data(tmp_path / "a.kt") == ring_data(tmp_path / "b.kt")


POINT = "decimal point (12.5, not 12,5)"
SHIFT = ("date,dog,mac_low4,base_dog,paper,y_dog,y_base_mean,u_dog,u_base_mean,v_dog,v_base_mean\n"
         "2005-07-12,r1,c6240000,b1,white,150,157.2,128,127.1,126,128.4\n")


@pytest.mark.parametrize("text, reported", [
    (SHIFT + SHIFT.splitlines()[1].replace(".", ","), f":3: 14 columns, expected 11; "),
    (SHIFT + SHIFT.splitlines()[1].replace(",", ";").replace(".", ","), ":3: 4 columns"),
    (SHIFT.replace("157.2", '"157,2"'), ":2: 12 columns, expected 11; "),
])
def test_a_decimal_comma_is_reported_with_its_line_and_what_to_write(text, reported, tmp_path):
    sheet = tmp_path / "pairs.csv"
    sheet.write_text(text)
    for words in (("shift", sheet), ("ring", "none", "--shift", sheet, "--robot", "r1", "--out",
                                     tmp_path / "x.kt")):
        line = complaint(kelpie("calibrate", *words))
        assert f"pairs.csv{reported}" in line and POINT in line


def test_a_sheet_of_semicolons_is_reported_at_its_header(tmp_path):
    (tmp_path / "pairs.csv").write_text(SHIFT.replace(",", ";").replace(".", ","))
    line = complaint(kelpie("calibrate", "shift", tmp_path / "pairs.csv"))
    assert "pairs.csv:1: the header must be" in line and "decimal point" in line


def test_a_decimal_comma_among_labelled_pixels_is_reported(tmp_path):
    (tmp_path / "l.csv").write_text("Y,Cr,Cb,class\n82,121,167,blue\n82,5,121,167,blue\n")
    result = kelpie("calibrate", "colour", tmp_path / "l.csv", "--out", tmp_path / "c.kt")
    assert result.returncode == 2 and "l.csv:3: 5 columns, expected 4; " in complaint(result)


def test_names_in_capitals_as_a_fat_stick_has_them_are_read(sheets, tmp_path):
    folder = tmp_path / "SHEETS"
    folder.mkdir()
    for i, planes in enumerate(sheets):
        (folder / f"FRAME{i:03d}.YUV").write_bytes(planes)
    ring = kelpie("calibrate", "ring", folder, "--out", tmp_path / "RING.KT")
    assert ring.returncode == 0, ring.stderr
    rows = [f"{40 * c + i},{100 + i},{120 + c},{name}\n" for c, name in
            enumerate(("orange", "blue", "green")) for i in range(30)]
    (tmp_path / "LABELS.CSV").write_text("Y,Cr,Cb,class\n" + "".join(rows))
    colour = kelpie("calibrate", "colour", tmp_path / "LABELS.CSV", "--seed", "2", "--out",
                    tmp_path / "C.KT", "--picture", tmp_path / "C.PNG")
    assert colour.returncode == 0 and "labelled pixels" in colour.stdout, colour.stderr
    assert (tmp_path / "C.PNG").read_bytes()[1:4] == b"PNG"


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
