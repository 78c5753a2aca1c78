# SPDX-License-Identifier: Apache-2.0
# Whose rules are played where Kelpie's differ from those of the theses: every module that has both
# asks here, by the rule's name. docs/behaviours.md has a row of each with its section. Keeps
# nothing; world.task.rules says which book, and the switches of world.task hold in Kelpie's alone.
import kelpie


class Kelpie:
    """What Kelpie plays."""
    # The search for the ball (thesis 2006 section 6.2.2)
    SPIN_TIMES = 2.0           # times the turn of algorithm 6.2: the ball is in view sooner
    EXPLORES = True            # goes by what images showed: no ball there; and roams in the end
    BACKS_OFF_BRIEFLY = True   # and not from a ball that was sent away
    FORCES_LOOK = False        # where a kick sent the ball ("use force")
    SHARES_GAZE = True         # a landmark comes into the image beside the ball
    LEADS_BALL = True          # the head goes to where the ball will be when it gets there
    GLANCES = True             # an attacker looks at landmarks as it walks, besides section 4.3.2.4
    SPUN = 60                  # frames since a spin that are recent in section 4.3.2.4 (U02)
    APPROACHES_NEAR = False    # only a near ball is approached, in the words of section 4.3.2.4
    HEARS_OF_BALL = True       # who has lost the ball goes by where mates see it
    SEARCH_RESTS = True        # at its place in the team's search each spins for some seconds only
    # Roles and places (thesis 2006 sections 4.3.3, 4.4 and 4.5.2)
    HANDS_OVER = True          # a change of the attacker takes time, and the word of the other
    PAIR_SUPPORTS = True       # of two forwards one supports, the ball in the other half
    DEFENDER_STAYS = True      # the defender of the last frame has a bonus
    DEFENDER_SEES_WAY = False  # the time home counts obstacles and being stuck
    ON_STRING = True           # a place moves when its ball has moved some way
    LEAVES_WAYS = True         # a home in the attacker's way is moved
    RECEIVES = True            # who is to get a pass waits for it
    FEELS_HELD = True          # who is held backs off as from paws; nobody backs time and again
    ATTACKER_BACKS = True      # so does an attacker
    CHALLENGES = True          # the defender steps into the way of who runs with the ball
    ROUNDS_BOX = True          # an attacker goes round the own box to a ball beyond it, and
    ROUNDS_POSTS = True        # an attacker goes round a post to a ball behind it
    # The goalies (thesis 2006 section 4.3.1, thesis 2004 section 4.2)
    WATCHES_POSE = True        # doubts a pose that jumps or is lost, and surveys the landmarks then
    YIELDS = True              # leaves the ball to who has it; steps off one between its paws
    BLOCKS_LATE = True         # lies down only for what neither legs nor a side step reach
    CLEARS_BY_MAP = True       # by the best kick of the map
    ATTACKS_BRIEFLY = True     # for some seconds, and no fast ball
    SPARES_OWN_GOAL = True     # no walk or turn that takes a ball in; looks about for a near one
    DROPS_BACK = True          # nearer to the line for a near ball
    LOOKS_LOW = True           # at five low points in place of one, and first where it was lost
    PAW_KICK = False           # the goalie of 2004 clears by it
    # The challenger (thesis 2004 section 4.1.6)
    AIMS_BEHIND = False        # a point, so that it faces a feature in the end
    FEATURE_S = 1.0            # s of each look
    ALL_FEATURES = False       # at each in view, not only the best two
    THESIS = False

    # The ball, thesis 2006
    APPROACH_TURN = 2.0             # times the turn that section 6.3.3 walks at the ball with
    TURNS_TO_BALL = True            # section 6.3.3: on the spot to a ball far aside
    LIFTS_HEAD = False              # section 6.3.5: over the ball at first, turned to it
    HURRIES_GRAB = False            # section 6.3.5: by infrared also when the motion has begun
    GRABS_BEFORE_OWN_GOAL = True    # section 5.6: a contested ball on whose way the own goal lies
    STRIKES_FROM_EDGES = True       # section 5.4: a held ball, out of the edges or the corners only
    AIMS_BY_POSE_IN_FRONT = True    # section 6.4.2: in the front half, at a goal that is not seen
    SIGHT_COUNTS_ALONE = False      # Alg 6.6: frames that were aimed by the pose do not count
    SEARCHES_GOAL = False           # section 6.4.2: turns the shorter way to it, or to up-field
    SEARCH_SHARE = 2.0              # of the speed that section 6.4.2 turns at in search of the goal
    ONE_SPEED_BY_POSE = False       # section 6.4.2: also where the pose tells the goal's direction
    SPINS_UNTIL_SEEN = False        # section 6.4.2: no kick before time is out
    SPINS_AWAY = False              # Alg 6.8: from an own goal that was aimed at
    TURNS_AT_EDGE = True            # section 6.4.5: on the spot, or walks off it
    DODGES_BY_MAP = True            # section 6.4.4: also what was seen before
    STEPS_BACK = True               # from a ball that it let go, or kicked at somebody


