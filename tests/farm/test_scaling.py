# SPDX-License-Identifier: Apache-2.0
# The farm's own cost, with workers that only wait.
import pytest

pytest.importorskip('distributed', reason='no Dask: tools/install farm')

from farm.scaling import scaling  # noqa: E402


def test_every_match_is_played_and_no_worker_plays_more_than_time_allows():
    told = scaling(3, 0.5)
    assert (told['workers'], told['matches'], told['seconds']) == (3, 12, 0.5)
    assert told['took'] >= 2.0          # four matches, one after the other, for each worker
    assert 0.0 < told['efficiency'] <= 1.0
    assert told['overhead_ms'] > 0.0
