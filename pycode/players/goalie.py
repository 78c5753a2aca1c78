# SPDX-License-Identifier: Apache-2.0
# The goalie of 2006 (thesis 2006 section 4.3.1, algorithm 4.1). In every frame the first rule that
# holds says what it does: turn to face up-field, block a shot, step back from a ball between its
# paws, move into a slow ball's way, leave a ball that somebody has, clear one that lies right, walk
# to one in or at its box, guard the goal. A ball that it has lost is guarded against where its
# mates see it. Keeps the state, its head and what it counts of shots, of its facing and of a ball
# between its paws. It never leaves its box (checklist K07); it fails as the pose does, and against
# shots from so near that the ball is past before a block lies.
import math

import kelpie
from arbiter.lasting import Lasting
from arbiter.machine import Machine
from lib.geom import from_field
from lib.goalie_places import (LEAST_Y, TRUNK, beside, beyond_box, bisector_place, central_place,
                               facing, round_ball, takes_in)
from lib.tune_goalie import Attack, Clear, Coming, Guard, Paws
from lib.ways import point_of
from players.halted import Halted
from situation.memory import Memory
from situation.pose_watch import PoseWatch
from situation.shot import coming, speed
from situation.underfoot import Underfoot
from skills.ball.attack_ball import AttackBall
from skills.ball.clear_ball import clearing_kick, mate_grabs, opponent_at, opponent_has
from skills.ball.find_together import heard_of
from skills.head.goalie_head import GoalieHead, seen
from skills.motion.block import NAMES, ShotWatch
from skills.motion.get_up import GetUp
from skills.motion.kick import Kick
from skills.walk.face_up_field import FaceUpField, crowded
from skills.walk.guard_goal import GuardGoal, in_box
from skills.walk.step_back import StepBack


def under_chin(ball) -> bool:
    """Whether a ball is believed before the chest, and not beside it."""
    return (ball.present and 0.0 < ball.relative.y < Guard.CHIN and
            abs(ball.relative.x) < Guard.CHIN)


