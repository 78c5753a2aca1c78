# SPDX-License-Identifier: Apache-2.0
# Whose rules are played where Kelpie's differ from those of the theses: every module that has both
# asks here, by the rule's name. docs/behaviours.md has a row of each with its section. Keeps
# nothing; world.task.rules says which book, and the switches of world.task hold in Kelpie's alone.
import kelpie


class Kelpie:
    """What Kelpie plays."""
    THESIS = False

    # The ball, thesis 2006
    GRABS_BEFORE_OWN_GOAL = True    # section 5.6: a contested ball on whose way the own goal lies
    STRIKES_FROM_EDGES = True       # section 5.4: a held ball, out of the edges or the corners only


class Thesis(Kelpie):
    """What the theses write, and where they are silent the least that works."""
    THESIS = True

    GRABS_BEFORE_OWN_GOAL = False
    STRIKES_FROM_EDGES = False


def of(world) -> type[Kelpie]:
    """The rules of this match."""
    return Thesis if world.task.rules == kelpie.RULES_OF_THESIS else Kelpie


def by_kick_map(world) -> bool:
    """Whether kicks are chosen by the map of where they go (decisions/kick_map_choice.py)."""
    return not of(world).THESIS and world.task.kicks == kelpie.KICKS_BY_MAP


def intercepts(world) -> bool:
    """Whether a rolling ball is met where it will be."""
    return not of(world).THESIS and world.task.intercept


def aims_by_sight(world) -> bool:
    return of(world).THESIS or world.task.aiming == kelpie.AIMING_BY_SIGHT


def only_spins(world) -> bool:
    """Whether a lost ball is looked for by a spin alone."""
    return not of(world).THESIS and world.task.search == kelpie.SEARCH_BY_SPIN
