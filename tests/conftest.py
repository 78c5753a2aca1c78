# SPDX-License-Identifier: Apache-2.0
"""What all pytest suites share: tests chosen by a regular expression, as ctest does it, an order in
which several processes end at about the same time, and no temporary files left behind."""

import re
import shutil

import pytest


def pytest_addoption(parser):
    parser.addoption("--only", default="", metavar="REGEX", help="tests whose FILE::NAME matches")
    parser.addoption("--but", default="", metavar="REGEX", help="no tests whose FILE::NAME matches")


def pytest_collection_modifyitems(config, items):
    only, but = config.getoption("only"), config.getoption("but")
    kept = [item for item in items if (not only or re.search(only, item.nodeid))
            and not (but and re.search(but, item.nodeid))]
    config.hook.pytest_deselected(items=[item for item in items if item not in kept])
    items[:] = kept
    if hasattr(config, "workerinput"):  # one of several processes: the short files come last
        items.sort(key=lambda item: item.nodeid.startswith("py/"))


@pytest.fixture(scope="session", autouse=True)
def removed_when_all_is_well(request, tmp_path_factory):
    """Recordings of matches are large (300 MB in all); pytest itself would keep three runs of
    them. They stay when a test failed."""
    yield
    if request.session.testsfailed == 0:
        shutil.rmtree(tmp_path_factory.getbasetemp(), ignore_errors=True)
