# SPDX-License-Identifier: Apache-2.0
"""What tools/check_sizes.py finds, and what it leaves alone."""
import sys

from conftest import ROOT

sys.path.insert(0, str(ROOT / "tools"))
import check_sizes  # noqa: E402


def test_a_folder_of_more_than_thirty_sources_is_named_and_one_of_thirty_is_not():
    full = [f"gps/pose/File{i}.cpp" for i in range(31)]
    assert list(check_sizes.full_folders(full)) == ["gps/pose: 31 sources, at most 30"]
    assert list(check_sizes.full_folders(full[1:])) == []


def test_what_lies_in_a_subfolder_is_not_counted_for_the_folder():
    assert list(check_sizes.full_folders([f"gps/{i % 2}/File{i}.h" for i in range(60)])) == []
