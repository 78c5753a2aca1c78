# SPDX-License-Identifier: Apache-2.0
# Grabs the ball, turns with it to the goal, carries it on where that helps, goes around who stands
# in the way, and kicks it within what the rules allow (thesis 2006 section 6.4). The plan is the
# decision tree's leaf. Keeps the state, the grab, the hold and the aim. `choose` answers, of an
# aimed or overdue hold, which kick; it is given by the role, since choices are made above skills.
# It fails, and says so, when the ball was not caught or slips out.
import math

import kelpie
from arbiter.machine import Machine
from lib import hints, rulebook
from lib.geom import clamp, from_field, heading, wrap
from situation.aim import Aim
from situation.goal import UP_FIELD_DEG
from situation.infrared import somebody_near
from skills.ball.dodge import Dodge, in_the_way
from skills.ball.grab import Grab
from skills.ball.hold import FORWARD_SPEED, SIDE_SPEED, TURN_SPEED, Hold, carry
from skills.head.track_ball import TrackBall
from skills.motion.kick import Kick
from skills.motion.release import Release
from skills.walk.step_back import StepBack

CONSTANTS = kelpie.constants.dribble  # behaviour/constants.toml: defaults and ranges
TIME_MARGIN = CONSTANTS.time_margin  # s that are left of the rules' clock (skills/ball/grab.py);
                        # a grabbed ball lies in the arms 0.1 s after it was asked for, a stop
                        # takes 0.4 s at most and a kick 0.41 until the ball is gone: 2.9 of 3 s
BLOCKED_MARGIN = 1.3    # s of it with somebody ahead, where the kicks of the map are used: three
                        # of five against who is within 25 cm leave the ball in the arms
WAY_MARGIN = 15.0       # cm less by odometry from the place of the grab than the rules allow; a
                        # stop takes 6
SETTLE = 0.13           # s after the grab
FEEL = 0.5              # s within which a caught ball is felt (docs/physical-body.md: 0.22)
STEADY = 0.17           # s that it stands before a kick,
STEADY_MAX = 0.4       # s at most until it is still:
STILL = 5.0             # cm/s,
STILL_TURN = 15.0       # deg/s; out of a turn balls went 6 deg off, out of a
                                  # walk half as far
TURN_GAIN = 4.0         # deg/s per deg
MIN_TURN = 25.0         # deg/s: the dribble walk hardly turns slower
DELAY = 0.13            # s from a command to the body's turn
CARRY_UNTIL = CONSTANTS.carry_until  # s: later there is no time for a way that matters
CARRY_TO = CONSTANTS.carry_to  # cm to the goal from which carrying on helps no more: of 52
                        # kicks from up to 90 cm 9 were goals, of 44 from 90 to 120 one
CARRY_FROM = CONSTANTS.carry_from  # cm beyond which a kick does not reach the goal anyway
SEARCH_Y = 400.0        # cm; from here on the goal is turned for more slowly (G39)
SEARCH_TURN = 50.0  # deg/s,
SEARCH_TURN_FRONT = 40.0  # deg/s as the thesis has it,
OVER_TURN_Y = 200.0     # cm; up to here a goal that the pose faces and nobody sees is turned on for
OVER_TURN = CONSTANTS.over_turn  # frames (at most 50 in facts-2005 section 7.2): 13 deg, a pose's
                        # error
EDGE = 22.0             # cm from a line: move away from it before anything else
OFF_EDGE = 6.0          # cm farther, where that is walked
STOP_INSIDE = 45.0      # cm from the lines: a ball that is carried back is let go there
LOOKS_IN = 0.5          # cosine of the way in: who looks within 60 deg of it is turned to nothing
OWN_GOAL_FRAMES = 5     # since the own goal was seen that count as seeing it


def turn_towards(world, degrees) -> float:
    """deg/s that end the turn at that heading, the way it still goes counted."""
    rate = world.odometry.turn_deg / max(world.elapsed_s, 0.02)
    left = degrees - DELAY * clamp(rate, -TURN_SPEED, TURN_SPEED)
    wanted = clamp(TURN_GAIN * left, -TURN_SPEED, TURN_SPEED)
    if abs(wanted) < MIN_TURN:
        wanted = math.copysign(MIN_TURN, wanted) if abs(left) > 1.5 else 0.0
    return wanted


