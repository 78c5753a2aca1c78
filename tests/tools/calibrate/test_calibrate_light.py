# SPDX-License-Identifier: Apache-2.0
"""What a table's light looks like, beside the table; and whether the camera fits the light."""

import tomllib

import pytest
from conftest import complaint, kelpie, make_recording

SURFACES = {"carpet": ("green", (46, 113, 109)), "line": ("white", (113, 126, 129)),
            "blue": ("blue", (49, 124, 151)), "yellow": ("yellow", (72, 147, 88)),
            "pink": ("pink", (68, 167, 126))}


def write_labels(path, classes=tuple(SURFACES)):
    rows = ["Y,Cr,Cb,class"]
    for name in classes:
        label, (y, cr, cb) = SURFACES[name]
        rows += [f"{y + i % 5 - 2},{cr},{cb},{label}" for i in range(40)]
    path.write_text("\n".join(rows) + "\n")
    return path


@pytest.fixture(name="table")
def table_of_labels(tmp_path):
    table = tmp_path / "my.tab"
    result = kelpie("calibrate", "colour", write_labels(tmp_path / "l.csv"), "--out", table)
    assert result.returncode == 0, result.stderr
    assert f"{table}.toml: parameters, for --params" in result.stdout
    return table


def test_beside_a_table_stands_what_its_surfaces_look_like(table):
    light = tomllib.loads(table.with_name("my.tab.toml").read_text())["vision"]["light"]
    assert light.pop("follow") is True and light.keys() == SURFACES.keys()
    for name, (_, painted) in SURFACES.items():
        found = [float(light[name][key].removesuffix("levels")) for key in ("y", "cr", "cb")]
        assert all(abs(a - b) <= 1 for a, b in zip(found, painted)), name


def difference(root, *words):
    """Where the configuration of these options differs from the stick's."""
    result = kelpie("stick", "--robot", "1", "--diff", root, *words)
    assert result.returncode == 0, result.stderr
    return result.stdout


def mounted(root):
    for name in ("APERIOS.GZ", "APERINIT.GZ", "BOOTPARA", "SYSTEM/OBJS/A.BIN",
                 "SYSTEM/CONF/CARDDRV.CFG"):
        (root / "OPEN-R" / name).parent.mkdir(parents=True, exist_ok=True)
        (root / "OPEN-R" / name).write_text("Sony's")


def test_the_light_is_followed_with_table_and_file_and_not_with_the_table_alone(table, tmp_path):
    root = tmp_path / "stick"
    assert kelpie("stick", "--robot", "1", "--colour-table", table, "--out",
                  root).returncode == 0
    mounted(root)
    alone = ("--colour-table", table)
    both = (*alone, "--params", f"{table}.toml")
    same = "the configuration is the same"
    assert same in difference(root, *alone)
    assert same in difference(root, *alone, "--set", "vision.light.follow=false")
    assert "differs, first in vision.light.follow" in difference(root, *both)
    back = difference(root, *both, "--set", "vision.light.follow=false")
    assert "differs, first in vision.light.carpet.y" in back


def test_labels_without_a_surface_give_a_table_that_stays_as_it_is(table, tmp_path):
    few = write_labels(tmp_path / "few.csv", ("carpet", "line", "blue", "yellow"))
    result = kelpie("calibrate", "colour", few, "--out", table)
    assert result.returncode == 0 and result.stderr == ""
    assert "0 pixels are labelled pink, 20 tell its colour: so with this table" in result.stdout
    assert "my.tab.toml: removed, it was of another table" in result.stdout
    assert table.exists() and not table.with_name("my.tab.toml").exists()


def test_the_nominal_table_keeps_its_light_and_one_from_a_file_has_none(table, tmp_path):
    nominal = tmp_path / "nominal.tab"
    assert kelpie("calibrate", "colour", "nominal", "--out", nominal).returncode == 0
    assert 'y = "77levels"' in (tmp_path / "nominal.tab.toml").read_text()
    result = kelpie("calibrate", "colour", table, "--out", tmp_path / "again.tab")
    assert "a table does not tell what its surfaces look like" in result.stdout
    assert not (tmp_path / "again.tab.toml").exists()


