# SPDX-License-Identifier: Apache-2.0
"""toolchain/host-cost: what vision and gps take for each frame of a log, counted under valgrind."""

import json
import os
import re
import shutil
import subprocess

import pytest

from conftest import BIN, ROOT, kelpie

SECONDS = 1
HAS_VALGRIND = shutil.which("valgrind") is not None
needs_valgrind = pytest.mark.skipif(not HAS_VALGRIND,
                                    reason="no valgrind on this machine (tools/install cost)")


def host_cost(*words, **env):
    return subprocess.run([ROOT / "toolchain/host-cost", *map(str, words)], capture_output=True,
                          text=True, timeout=500, check=False,
                          env={**os.environ, "KELPIE_BIN": str(BIN), **env})


@pytest.fixture(scope="module", name="log")
def second_of_play(tmp_path_factory):
    out = tmp_path_factory.mktemp("cost")
    kelpie("play", "--seconds", SECONDS, "--seed", 1, "--no-film", "--out", out)
    assert (out / "match.mcap").exists()
    return out / "match.mcap"


@needs_valgrind
def test_each_frame_is_counted_of_vision_and_gps(log, tmp_path):
    result = host_cost(log, "--json", tmp_path / "cost.json")
    assert result.returncode == 0, result.stderr
    cost = json.loads((tmp_path / "cost.json").read_text())
    # Wide: that a stage was counted, and no other with it.
    for stage, least, most in (("vision", 3e5, 3e6), ("gps", 3e4, 1e6)):
        assert cost[stage]["frames"] == SECONDS * 30
        assert least < cost[stage]["instructions"] <= cost[stage]["most"] < 10 * most
        assert cost[stage]["instructions"] < most
        line = (f"{stage}: {cost[stage]['instructions']} instructions a frame, most "
                f"{cost[stage]['most']} ({SECONDS * 30} frames)")
        assert line in result.stdout.splitlines()


@needs_valgrind
def test_what_is_no_log_is_one_line(tmp_path):
    (tmp_path / "none.mcap").write_text("no log")
    result = host_cost(tmp_path / "none.mcap")
    assert result.returncode == 2
    assert re.fullmatch(r"host-cost: \S+none.mcap: cannot be measured: .+\n", result.stderr)
    result = host_cost(tmp_path / "nothing.mcap")
    assert (result.returncode, result.stderr) == (
        2, f"host-cost: {tmp_path}/nothing.mcap: no log\n")


def test_without_valgrind_or_program_or_with_a_wrong_option_it_says_so(tmp_path):
    for name in ("bash", "dirname"):
        (tmp_path / name).symlink_to(shutil.which(name))
    result = host_cost(PATH=str(tmp_path))
    assert (result.returncode, result.stderr) == (2, "host-cost: needs valgrind\n")
    result = host_cost(KELPIE_BIN=str(tmp_path))
    assert result.returncode == 2 and "run tools/build host kelpie-target" in result.stderr
    result = host_cost("--seeds", "1")
    assert (result.returncode, result.stderr) == (2, "host-cost: unknown option --seeds\n")


def test_the_counted_program_has_none_of_the_libraries_of_pictures():
    """An older valgrind does not know the instructions with which libhwy, of them, begins."""
    linked = subprocess.run(["ldd", BIN / "kelpie-target"], capture_output=True, text=True,
                            check=True).stdout
    assert "libpython3" in linked and not re.search(r"libhwy|libjxl|libavcodec|libcairo", linked)
