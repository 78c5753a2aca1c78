# SPDX-License-Identifier: Apache-2.0
"""What robot/object/agent.ocf gives the robot's object: the one line that is no comment says name,
bytes of stack and bytes of a step of the heap, then its priority (openr.md section 1)."""

from pathlib import Path

OCF = Path(__file__).resolve().parents[2] / "robot/object/agent.ocf"


def in_bytes(text):
    return int(text[:-1]) * 1024 if text.endswith("K") else int(text)


def stack_and_heap():
    """In bytes."""
    line = next(line for line in OCF.read_text().splitlines() if line.startswith("object "))
    stack, heap = line.split()[2:4]
    return in_bytes(stack), in_bytes(heap)