class Thesis(Kelpie):
    """What the theses write, and where they are silent the least that works."""
    SPIN_TIMES = 1.0           # times
    EXPLORES = False
    BACKS_OFF_BRIEFLY = False
    FORCES_LOOK = True
    SHARES_GAZE = False
    LEADS_BALL = False
    GLANCES = False
    # A ball that comes into view 73 deg aside is straight ahead 66 frames later, at 0.9 /s.
    SPUN = 90                  # frames
    APPROACHES_NEAR = True
    HEARS_OF_BALL = False
    SEARCH_RESTS = False
    HANDS_OVER = False
    PAIR_SUPPORTS = False
    DEFENDER_STAYS = False
    DEFENDER_SEES_WAY = True
    ON_STRING = False
    LEAVES_WAYS = False
    RECEIVES = False
    FEELS_HELD = False
    ATTACKER_BACKS = False
    CHALLENGES = False
    ROUNDS_BOX = False
    ROUNDS_POSTS = False
    WATCHES_POSE = False
    YIELDS = False
    BLOCKS_LATE = False
    CLEARS_BY_MAP = False
    ATTACKS_BRIEFLY = False
    SPARES_OWN_GOAL = False
    DROPS_BACK = False
    LOOKS_LOW = False
    PAW_KICK = True
    AIMS_BEHIND = True
    FEATURE_S = 1.33           # s, 40 frames
    ALL_FEATURES = True
    THESIS = True

    APPROACH_TURN = 1.0             # times
    TURNS_TO_BALL = False
    LIFTS_HEAD = True
    HURRIES_GRAB = True
    GRABS_BEFORE_OWN_GOAL = False
    STRIKES_FROM_EDGES = False
    AIMS_BY_POSE_IN_FRONT = False
    SIGHT_COUNTS_ALONE = True
    SEARCHES_GOAL = True
    SEARCH_SHARE = 1.0              # times
    ONE_SPEED_BY_POSE = True
    SPINS_UNTIL_SEEN = True
    SPINS_AWAY = True
    TURNS_AT_EDGE = False
    DODGES_BY_MAP = False
    STEPS_BACK = False


def of(world) -> type[Kelpie]:
    """The rules of this match."""
    return Thesis if world.task.rules == kelpie.RULES_OF_THESIS else Kelpie


def by_kick_map(world) -> bool:
    """Whether kicks are chosen by the map of where they go (decisions/kick_map_choice.py)."""
    return not of(world).THESIS and world.task.kicks == kelpie.KICKS_BY_MAP


def intercepts(world) -> bool:
    """Whether a rolling ball is met where it will be."""
    return not of(world).THESIS and world.task.intercept


def grabs(world) -> bool:
    """Whether a ball is grabbed where the tree says so, or lined up for."""
    return of(world).THESIS or world.task.grab


def runs(world) -> bool:
    """Whether who attacks may run with the ball, pushed ahead of it, in place of a grab."""
    return not of(world).THESIS and world.task.run


def follows_play(world) -> bool:
    """Whether who does not play the ball stays near the play, and runs."""
    return not of(world).THESIS and world.task.positions == kelpie.POSITIONS_BY_PLAY


def dodges(world) -> bool:
    """Whether who stands in the way with the ball is gone round."""
    return of(world).THESIS or world.task.dodge


def aims_by_sight(world) -> bool:
    return of(world).THESIS or world.task.aiming == kelpie.AIMING_BY_SIGHT


def only_spins(world) -> bool:
    """Whether a lost ball is looked for by a spin alone."""
    return not of(world).THESIS and world.task.search == kelpie.SEARCH_BY_SPIN


def flies_home(world) -> bool:
    """Whether who is far from home goes there by Bird of Prey."""
    return of(world).THESIS or world.task.bird_of_prey


def finds_together(world) -> bool:
    """Whether a ball that the team lost is looked for by all of it."""
    return of(world).THESIS or world.task.distributed_find


def passes(world) -> bool:
    """Passing is work to come in the thesis (section 8.2)."""
    return not of(world).THESIS and world.task.passing


def score_aware(world) -> bool:
    """So is a goalie that minds the score (section 5.2)."""
    return not of(world).THESIS and world.task.score_aware
