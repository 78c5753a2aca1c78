# SPDX-License-Identifier: Apache-2.0
# Which role a forward plays (thesis 2006 section 4.4, algorithms 4.5 and 4.6): attacker, else
# defender, else striker, from its own time to the ball and what its mates sent. Every forward
# decides for itself; goalies take no part, and who was silent for 1.5 s is out. RoleChoice keeps
# the role, why, and when it last knew of an attacker. It fails where messages do: two attackers, or
# none, last as long as a message is late.
import math

import kelpie
from decisions import positions
from lib import rulebook
from lib.paths import SILENT_S
from situation import time_to

CONSTANTS = kelpie.constants.roles  # behaviour/constants.toml: defaults and ranges
SEES_S = 0.5         # s; facts-2005 section 7.1: "lost" for a ball that vision sees no more
TIE_S = 0.06         # s; times that alike are a tie (symmetry break of facts-2005 section 7.1)
# s without an attacker in which the quickest alone takes the ball: who gave it up, and a third who
# saw that, wait until it has said so. Else a far robot attacks for 0.1 s at each change.
HAND_OVER_S = 0.5
# Ours: a mate takes the ball over when it has been quicker for so long, and who attacks gives it up
# when the mate has said so: of a match 1.7 % had no attacker while it was only expected to.
CHALLENGE_S = 0.15
HOME_S = CONSTANTS.home  # bonus of the defender of the last frame (facts-2005 section 7.1)
EVERY_FRAMES = 3     # a tenth of a second: the team is informed at 6 Hz
NAMES = kelpie.ROLE_NAMES
BEHIND = 3           # goals

Answer = tuple       # whether, the reason, its numbers


def forwards(world) -> list:
    """The mates that count: heard, and neither goalies nor without a role, as the penalised."""
    return [mate for mate in world.teammates
            if mate.seconds_since_heard < SILENT_S and
            mate.note.role not in (kelpie.KEEPER, kelpie.NO_ROLE)]


def should_attack(own, mates) -> Answer:
    """Algorithm 4.6, its tests in their order. Line 5 as the text has it: no attacker sees the ball
    (checklist G17); as listed, the closest and who grabs would both be attackers."""
    attackers = [mate for mate in mates if mate.note.role == kelpie.ATTACKER]
    if not attackers and not own.attacked:
        return True, 'there is no attacker'
    blind = attackers and not any(sees(mate) for mate in attackers)
    if blind and own.sees and all(own.distance < mate_distance(own, mate) for mate in mates):
        return True, 'the attacker does not see the ball, {} cm away', own.distance
    if own.started:
        return True, 'it grabs the ball or holds it'
    if not mates:
        return True, 'there is no other'
    quickest = min(mates, key=lambda mate: (mate.note.time_to_ball, mate.player))
    theirs = quickest.note.time_to_ball
    if own.seconds > theirs + TIE_S:
        return False, 'player {} needs {} s, itself {} s', quickest.player, theirs, own.seconds
    for mate in mates:
        if mate.note.time_to_ball < own.seconds + TIE_S and mate.player < own.player:
            return False, 'a tie, and player {} is the first', mate.player
    return True, 'needs {} s, the next {} s', own.seconds, theirs


def should_defend(own, mates, home) -> Answer:
    """Section 4.4.2: of those who do not attack, who is sooner at the defender's home. One mate
    attacks: while two say so, or none, as the ball is handed over, the quicker one."""
    attackers = [mate for mate in mates if mate.note.role == kelpie.ATTACKER]
    one = min(attackers or mates, key=lambda mate: (mate.note.time_to_ball, mate.player))
    others = [mate for mate in mates if mate.player != one.player]
    mine = own.seconds_to(home) - own.bonus(own.defended)
    for mate in others:
        theirs = own.seconds_to(home, mate) - own.bonus(mate.note.role == kelpie.DEFENDER)
        if theirs < mine - TIE_S or (theirs < mine + TIE_S and mate.player < own.player):
            return False, 'player {} is home in {} s, itself in {} s', mate.player, theirs, mine
    return True, 'is home in {} s', mine


def sees(mate) -> bool:
    """Whether it sees the ball; one that holds it has it under its chin."""
    return mate.seconds_since_ball < SEES_S or mate.note.grabs == kelpie.HOLDS


def mate_distance(own, mate) -> float:
    """cm from a mate to the ball."""
    place = mate.pose.position
    return math.hypot(place.x - own.ball[0], place.y - own.ball[1])


