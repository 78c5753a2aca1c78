# SPDX-License-Identifier: Apache-2.0
# The goalie of 2006 (thesis 2006 section 4.3.1, algorithm 4.1): in every frame the first of RULES
# that holds says what it does. A ball that it has lost is guarded against where its mates see it.
# Keeps the state, the situation, which team has the ball, and its head. It never leaves its box
# (checklist K07); it fails as the pose does, and against shots from so near that the ball is past
# before a block lies.
import kelpie
from arbiter.rules import RuleMachine
from decisions import goalie_rules as rules
from decisions.guard_place import guard_place
from lib import rulebook
from lib.goalie_places import beside, bisector_place, facing, fixed_bisector_place
from lib.steer import filtered
from players.halted import Halted
from safety.own_box import straight_back
from safety.own_goal import faces_reported_ball, hold_position, no_own_goal
from situation.goalie import GoalieSituation
from situation.memory import Memory
from situation.opponents import at_ball
from situation.possession import Possession
from situation.shot import coming
from skills.ball.attack_ball import AttackBall
from skills.ball.run_ball import RunBall
from skills.head.goalie_head import GoalieHead
from skills.motion.get_up import GetUp
from skills.motion.kick import Kick
from skills.walk.face_up_field import FaceUpField
from skills.walk.guard_goal import NONE, OF_2006, GuardGoal
from skills.walk.look_about import LookAbout
from skills.walk.step_back import StepBack

LOOK = 80.0    # cm that a ball goes after a clearance, when the head looks for it
ATTACK = 8.0   # s that an attack may take; after one that took longer
REST = 2.0     # s without another


