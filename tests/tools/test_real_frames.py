# SPDX-License-Identifier: Apache-2.0
"""Genuine ERS-7 frames through the whole pipeline with the table of 2005."""

import json
from pathlib import Path

import pytest
from conftest import ROOT, kelpie, make_recording

DATA = Path(ROOT).parent / "shared" / "data"
FRAMES = ["frame1_y_cr_cb_rows.bin", "frame3_y_cr_cb_rows.bin", "frame4_y_cr_cb_rows.bin"]

pytestmark = pytest.mark.skipif(not (DATA / "frames-ers7").is_dir(),
                                reason="../shared/data is not there: no genuine frames to read")


def planes_of(rows):
    """Rows of Y, Cr, Cb (208 bytes each) as three planes."""
    return b"".join(rows[624 * y + 208 * band:624 * y + 208 * band + 208]
                    for band in range(3) for y in range(160))


@pytest.fixture(scope="module", name="log")
def imported_log(tmp_path_factory):
    folder = tmp_path_factory.mktemp("genuine")
    frames = [planes_of((DATA / "frames-ers7" / name).read_bytes()) for name in FRAMES]
    make_recording(folder / "recording", frames)
    log = folder / "genuine.mcap"
    assert kelpie("import", folder / "recording", "--out", log, "--colour-table",
                  DATA / "colour" / "nnmc_2005.bin").returncode == 0
    return log


def test_the_whole_pipeline_runs_on_them(log):
    result = kelpie("replay", log, "--jsonl", "-")
    assert result.returncode == 0, result.stderr
    objects = [json.loads(line) for line in result.stdout.splitlines()]
    assert len(objects) == len(FRAMES)


def test_no_beacon_is_seen_where_there_is_none(log):
    result = kelpie("replay", log, "--jsonl", "-")
    kinds = [p["kind"] for line in result.stdout.splitlines()
             for p in json.loads(line)["percepts"]]
    assert not [kind for kind in kinds if kind.startswith("beacon")]
