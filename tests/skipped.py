#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""skipped.py FILE: names the skipped tests of a JUnit file that ctest wrote, each with its reason:
GoogleTest's message of GTEST_SKIP, or the line that begins with "skipped:"."""

import re
import sys
import xml.etree.ElementTree as ElementTree


def reason_of(output):
    reason = (re.search(r"^skipped: *(.+)$", output, re.M)
            or re.search(r": Skipped\n(.+)$", output, re.M))
    return reason[1].strip() if reason else "gives no reason"


def skipped_tests(path):
    """(name, reason) of each."""
    for case in ElementTree.parse(path).iter("testcase"):
        if case.find("skipped") is not None:
            yield case.get("name"), reason_of(case.findtext("system-out") or "")


def main():
    found = list(skipped_tests(sys.argv[1]))
    if found:
        print(f"\n{len(found)} skipped:")
    for name, reason in found:
        print(f"  {name}: {reason}")


if __name__ == "__main__":
    main()