class Own:
    """What algorithm 4.6 asks of oneself. `ball`: on the field, or None; `last`: its last role."""

    def __init__(self, world, memory, last):
        self.world, self.rules = world, rulebook.of(world)
        self.player, self.pose = world.game.player, world.pose
        self.attacked, self.defended = last == kelpie.ATTACKER, last == kelpie.DEFENDER
        grabs = time_to.grabs_now(world, memory)
        self.started = memory.grab_lost <= 1   # an approach has its bonus, and may be given up
        self.ball = time_to.ball_of(world, memory.ball_lost)
        self.seconds = time_to.to_ball(world, memory.ball_lost, self.attacked,
                                       grabs != kelpie.GRABS_NOT)
        self.sees = memory.ball_lost <= time_to.SURE_FRAMES and world.ball.present
        self.distance = world.ball.distance

    def seconds_to(self, point, mate=None) -> float:
        """To a point of the field, for itself or a mate."""
        if not self.rules.DEFENDER_SEES_WAY:
            return time_to.of_pose(mate.pose if mate is not None else self.pose, point)
        if mate is None:
            return time_to.to_point(self.world, point)
        return time_to.of_mate(self.world, mate, point)

    def bonus(self, defended) -> float:
        """Of the defender of the last frame, in s."""
        return HOME_S if defended and self.rules.DEFENDER_STAYS else 0.0


class RoleChoice:
    def __init__(self):
        self.role = kelpie.ATTACKER   # whoever is alone attacks
        self.why = ('there is no attacker',)
        self.seconds = time_to.NEVER_S  # to the ball, as the team hears it
        self.frames = 0               # since the last choice
        self.attacker_s = -math.inf   # when somebody attacked last
        self.quicker_s = None         # since when it is quicker than who attacks
        self.heard = []               # who attacks, as the team said last

    def update(self, world, memory, bound=False) -> int:
        """The role, chosen every third frame. `bound`: it attacks and may not be interrupted."""
        heard = [mate.player for mate in world.teammates if mate.note.role == kelpie.ATTACKER]
        self.frames -= 1
        if self.frames > 0 and heard == self.heard:
            return self.role
        self.heard = heard
        self.frames = EVERY_FRAMES
        own = Own(world, memory, self.role)
        self.seconds = own.seconds
        mates = forwards(world) if len(world.teammates) > 0 else ()
        if not mates or bound:
            self.take(kelpie.ATTACKER, ('there is no other',) if not mates else
                      ('what it does may not be interrupted',))
            return self.role
        yes, *why = should_attack(own, mates)
        if own.attacked or any(mate.note.role == kelpie.ATTACKER for mate in mates):
            self.attacker_s = world.time_s
        elif yes and self.leaves_it(world, own, mates):
            yes, why = False, ['a quicker mate takes the ball']
        if yes == own.attacked:
            self.quicker_s = None
        elif own.rules.HANDS_OVER and not own.started:
            yes, why = self.handed_over(world, own, mates, yes, why)
        if yes:
            self.take(kelpie.ATTACKER, why)
        else:
            self.take(*self.other(world, own, mates, why))
        return self.role

    def leaves_it(self, world, own, mates) -> bool:
        """Nobody attacks, but somebody did just now, and a mate is quicker."""
        just_now = own.rules.HANDS_OVER and world.time_s - self.attacker_s < HAND_OVER_S
        return (just_now and not own.started and
                any(mate.note.time_to_ball < own.seconds - TIE_S for mate in mates))

    def handed_over(self, world, own, mates, yes, why):
        """Whether it attacks when the rules would have that change."""
        if not yes:
            claimed = any(mate.note.role == kelpie.ATTACKER and
                          mate.note.time_to_ball <= own.seconds + TIE_S for mate in mates)
            return (False, why) if claimed else (True, ['no quicker mate has said that it attacks'])
        if not self.heard:
            return True, why
        if self.quicker_s is None:
            self.quicker_s = world.time_s
        if world.time_s - self.quicker_s < CHALLENGE_S:
            return False, ['quicker than who attacks, but only just now']
        self.quicker_s = None
        return True, why

    def other(self, world, own, mates, why):
        """The rest of algorithm 4.5. Without a ball to go by it stays what it is."""
        if own.ball is None:
            last = self.role if self.role != kelpie.ATTACKER else kelpie.STRIKER
            return last, why
        in_their_half = own.ball[1] > 0.5 * world.field.length
        if own.rules.PAIR_SUPPORTS and len(mates) == 1 and in_their_half:
            # Ours: two forwards that attack need one behind the ball, not one far back.
            return kelpie.SUPPORTER, ('the only other, the ball in their half',)
        yes, *home = should_defend(own, mates, positions.defender(world.field, own.ball))
        return (kelpie.DEFENDER if yes else kelpie.STRIKER), home

    def take(self, role, why):
        self.role, self.why = role, tuple(why)


def goes_forward(world) -> bool:
    """Whether a goalie plays as a forward does (thesis 2006 section 5.2): when its team is behind
    by more than three goals. A switch, since an empty goal costs more than one attacker gains in
    any closer match."""
    game, task = world.game, world.task
    return (rulebook.score_aware(world) and task.player in (kelpie.GOALIE, kelpie.GOALIE_2004) and
            game.opponent_score - game.own_score > BEHIND)
