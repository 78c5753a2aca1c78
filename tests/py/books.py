# SPDX-License-Identifier: Apache-2.0
# The two rule books that tests compare: a scene is put into one of them, and what differs is said.
import kelpie
import pytest

TASKS = {'kelpie': kelpie.RULES_OF_KELPIE, 'thesis': kelpie.RULES_OF_THESIS}


def by(made, book):
    """The same world, played by that book."""
    made.task.rules = TASKS[book]
    return made


def both(names, rows):
    """Parameters of a table of scenes: the scene's columns, then what the thesis answers and what
    Kelpie does; the test gets `book` and `answer` in their place."""
    cases = [(*row[:-2], book, row[-2 if book == 'thesis' else -1])
             for row in rows for book in TASKS]
    return pytest.mark.parametrize(f'{names}, book, answer' if names else 'book, answer', cases)
