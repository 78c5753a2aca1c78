# SPDX-License-Identifier: Apache-2.0
"""The studio's page (tools/studio/page): its own unit tests, and tests/studio_page in a browser,
both run by node. Skipped where the page is not built or there is no browser."""

import os
import shutil
import subprocess

import pytest
from conftest import BIN, ROOT

PAGE = ROOT / "tools" / "studio" / "page"
TESTS = ROOT / "tests" / "studio_page"


def run_node(words, cwd, seconds):
    environment = dict(os.environ, KELPIE=str(BIN / "kelpie"))
    return subprocess.run(words, cwd=cwd, env=environment, capture_output=True, text=True,
                          check=False, timeout=seconds)


@pytest.fixture(name="built", scope="module", autouse=True)
def built_page():
    if not (ROOT / "build/studio/page/index.html").exists() or not (PAGE / "node_modules").is_dir():
        pytest.skip("the studio's page is not built: tools/build studio")


def test_the_pages_units_do_what_they_say():
    result = run_node(["npx", "--no-install", "vitest", "run"], PAGE, 600)
    assert result.returncode == 0, result.stdout[-4000:] + result.stderr[-2000:]


@pytest.mark.parametrize("file", sorted(path.name for path in TESTS.glob("*.test.mjs")))
def test_in_a_browser(file):
    if not shutil.which("/usr/bin/chromium"):
        pytest.skip("Chromium is not on this machine: tools/install browser")
    result = run_node(["node", "--test", "--test-concurrency=1", TESTS / file], TESTS, 900)
    assert result.returncode == 0, result.stdout[-6000:] + result.stderr[-2000:]