class Goalie(RuleMachine):
    LAYER = kelpie.LAYER_PLAYER
    NAME = 'goalie'
    RULES = (
        (rules.faces_wrong, 'turn'),
        (rules.shot_comes, 'block'),
        (rules.stands_over_ball, 'step_back'),
        (rules.ball_comes, 'adjust'),
        (rules.mate_grabs, 'guard'),
        (rules.can_clear_at_once, 'clear'),
        (rules.can_run, 'run_out'),
        (rules.opponent_has_ball, 'guard'),
        (rules.can_clear, 'clear'),
        (rules.can_attack, 'attack'),
        (rules.guards, 'guard'))
    COMMITTED = ('block', 'clear', 'step_back')
    GUARDED = (hold_position, faces_reported_ball, no_own_goal)   # what is left of a guard's walk
    STEPPED = (straight_back,)                                # and of a step back

    def __init__(self, rule=None):
        super().__init__(self.guard, GuardGoal(OF_2006))
        self.rule = rule  # from the field and a ball to the place to guard; None: the match's
        self.memory = Memory()
        self.possession = Possession(self.memory)
        self.now = GoalieSituation(self.memory)
        self.eyes = GoalieHead(self.memory, self.now)
        self.look_about = LookAbout(self.now)
        self.get_up = GetUp()
        self.halted = Halted(self.memory, self.get_up)
        self.expected = None        # the point of the field where a clearance sends the ball
        self.shot = None            # the one that was blocked last

    def skill_of(self, name, now):
        world = now.world
        if name == 'block':
            self.shot = now.shots.shot
            return Kick(world, now.shots.block())
        if name == 'clear':
            best = now.clearance
            self.expected = best.ball if at_ball(world, best.ball) else best.after(LOOK)
            return Kick(world, best.kick)
        if name == 'turn':
            return FaceUpField(world, now.facing)
        if name == 'attack':
            return AttackBall()
        if name == 'run_out':
            return RunBall(self.memory)
        if name == 'step_back':
            return StepBack(world)
        return GuardGoal(NONE if name == 'adjust' else OF_2006)

    def step(self, world) -> kelpie.Command:
        self.memory.update(world)
        self.now.update(world)
        if rulebook.follows_play(world):
            self.possession.update(world)
        command = self.decide(self.now.world)
        command.team.role = kelpie.NO_ROLE if world.game.penalised else kelpie.KEEPER
        command.team.possession = self.possession.own
        self.explain(command.trace)
        return command

    def decide(self, world) -> kelpie.Command:
        if world.game.state != kelpie.PLAYING or world.game.penalised:
            self.start_over(world, 'play is halted')
            return self.idle(world)
        self.halted.end()
        if self.get_up.needed(world):
            self.start_over(world, 'has fallen')
            self.now.fell()
            return kelpie.Command(motion=self.get_up.step(world))
        if not self.committed:
            self.choose(world, self.now)
        return super().step(world)

    def idle(self, world) -> kelpie.Command:
        return self.halted.step(world)

    def start_over(self, world, why):
        self.now.start_over()
        self.reset(world, why, self.guard, GuardGoal(OF_2006))

    def explain(self, trace) -> None:
        super().explain(trace)
        self.possession.explain(trace)
        self.halted.explain(trace)
        if self.now.reported is not None and self.state == self.guard:
            trace.append((kelpie.LAYER_SKILL, 'team_ball', 'told', 'mates see the ball at ({}, {})',
                          *self.now.reported))
        if self.now.pose.doubtful:
            trace.append((kelpie.LAYER_SKILL, 'pose_watch', 'carried', 'the pose has jumped'))
        self.eyes.explain(trace)

    # States

    def turn(self, world) -> kelpie.Command:
        return self.skill.step(world)

    def block(self, world):
        command = self.perform(world)
        if command is None:
            self.eyes.look_near(world, 1.0 if self.shot.lateral < 0.0 else -1.0)
        return command

    def clear(self, world):
        command = self.perform(world)
        if command is None:
            self.eyes.expect(world, self.expected)
        return command

    def perform(self, world):
        motion = self.skill.step(world)
        if self.skill.done:
            self.now.motion_ended(kicked=self.state == self.clear)
            return self.enter(world, self.guard, GuardGoal(OF_2006), 'the motion has ended')
        return self.acting(world, motion=motion)

    def step_back(self, world):
        """The ball comes into view, and is no longer held."""
        walk = self.skill.step(world)
        if self.skill.done:
            self.now.left_ball()
            return self.enter(world, self.guard, GuardGoal(OF_2006), 'stepped back')
        return self.acting(world, walk=filtered(self.now, walk, self.STEPPED))

    def adjust(self, world) -> kelpie.Command:
        """Into the way of the ball where it crosses the own line: a side step, seldom more."""
        shot = coming(world, rules.COMING_BESIDE, rules.COMING_SHORT, 0.0)
        place = beside(world.pose, shot.lateral if shot is not None else 0.0)
        return self.acting(world, walk=self.skill.step(world, facing(place, self.now.ball)))

    def run_out(self, world) -> kelpie.Command:
        return self.skill.step(world)

    def attack(self, world):
        if rulebook.of(world).ATTACKS_BRIEFLY and self.timed_out(world, ATTACK):
            self.now.attack_failed(REST)
            return self.enter(world, self.guard, GuardGoal(OF_2006), 'the attack timed out')
        return self.acting(world, walk=self.skill.step(world, self.now.kick_stand(True)))

    def guard(self, world) -> kelpie.Command:
        rules = rulebook.of(world)
        usual = bisector_place if rules.DROPS_BACK else fixed_bisector_place
        place = guard_place(self.now, self.eyes, self.rule or usual)
        if place is not None:
            walk = self.skill.step(world, place)
        else:
            walk = self.look_about.step(world, self.eyes.turn_side(world))
        if rules.SPARES_OWN_GOAL:
            walk = filtered(self.now, walk, self.GUARDED)
        return kelpie.Command(walk=walk, head=self.eyes.step(world, True))

    def acting(self, world, **answer) -> kelpie.Command:
        """With the head on the ball: it cannot be left alone."""
        return kelpie.Command(head=self.eyes.step(world, False), **answer)
