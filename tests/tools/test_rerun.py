# SPDX-License-Identifier: Apache-2.0
"""An exported match in Rerun's own page (tests/rerun): opened by a program that is not ours."""

import json
import shutil
import subprocess

import pytest
from conftest import BIN, ROOT, kelpie

HERE = ROOT / "tests" / "rerun"
CHROMIUM = "/usr/bin/chromium"


@pytest.fixture(name="page", scope="module")
def rerun_page():
    """The folder with Rerun's page, installed once."""
    if not shutil.which("npm") or not shutil.which("node"):
        pytest.skip("node or npm is not on this machine (tools/install studio)")
    if not shutil.which(CHROMIUM):
        pytest.skip("Chromium is not on this machine (tools/install browser)")
    folder = BIN.parent / "rerun"
    folder.mkdir(exist_ok=True)
    fresh = not (folder / "node_modules/.package-lock.json").exists()
    for name in ("package.json", ".npmrc", "open.mjs"):
        shutil.copy(HERE / name, folder / name)
    if fresh:
        subprocess.run(["npm", "install", "--no-audit", "--no-fund", "--loglevel=error"],
                       cwd=folder, check=True, timeout=600)
    return folder


def test_rerun_shows_camera_and_log_of_a_match_and_complains_of_nothing(match, page, tmp_path):
    viewer = tmp_path / "viewer.mcap"
    assert kelpie("export", match, "--out", viewer).returncode == 0
    result = subprocess.run(["node", "open.mjs", viewer, tmp_path / "page.png"], cwd=page,
                            capture_output=True, text=True, check=False, timeout=600)
    assert result.returncode == 0, result.stderr
    seen = json.loads(result.stdout)
    assert seen["source"] == "McapImporter" and seen["errors"] == []
    assert seen["span_s"] > 2.0
    camera, row = seen["camera"], seen["row"]
    assert camera["entity_path"] == "/red1/camera" and camera["view_name"].endswith("camera")
    assert 0 < camera["position"][0] < 208 and 0 < camera["position"][1] < 160
    assert row["entity_path"] in ("/referee", "/red1/log")