class Goalie(Machine):
    LAYER = kelpie.LAYER_PLAYER
    NAME = 'goalie'

    def __init__(self, rule=bisector_place):
        super().__init__(self.guard, GuardGoal(Guard))
        self.rule = rule    # from the field and a ball to the place to guard
        self.memory = Memory()
        self.eyes = GoalieHead(self.memory)
        self.shots = ShotWatch(self.memory)
        self.facing = FaceUpField()
        self.pose = PoseWatch()
        self.get_up = GetUp()
        self.halted = Halted(self.memory, self.get_up)
        self.look_for = None  # the point of the field where the ball should be after a clearance
        self.shot_aside = 0.0  # cm, of the last shot that was blocked
        self.moved_s = 0.0  # when the last motion ended, or the last fall
        self.kicked = False  # that motion was a kick
        self.rest_s = 0.0   # no attack before, after one that came to nothing
        self.has = Lasting(Clear.HAS_STILL, Clear.HAS_LONGEST)  # an opponent has the ball
        self.underfoot = Underfoot()
        self.presses = Lasting(Clear.HAS_STILL, Clear.HAS_LONGEST)  # and presses at its body

    def step(self, world) -> kelpie.Command:
        self.memory.update(world)
        self.pose.update(world)
        self.eyes.asked = self.eyes.asked or self.pose.gave_in
        self.eyes.lost = self.pose.lost(world)
        world = self.pose.believed(world)
        self.shots.update(world)
        self.facing.update(world)
        self.underfoot.update(world, self.told)  # of the frame before
        self.eyes.told = None
        command = self.decide(world)
        command.team.role = kelpie.NO_ROLE if world.game.penalised else kelpie.KEEPER
        self.explain(command.trace)
        return command

    def decide(self, world) -> kelpie.Command:
        if world.game.state != kelpie.PLAYING or world.game.penalised:
            self.start_over(world, 'play is halted')
            return self.idle(world)
        self.halted.end()
        if self.get_up.needed(world):
            self.start_over(world, 'has fallen')
            self.moved_s = world.time_s
            return kelpie.Command(motion=self.get_up.step(world))
        if self.state not in (self.block, self.clear, self.step_back):  # these come to their end
            self.choose(world)
        return super().step(world)

    @property
    def told(self):
        """Where mates see a ball that the goalie has lost, in this frame; or None."""
        return self.eyes.told

    def idle(self, world) -> kelpie.Command:
        return self.halted.step(world)

    def start_over(self, world, why):
        self.facing.end()
        self.underfoot.end()
        self.reset(world, why, self.guard, GuardGoal(Guard))

    def explain(self, trace) -> None:
        super().explain(trace)
        self.halted.explain(trace)
        if self.told is not None:
            trace.append((kelpie.LAYER_SKILL, 'team_ball', 'told', 'mates see the ball at ({}, {})',
                          *self.told))
        if self.pose.doubtful:
            trace.append((kelpie.LAYER_SKILL, 'pose_watch', 'carried', 'the pose has jumped'))
        self.eyes.explain(trace)

    # Algorithm 4.1: each rule enters its state if it holds, and says so

    def choose(self, world):
        for rule in (self.faces_wrong, self.shot_comes, self.stands_over, self.ball_comes,
                     self.leaves_ball, self.may_clear, self.may_attack, self.may_guard):
            if rule(world):
                return

    def take(self, world, state, make, why, *numbers) -> bool:
        """Enters the state, with a new skill, unless it is in it."""
        if self.state != state:
            if state != self.turn:
                self.facing.end()
            self.enter(world, state, make(), why, *numbers)
        return True

    def faces_wrong(self, world) -> bool:
        wrong = self.facing.wrong(world)
        if wrong is None:
            return False
        self.take(world, self.turn, lambda: self.facing, *wrong)
        if self.facing.side == 0.0:
            self.facing.begin(world)
        return True

    def shot_comes(self, world) -> bool:
        motion = self.shots.block()
        if motion == kelpie.NO_MOTION:
            return False
        shot = self.shots.shot
        self.shot_aside = shot.aside
        return self.take(world, self.block, lambda: Kick(world, motion),
                         NAMES[motion] + ' block: at {} cm/s it passes {} cm right in {} s',
                         shot.speed, shot.aside, shot.seconds)

    def ball_comes(self, world) -> bool:
        sees = seen(world) and self.seen_since_motion(world)
        shot = coming(world, Coming.BESIDE, Coming.SHORT, Coming.SPEED) if sees else None
        if shot is None or shot.seconds > Coming.LATEST:
            return False
        return self.take(world, self.adjust, lambda: GuardGoal(Coming),
                         'a ball comes at {} cm/s, to {} cm right', shot.speed, shot.aside)

    def leaves_ball(self, world) -> bool:
        """A held ball is nobody else's to kick: who tries it is beside the ball when it is shot,
        not between it and the goal."""
        if mate_grabs(world):
            return self.take(world, self.guard, lambda: GuardGoal(Guard), 'a mate grabs the ball')
        return (self.has.update(world.time_s, opponent_has(world)) and
                self.take(world, self.guard, lambda: GuardGoal(Guard), 'an opponent has the ball'))

    def stands_over(self, world) -> bool:
        """A ball under the chin counts as held. Of 22 goalies that were taken out for it 20 had the
        ball in their goal within 6 s."""
        seconds = self.underfoot.seconds(world)
        return (seconds > Paws.LONGEST and
                self.take(world, self.step_back, lambda: StepBack(world),
                          'stands over the ball for {} s', seconds))

    def may_clear(self, world) -> bool:
        stands = world.time_s - self.moved_s > Clear.STANDS
        best = clearing_kick(world) if stands else None
        if best is None:
            return False
        if self.state != self.clear:
            self.look_for = best.ball if opponent_at(world, *best.ball) else best.after(Clear.LOOK)
        return self.take(world, self.clear, lambda: Kick(world, best.kick),
                         'worth {}, to {} deg, {} deg off the own goal', best.worth,
                         best.direction, best.off_goal)

    def may_attack(self, world) -> bool:
        """Not for a ball that it has lost on the way: walking on, it took such into its goal (seed
        148001, 434 s). It stands then, or goes where mates see it."""
        ball = world.ball
        away = beyond_box(world.field, (ball.position.x, ball.position.y))
        limit = Attack.LEAVE if self.state == self.attack else Attack.NEAR
        if (not seen(world, Guard.FRESH) or not self.seen_since_motion(world) or away > limit or
                speed(ball) > Attack.SPEED or world.time_s < self.rest_s or self.eyes.lost):
            return False
        skill = self.skill if self.state == self.attack else AttackBall()
        if not skill.can(world):
            return False
        return self.take(world, self.attack, lambda: skill, 'the ball is {} cm beyond the box',
                         away)

    def seen_since_motion(self, world) -> bool:
        """Whether the ball was seen after the last kick or block, which moved it."""
        return world.time_s - self.moved_s > world.ball.seconds_since_seen

    def may_guard(self, world) -> bool:
        return self.take(world, self.guard, lambda: GuardGoal(Guard), 'the ball is {} cm away',
                         world.ball.distance)

    # States

    def turn(self, world) -> kelpie.Command:
        return self.skill.step(world)

    def block(self, world):
        command = self.perform(world)
        if command is None:
            self.eyes.look_near(world, 1.0 if self.shot_aside < 0.0 else -1.0)
        return command

    def clear(self, world):
        command = self.perform(world)
        if command is None:
            self.eyes.expect(world, self.look_for)
        return command

    def step_back(self, world):
        """A step back, as far as the goal line: the ball comes into view, and is no longer held.
        Straight back or not at all: aside, as the box may ask, its legs take the ball along."""
        walk = self.skill.step(world)
        if self.skill.done:
            self.underfoot.end()
            return self.enter(world, self.guard, GuardGoal(Guard), 'stepped back')
        walk.forward = min(in_box(world, walk, 0.0).forward, 0.0)
        return kelpie.Command(walk=walk, head=self.eyes.step(world, False))

    def perform(self, world):
        motion = self.skill.step(world)
        if self.skill.done:
            self.moved_s, self.kicked = world.time_s, self.state == self.clear
            self.presses.end()
            return self.enter(world, self.guard, GuardGoal(Guard), 'the motion has ended')
        return kelpie.Command(motion=motion, head=self.eyes.step(world, False))

    def adjust(self, world) -> kelpie.Command:
        """Into the way of the ball where it crosses the own line: a step aside, seldom more."""
        shot = coming(world, Coming.BESIDE, Coming.SHORT, 0.0)
        place = beside(world.pose, shot.aside if shot is not None else 0.0)
        ball = (world.ball.position.x, world.ball.position.y)
        walk = self.skill.step(world, facing(place, ball))
        return kelpie.Command(walk=walk, head=self.eyes.step(world, False))

    def attack(self, world):
        if self.timed_out(world, Attack.TIME):
            self.rest_s = world.time_s + Attack.REST
            return self.enter(world, self.guard, GuardGoal(Guard), 'the attack timed out')
        return kelpie.Command(walk=self.skill.step(world), head=self.eyes.step(world, False))

    def guard(self, world) -> kelpie.Command:
        self.eyes.told = self.heard(world)
        place = self.place(world)
        walk = self.skill.step(world, place) if place is not None else self.look_about(world)
        walk = kelpie.WalkRequest() if self.holds_out(world) else self.harmless(world, walk)
        return kelpie.Command(walk=walk, head=self.eyes.step(world, True))

    def holds_out(self, world) -> bool:
        """Whether an opponent presses at a ball at the body, under the chin or beside it: past who
        stands there it hardly gets, past who walks or turns it slips. For 4 s, and after a motion
        for 4 more."""
        pressed = self.is_pressed(world)
        return self.presses.update(world.time_s, pressed) and pressed

    def is_pressed(self, world) -> bool:
        if self.told is None and not world.ball.present:
            return False
        place = self.told or point_of(world.ball)
        right, ahead = from_field(world.pose, *place)
        return (-TRUNK < ahead < Guard.PRESSED and abs(right) < Guard.CHIN and
                opponent_at(world, *place))

    def harmless(self, world, walk) -> kelpie.WalkRequest:
        """The walk, or its translation or its turn alone, if that takes no ball in."""
        if self.told is not None:
            ball = self.told
            walk.turn_deg = self.kept_up_field(world, walk.turn_deg, 180.0)
        elif seen(world, Guard.LOST):
            ball = world.ball.position.x, world.ball.position.y
        else:
            return walk
        for one in (walk, kelpie.WalkRequest(forward=walk.forward, left=walk.left),
                    kelpie.WalkRequest(turn_deg=walk.turn_deg)):
            if not takes_in(world.field, world.pose, one, ball):
                return one
        return kelpie.WalkRequest()

    def kept_up_field(self, world, turn_deg, most) -> float:
        """A turn, or 0 if it leads off up-field by more than so many degrees. Deeper than it stands
        by itself the goalie sweeps a ball before its chest into the goal with any such turn."""
        side = math.copysign(1.0, turn_deg)
        deep = world.pose.position.y < LEAST_Y
        return 0.0 if -side * self.facing.aside(world) >= (0.0 if deep else most) else turn_deg

    def look_about(self, world) -> kelpie.WalkRequest:
        """A ball lost at the feet is under the chin: a step back shows it. One beside the body is
        seen only when that turns. After a motion nobody knows where it lies: after a kick that
        missed, who walks takes it into the own goal, or who turns fast; and with an opponent at
        hand who does either."""
        if crowded(world):
            return kelpie.WalkRequest()
        moved = not self.seen_since_motion(world)
        under = under_chin(world.ball)
        side = self.eyes.turn_side(world)
        if side != 0.0:
            rate = Guard.KICKED_TURN if moved and self.kicked else Guard.SEARCH_TURN
            return kelpie.WalkRequest(turn_deg=self.kept_up_field(world, side * rate,
                                                                  Guard.MOST_TURNED))
        if moved:
            return kelpie.WalkRequest()
        return in_box(world, kelpie.WalkRequest(forward=Guard.BACK_OFF if under else 0.0))

    def heard(self, world):
        """Where mates see a ball that the goalie has lost, if they saw it after its last motion; or
        None. It sees none beside its body or behind. Of balls within 60 cm, unseen for 0.4 s, the
        team's was sure to 5 cm in 65 %, and then off by 4 cm (median), its own belief by 17."""
        team, told = world.team_ball, heard_of(world)
        moved = world.time_s - self.moved_s <= team.seconds_since_seen
        if told is None or moved or not self.sure(world):
            return None
        variance = 0.5 * (team.covariance[0] + team.covariance[3])
        return told if math.sqrt(variance) < Guard.TOLD_SD else None

    def sure(self, world) -> bool:
        """Whether the pose is to be gone by."""
        return self.pose.settled(world) and not self.eyes.lost

    def lost_for(self, world) -> float:
        """Seconds without the ball; a motion takes the head along."""
        if not world.ball.present:
            return world.time_s - self.moved_s
        return min(world.ball.seconds_since_seen, world.time_s - self.moved_s)

    def place(self, world):
        """Where to guard: by the ball, or by where mates see it; nowhere else while it is looked
        for at first, all round if it was lost close by; then in the middle, and at last so near to
        the line that no ball can lie behind the robot unseen. A survey looks elsewhere: its time is
        none of looking for the ball."""
        if self.told is not None:
            return self.place_for(world, self.told)
        sure = self.sure(world)
        lost = self.lost_for(world) if sure else 0.0
        if lost > Guard.LOST:
            return central_place(world.field, LEAST_Y)
        if self.eyes.searches_near(world):
            return None
        if min(lost, world.time_s - self.eyes.surveyed_s) > Guard.UNSEEN:
            return central_place(world.field)
        if (not sure or not seen(world, Guard.FRESH) or not self.seen_since_motion(world) or
                self.eyes.state == self.eyes.survey):
            return None
        return self.place_for(world, (world.ball.position.x, world.ball.position.y))

    def place_for(self, world, ball):
        start = (world.pose.position.x, world.pose.position.y)
        return round_ball(world.field, start, self.rule(world.field, ball), ball)