def search_speed(world) -> float:
    """deg/s of the turn in search of the goal."""
    speed = SEARCH_TURN if world.pose.position.y < SEARCH_Y else SEARCH_TURN_FRONT
    return rulebook.of(world).SEARCH_SHARE * speed


def way_to_goal(world) -> float:
    """deg of the shorter turn to where the pose has the goal, or to up-field."""
    if rulebook.of(world).SEARCHES_GOAL:
        return heading(*from_field(world.pose, 0.5 * world.field.width, world.field.length))
    return wrap(UP_FIELD_DEG - world.pose.heading_deg)


def lines_from(world) -> tuple[float, float, float, float]:
    """cm from the ball in the arms to the left, right, bottom and top line; the goal's mouth is
    none."""
    field, angle = world.field, math.radians(world.pose.heading_deg)
    x = world.pose.position.x + 8.0 * math.cos(angle)
    y = world.pose.position.y + 8.0 * math.sin(angle)
    before_goal = abs(x - 0.5 * field.width) < 0.5 * field.goal_width
    return x, field.width - x, y, math.inf if before_goal else field.length - y


class GrabDribble(Machine):
    NAME = 'grab_dribble'

    def __init__(self, memory, choose, plan='grab_dribble_goal'):
        super().__init__(self.grab, Grab(memory))
        self.memory = memory
        self.choose = choose
        self.plan = plan
        self.aim = Aim()
        self.track = TrackBall(memory)
        self.hold = None
        self.searched = 0         # frames of the search turn
        self.search_side = 1.0
        self.turn_side = memory.spin_side   # of the last turn, +1 left
        self.over_turned = 0      # frames beyond what the pose says
        self.lost_ball = False
        self.steps_back = False   # after the kick: the ball may lie where it was

    @property
    def committed(self) -> bool:
        if self.done:
            return False
        return self.hold is not None or self.skill.committed

    @property
    def standing(self) -> bool:
        """It has stopped turning for a kick."""
        return self.state == self.steady

    @property
    def done(self) -> bool:
        return self.state == self.ended

    def step(self, world) -> kelpie.Command:
        self.approached, self.grabbed, self.hint = False, False, None
        leaves = (self.kick, self.release, self.step_back, self.ended)
        if self.hold is not None and self.state not in leaves:
            self.keep(world)
        return super().step(world)

    def keep(self, world):
        """What goes on in all states with the ball: its rules and whether it is still there."""
        self.hold.update(world)
        self.grabbed = True
        self.aim.update(world)
        if self.hold.slipped:
            self.give_up(world, 'nothing is felt of the ball')
        elif self.state == self.overdue:
            return
        elif self.out_of_time(world):
            self.enter(world, self.overdue, None, 'held {} s', self.hold.seconds(world))
        elif self.hold.way > world.field.rules.holding_distance - WAY_MARGIN:
            self.enter(world, self.overdue, None, 'carried {} cm', self.hold.way)

    def out_of_time(self, world) -> bool:
        """Sooner with somebody ahead, unless it stands for a kick already or turns in from an
        edge."""
        left = world.field.rules.holding_time - self.hold.seconds(world)
        if left < TIME_MARGIN:
            return True
        sooner = (rulebook.by_kick_map(world) and
                  self.state not in (self.settle, self.steady, self.off_edge))
        return sooner and left < BLOCKED_MARGIN and in_the_way(world)

    def overdue(self, world):
        """The rules leave no more time: it stands, then kicks whatever it sees of the goal, or
        lets the ball go."""
        if not self.still(world):
            return carry()
        return self.fire(world, self.choose(world, self, True))

    def give_up(self, world, why, *numbers):
        self.lost_ball = True
        distance, off_deg = hints.of_dribble(-1.0 if self.turn_side < 0.0 else 1.0)
        self.hint = distance, off_deg if abs(self.hold.turned) > 20.0 else 0.0
        return self.enter(world, self.ended, None, why, *numbers)

    # States

    def grab(self, world):
        command, skill = self.skill.step(world), self.skill
        self.approached, self.grabbed, self.hint = skill.approached, skill.grabbed, skill.hint
        if self.skill.done:
            self.hold = Hold(world, self.skill.begun_s)
            self.enter(world, self.settle, None, 'the grab is over')
        return command

    def settle(self, world):
        """Stands until the ball is felt: a ball that was not caught is not turned with, and one
        that still moves between the paws is not kicked."""
        held = world.motion.feeling.ball_held
        if held and self.since(world) > SETTLE:
            return self.enter(world, self.turn, None, 'the ball is felt')
        if self.since(world) > FEEL:
            return self.give_up(world, 'no ball is felt after the grab')
        return carry()

    def turn(self, world):
        """To the gap or the goal; without either, round until it comes into view."""
        if self.over_turns(world):
            return self.enter(world, self.over_turn, self.skill, 'no goal where the pose has it')
        choice = self.choose(world, self, False)
        if choice is not None:
            return self.enter(world, self.steady, None, choice[1], *choice[2:])
        if self.looks_at_own_goal(world):
            self.aim, self.searched = Aim(), 1
            self.search_side = -1.0 if sum(self.memory.own_goal) > 0.0 else 1.0
            return self.enter(world, self.spin_away, None, 'the own goal is in sight')
        if self.at_edge(world):
            return self.enter(world, self.off_edge, None, '{} cm from the line',
                              self.line_distance(world))
        if rulebook.dodges(world) and self.aim.gap is not None and abs(self.aim.middle) < 30.0:
            if in_the_way(world) and self.skill is None:
                return self.enter(world, self.dodge, Dodge(world, self.memory),
                                  'somebody is in the way')
        if self.aim.gap is None:
            return self.search_turn(world)
        if self.aim.aimed and self.should_carry(world):
            return self.enter(world, self.carry_on, None, 'aimed; goal {} cm away',
                              self.goal_distance(world))
        turn = self.to_gap(world)
        self.turn_side = 1.0 if turn >= 0.0 else -1.0
        return carry(turn=turn)

    def to_gap(self, world) -> float:
        """deg/s of the turn."""
        if rulebook.of(world).ONE_SPEED_BY_POSE and not self.aim.by_sight:
            return math.copysign(search_speed(world), self.aim.middle)
        return turn_towards(world, self.aim.middle)

    def looks_at_own_goal(self, world) -> bool:
        """Whether it aimed at the own goal, by a pose that is wrong."""
        return (rulebook.of(world).SPINS_AWAY and self.aim.aimed and not self.aim.by_sight and
                self.memory.own_goal_lost < OWN_GOAL_FRAMES)

    def spin_away(self, world):
        """Until the opponents' goal is in sight: the pose is not asked any more."""
        if self.aim.by_sight:
            return self.enter(world, self.turn, None, 'the goal is in sight')
        self.searched += 1
        return carry(turn=search_speed(world) * self.search_side)

    def over_turn(self, world):
        if not self.over_turns(world):
            return self.enter(world, self.turn, self.skill, 'turned on for {} frames',
                              self.over_turned)
        self.over_turned += 1
        return carry(turn=math.copysign(SEARCH_TURN, self.turn_side))

    def over_turns(self, world) -> bool:
        """Far from the goal, which is not where the pose says (section 6.4.3): some frames more."""
        return (rulebook.aims_by_sight(world) and self.aim.aimed and
                not self.aim.by_sight and self.over_turned < OVER_TURN and
                world.pose.position.y < OVER_TURN_Y)

    def steady(self, world):
        """Stands still for a moment, then kicks if that is still right."""
        if not self.still(world):
            return carry()
        choice = self.choose(world, self, False)
        if choice is None:
            return self.enter(world, self.turn, None, 'the aim was lost in the stop')
        return self.fire(world, choice)

    def still(self, world) -> bool:
        """Whether the stop before a kick is over."""
        seconds = max(world.elapsed_s, 0.02)
        speed = math.hypot(world.odometry.forward, world.odometry.left) / seconds
        turn = abs(world.odometry.turn_deg) / seconds
        stands = speed < STILL and turn < STILL_TURN
        return self.since(world) > (STEADY if stands else STEADY_MAX)

    def search_turn(self, world):
        """Goal not seen and pose not sure: turn the shorter way by what the pose says."""
        if self.searched == 0:
            self.search_side = 1.0 if way_to_goal(world) >= 0.0 else -1.0
        self.searched += 1
        return carry(turn=search_speed(world) * self.search_side)

    def should_carry(self, world) -> bool:
        if self.hold.seconds(world) > CARRY_UNTIL:
            return False
        if self.plan == 'grab_turn_kick':
            return False
        return CARRY_TO < self.goal_distance(world) < CARRY_FROM

    def carry_on(self, world):
        """Ahead to the goal, kept on the gap's middle."""
        if self.aim.gap is None or not self.should_carry(world):
            return self.enter(world, self.turn, None, 'goal {} cm away', self.goal_distance(world))
        if rulebook.dodges(world) and in_the_way(world):
            return self.enter(world, self.dodge, Dodge(world, self.memory),
                              'somebody is in the way')
        turn = clamp(2.0 * self.aim.middle, -40.0, 40.0)
        return carry(forward=FORWARD_SPEED, turn=turn)

    def dodge(self, world):
        command = self.skill.step(world)
        if self.skill.done:
            self.aim = Aim()
            self.enter(world, self.turn, self.skill, 'the way is free')
        return command

    def off_edge(self, world):
        """Turns inwards on the spot; by the theses' rules, since a turn may carry the ball over
        the line, backward, side and diagonal walk alone (section 6.4.5)."""
        if not self.at_edge(world):
            return self.enter(world, self.turn, None, 'off the line')
        if rulebook.of(world).TURNS_AT_EDGE and not self.carries_back:
            return carry(turn=turn_towards(world, self.inwards(world)))
        ahead, left = self.way_in(world)
        ahead = ahead if self.carries_back else min(0.0, ahead)
        return carry(forward=SIDE_SPEED * ahead, left=SIDE_SPEED * left)

    def fire(self, world, choice):
        """Kicks or lets go, as (choice, reason, numbers...) says."""
        what, reason, *numbers = choice
        self.steps_back = not isinstance(what, int) or somebody_near(world)
        if isinstance(what, int):
            self.enter(world, self.kick, Kick(world, what), reason, *numbers)
        else:
            self.enter(world, self.release, Release(world), reason, *numbers)

    def kick(self, world):
        command = carry()
        command.motion = self.skill.step(world)
        return self.leave(world, 'kicked') if self.skill.done else command

    def release(self, world):
        command = carry()
        command.motion = self.skill.step(world)
        return self.leave(world, 'let go') if self.skill.done else command

    def leave(self, world, why):
        if not self.steps_back:
            return self.enter(world, self.ended, None, why)
        self.hint = hints.LEFT_LYING
        if not rulebook.of(world).STEPS_BACK:
            return self.enter(world, self.ended, None, why)
        return self.enter(world, self.step_back, StepBack(world), why)

    def step_back(self, world):
        """Who stands over a ball that he let go, or kicked at somebody, still holds it by the
        rules."""
        self.hint = hints.LEFT_LYING
        walk = self.skill.step(world)
        if self.skill.done:
            return self.enter(world, self.ended, None, 'stepped back')
        return kelpie.Command(walk=walk, head=self.track.step(world))

    def ended(self, world):
        return kelpie.Command()

    def explain(self, trace) -> None:
        super().explain(trace)
        if self.state == self.turn:
            self.aim.explain(trace)

    # What states ask

    def goal_distance(self, world) -> float:
        dx = world.pose.position.x - 0.5 * world.field.width
        dy = world.pose.position.y - world.field.length
        return math.hypot(dx, dy)

    def line_distance(self, world) -> float:
        return min(lines_from(world))

    def at_edge(self, world) -> bool:
        """Whether it is near a line and does not look inwards, or carries the ball back from it."""
        if self.carries_back:
            return self.line_distance(world) < STOP_INSIDE
        if rulebook.of(world).TURNS_AT_EDGE:
            return self.line_distance(world) < EDGE and abs(self.inwards(world)) > 60.0
        near = EDGE + (OFF_EDGE if self.state == self.off_edge else 0.0)
        return self.line_distance(world) < near and self.way_in(world)[0] < LOOKS_IN

    @property
    def carries_back(self) -> bool:
        return self.plan == 'grab_dribble_stop'

    def way_in(self, world) -> tuple[float, float]:
        """Ahead and left: the direction square away from all lines that are near."""
        near = STOP_INSIDE if self.carries_back else EDGE + OFF_EDGE
        left, right, bottom, top = (away < near for away in lines_from(world))
        x, y = float(left - right), float(bottom - top)
        size = math.hypot(x, y) or 1.0
        angle = math.radians(world.pose.heading_deg)
        return ((x * math.cos(angle) + y * math.sin(angle)) / size,
                (y * math.cos(angle) - x * math.sin(angle)) / size)

    def inwards(self, world) -> float:
        """deg to turn until the robot looks at the middle of the field."""
        dx = 0.5 * world.field.width - world.pose.position.x
        dy = 0.6 * world.field.length - world.pose.position.y
        return wrap(math.degrees(math.atan2(dy, dx)) - world.pose.heading_deg)
