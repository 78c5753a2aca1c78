# SPDX-License-Identifier: Apache-2.0
"""tools/check_layers.py refuses what the picture in docs/architecture.md forbids."""

import sys

from conftest import ROOT

sys.path.insert(0, str(ROOT / "tools"))
import check_layers  # noqa: E402


def test_a_stage_may_not_include_another():
    assert "gps may not include vision" in check_layers.wrong_include("gps/Localiser.cpp",
                                                                      "vision/Vision.h")


def test_a_finder_may_not_include_its_neighbour_but_what_it_stands_on():
    refused = check_layers.wrong_room("vision/ball/BallFinder.cpp", "vision/goal/GoalFinder.h")
    assert refused == "subfolder vision/ball may not include vision/goal"
    assert check_layers.wrong_room("vision/ball/BallFinder.cpp", "vision/blobs/Blobs.h") is None
    assert check_layers.wrong_room("vision/pixels/Sampler.h", "vision/blobs/Blobs.h") is not None
    assert check_layers.wrong_room("vision/Vision.cpp", "vision/goal/GoalFinder.h") is None


def test_a_header_and_its_source_are_one_unit_of_a_circle():
    graph = {"a": {"b"}, "b": {"c"}, "c": {"a"}, "d": {"a"}, "e": set()}
    assert check_layers.circles_of(graph) == [["a", "b", "c"]]
    assert check_layers.circles_of({"a": {"b"}, "b": set()}) == []
    assert check_layers.unit_of("gps/Modes.h") == check_layers.unit_of("gps/Modes.cpp")


def test_tests_take_nothing_from_the_command_line():
    assert check_layers.wrong_include("tests/gps/BallTest.cpp", "tools/cli/log/Logs.h")
    assert check_layers.wrong_include("tests/gps/BallTest.cpp", "tools/sim/world/World.h") is None