def test_labels_under_the_name_of_the_file_of_parameters_are_not_written_over(tmp_path):
    labels = write_labels(tmp_path / "my.csv")
    labels = labels.rename(tmp_path / "t.toml")
    result = kelpie("calibrate", "colour", labels, "--out", tmp_path / "t")
    assert result.returncode == 2 and "t.toml: is the input itself" in complaint(result)


def field(gain, line=(189, 124, 129), paint=(77, 103, 97)):
    """Planes of a carpet with lines five rows wide."""
    planes = bytearray()
    for channel in range(3):
        for row in range(160):
            value = (line if row % 40 < 5 and row > 30 else paint)[channel]
            neutral = 128 if channel else 0
            planes += bytes([min(255, round(neutral + gain * (value - neutral)))]) * 208
    return bytes(planes)


def light_of(folder, planes, *words):
    log = folder / "venue.mcap"
    recording = make_recording(folder / "recording", [planes, planes])
    made = kelpie("import", recording, "--ring", "none", "--out", log, *words)
    assert made.returncode == 0, made.stderr
    result = kelpie("calibrate", "light", log)
    assert result.returncode == 0, result.stderr
    return result.stdout.splitlines()


def test_a_light_that_fits_is_said_to_be_right(tmp_path):
    lines = light_of(tmp_path, field(1))
    assert lines[0].startswith("images      2, taken with whiteBalance = 3 (fluorescent), gain = 3")
    assert "0.0 % of the pixels at most 5, 0.0 % at least 250" in lines[1]
    assert "Cr 103 Cb 97, chroma at -129 deg, expected -129" in lines[2]
    assert "Y 189 Cr 124 Cb 129" in lines[3] and lines[4] == "the setting is right"


@pytest.mark.parametrize("gain, line, camera, said", [
    (0.4, (189, 124, 129), "", "too dark; next: shutter = 2 (mid)"),
    (0.4, (189, 124, 129), "gain = 1", "too dark; next: gain = 2 (mid)"),
    (0.4, (189, 124, 129), "shutter = 1", "no further setting"),
    (1.4, (189, 124, 129), "", "too bright; next: gain = 2 (mid)"),
    (1.4, (189, 124, 129), "shutter = 1", "too bright; next: shutter = 2 (mid)"),
    (1, (180, 175, 73), "", "warmer than the setting; next: whiteBalance = 1 (indoor)"),
    (1, (180, 114, 152), "", "colder than the setting; next: whiteBalance = 2 (outdoor)"),
])
def test_the_setting_to_take_next_is_named(gain, line, camera, said, tmp_path):
    (tmp_path / "camera.toml").write_text(f"[camera]\n{camera}\n")
    lines = light_of(tmp_path, field(gain, line), "--params", tmp_path / "camera.toml")
    assert said in lines[-1]


def test_a_setting_that_no_camera_has_is_one_line(tmp_path):
    (tmp_path / "camera.toml").write_text("[camera]\ngain = 4\n")
    result = kelpie("stick", "--robot", "1", "--params", tmp_path / "camera.toml", "--out",
                    tmp_path / "s")
    assert result.returncode == 2
    assert "camera.toml:2: camera.gain: 4 is outside 1..3" in complaint(result)


def test_no_log_and_a_log_without_images_are_one_line(tmp_path):
    assert "none.mcap" in complaint(kelpie("calibrate", "light", tmp_path / "none.mcap"))
    kelpie("play", "--seconds", "1", "--no-film", "--images", "planes", "--out", tmp_path)
    result = kelpie("calibrate", "light", tmp_path / "match.mcap")
    assert result.returncode == 2 and "no image is kept in it" in complaint(result)
