# SPDX-License-Identifier: Apache-2.0
# The robot that plays the ball (thesis 2006 Alg 4.2): keeps out of its own box, also with the ball
# in its arms, looks for landmarks when that costs nothing, finds the ball, and uses the skill that
# the decision tree names. Keeps the state, the skill, the leaf that it plays and why, the contest's
# latch and the goal. A skill that is committed (a grab, a kick, a held ball) is not interrupted;
# any other may change in any second frame: tree and map are a fifth of what an attacker may spend.
import kelpie
from arbiter.rules import RuleMachine
from decisions import tree
from decisions.held_choice import HeldChoice
from decisions.leaf_by_map import LeafByMap
from lib import rulebook
from lib.geom import from_field, heading, wrap
from lib.goalie_places import direction
from lib.paths import point_of
from lib.steer import filtered, towards
from safety.own_box import ball_outside_box
from situation.about_ball import opponents
from situation.at_ball import Situation
from situation.contested import Contested
from situation.goal import OpponentGoal
from situation.open_shot import open_shot
from situation.run_way import leaves, pressed
from skills.ball.dribble import Dribble
from skills.ball.find_ball import FindBall
from skills.ball.find_together import FindTogether
from skills.ball.grab_dribble import GrabDribble
from skills.ball.kick_ball import KickBall
from skills.ball.line_up_kick import LineUpKick
from skills.ball.run_ball import RunBall
from skills.head.active_localise import LEAVE, ActiveLocalise
from skills.head.glance import Glance
from skills.head.track_ball import believed
from skills.walk import round_box, round_post
from skills.walk.avoid_own_box import AvoidOwnBox
from skills.walk.paw_stuck import PawStuck, paw_pushes
from skills.walk.round_box import RoundBox
from skills.walk.round_post import RoundPost

CONSTANTS = kelpie.constants.attacker  # behaviour/constants.toml: defaults and ranges
LOST_FRAMES = CONSTANTS.lost_frames  # the ball is looked for after so many without a sight,
LOST_NEAR_FRAMES = 40   # or so many where the chin hides it,
LOST_RUN_FRAMES = 30, 75    # or while it runs with the ball, which a push hides; under the chin
CHIN = 20.0             # cm
SETTLED = CONSTANTS.settled  # cm to the ball; nearer, a leaf is kept for some frames
KEPT_FRAMES = CONSTANTS.kept_frames  # frames
LOOK_AFTER = 100.0, 0.0     # cm, deg: where a kicked ball is looked for
SEEN_S = 0.1            # s: a sighting that gps refused is none
WATCH = 0.4             # s after a kick
FORCED_FRAMES = 12      # of a forced look after a kick: as long
AHEAD = 15.0  # deg
FOLLOW = 40.0  # cm/s: a ball that went ahead is followed meanwhile,
FOLLOW_FROM = 30.0      # cm; not one that was left lying
BOX_WAIT_FRAMES = 90    # who has no goalie waits so long for its ball to leave the own box
BOX_LEFT_Y = 130.0      # cm; a ball beyond has left it for certain
KICKS = {facts.leaf: kick for kick, facts in kelpie.KICKS.items() if facts.leaf}
IN_MOUTH = 25.0         # cm before the goal line, from where on a push takes the ball in
GRAZES = 45.0           # deg off up-field, from where on it is rather pushed along the line
LINE_UP = 'line_up_kick'    # in place of a grab when that is switched off
# Why the ball is looked for by who comes from another state than play.
LEFT = {'back_off': 'the paws are free', 'localise': 'looked at a landmark',
        'avoid_box': 'the own box is no longer in the way',
        'round_box': 'past the own box', 'round_post': 'past the post'}


class AttackerSituation:
    """What an attacker decides by in one frame."""

    def __init__(self, world, memory, running=False):
        """`running`: with the ball."""
        self.world, self.memory = world, memory
        ball = world.ball
        far, near = LOST_RUN_FRAMES if running else (LOST_FRAMES, LOST_NEAR_FRAMES)
        maximum = near if ball.present and ball.distance < CHIN else far
        self.lost = not ball.present or memory.ball_lost > maximum
        # What its player adds: paw_pushes, box_in_the_way, the leaf whose skill has ended, and
        # ActiveLocalise, which knows whether a look is needed, or over.


def skill_has_ended(now, playing):
    """Until it has watched where the ball goes; that state ends by itself."""
    return (now.ended + ' has ended',) if now.ended or playing == 'watch' else None


def looks_on(now, playing):
    looks = playing == 'localise' and not now.landmarks.done and not now.lost
    return ('looks at a landmark',) if looks else None


def ball_is_lost(now, playing):
    """Who plays or waits beside the box goes on until it is lost; who looked elsewhere must see it
    again."""
    if not now.lost:
        # gps has a felt ball as seen; vision must say so, too.
        if playing == 'play' or now.world.ball.seconds_since_seen < SEEN_S or (
                playing == 'avoid_box' and now.box_in_the_way):
            return None
    if playing == 'play':
        return 'ball unseen for {} frames', float(now.memory.ball_lost)
    return (LEFT.get(playing, 'looks for the ball'),)


def ball_in_own_box(now, playing):
    return ('the ball is in the own box',) if now.box_in_the_way else None


def post_in_way(now, playing):
    """Of who leans on a post, or is about to."""
    rounds = rulebook.of(now.world).ROUNDS_POSTS
    return ('a post stands in the way to the ball',) if rounds and round_post.needed(
        now.world, playing == 'round_post') else None


def box_between(now, playing):
    rounds = rulebook.of(now.world).ROUNDS_BOX
    return ('the own box lies on the way to the ball',) if rounds and round_box.needed(
        now.world, playing == 'round_box') else None


def time_to_look(now, playing):
    return ('far ball, time to look',) if now.landmarks.needed(now.world) else None


def ball_is_there(now, playing):
    return 'the ball is {} cm away', now.world.ball.distance


class Attacker(RuleMachine):
    LAYER = kelpie.LAYER_ROLE
    NAME = 'attacker'
    RULES = (
        (paw_pushes, 'back_off'),
        (skill_has_ended, 'watch'),
        (looks_on, 'localise'),
        (ball_is_lost, 'find'),
        (ball_in_own_box, 'avoid_box'),
        (box_between, 'round_box'),
        (post_in_way, 'round_post'),
        (time_to_look, 'localise'),
        (ball_is_there, 'play'))

    def __init__(self, memory):
        super().__init__(self.find)
        self.memory = memory
        self.goal = OpponentGoal()
        self.contested = Contested()
        self.by_map = LeafByMap()
        self.held = HeldChoice(memory, self.contested)
        self.localise_skill = ActiveLocalise(memory)
        self.stuck = PawStuck(pushes_on=True)
        self.team_search = FindTogether(memory, True)
        self.glance = Glance(memory)
        self.box_frames = 0     # for which it waited for a ball in the own box
        self.leaf, self.leaf_why = None, ()
        self.chosen_by = ''     # who says another leaf than the tree does
        self.leaf_frame = 0
        self.tree_leaf, self.tree_place, self.tree_why = None, '', ()

    def step(self, world) -> kelpie.Command:
        """The frame's answer while playing."""
        self.goal.update(world)
        self.contested.update(world, self.memory)
        self.stuck.update(world)
        if not self.committed:
            self.choose(world, self.situation(world))
        command = super().step(world)
        if not self.fetches_from_box(world):
            now = AttackerSituation(world, self.memory)
            command.walk = filtered(now, command.walk, (ball_outside_box,))
        return command

    def situation(self, world) -> AttackerSituation:
        now = AttackerSituation(world, self.memory,
                                self.state == self.play and self.leaf == tree.RUN)
        now.paw_pushes = rulebook.of(world).ATTACKER_BACKS and self.stuck.needed(world)
        ended = self.state == self.play and self.skill is not None and self.skill.done
        now.ended = self.leaf if ended else ''
        now.landmarks = self.localise_skill
        now.box_in_the_way = self.box_in_the_way(world)
        return now

    @property
    def committed(self) -> bool:
        """A grab, a kick or a held ball is not interrupted."""
        return self.state == self.play and self.skill is not None and self.skill.committed

    def skill_of(self, name, now):
        world = now.world
        if name == 'find':
            return self.skill if isinstance(self.skill, FindBall) else FindBall(world, self.memory)
        if name == 'watch':
            return self.after_skill(world)
        if name == 'localise':
            self.localise_skill.start(world)
        return {'back_off': self.stuck, 'localise': self.localise_skill,
                'avoid_box': AvoidOwnBox(self.memory),
                'round_box': RoundBox(self.memory), 'round_post': RoundPost(self.memory)}.get(name)

    def wanted(self, world):
        """Where it goes on the field: to the ball."""
        ball = world.ball
        return (ball.position.x, ball.position.y) if ball.present else None

    @property
    def pass_to(self) -> int:
        """Number of the mate that the ball is played to, from the stop for the kick until it has
        rolled; 0: nobody."""
        return self.held.pass_to if self.state == self.watch or self.committed else 0

    # States

    def find(self, world):
        if self.skill is None:
            self.skill = FindBall(world, self.memory)
        helped = self.team_search.step(world) if len(world.teammates) > 0 else None
        return helped if helped is not None else self.skill.step(world)

    def back_off(self, world):
        return self.stuck.step(world)

    def avoid_box(self, world):
        """Where no goalie is heard who clears the ball, it fetches it in the end."""
        self.box_frames += 1    # after the question, which this frame has asked
        return self.looking_round(world, self.skill.step(world))

    def round_post(self, world):
        return self.skill.step(world)

    def round_box(self, world):
        return self.skill.step(world)

    def looking_round(self, world, command) -> kelpie.Command:
        """The same, with the head at a landmark now and then."""
        if self.glance.takes_head(world, not self.committed):
            command.head = self.glance.step(world)
        return command

    def localise(self, world):
        """Walks on to the ball while the head looks away."""
        head = self.skill.step(world)
        walk = towards(believed(world), LEAVE) if world.ball.present else kelpie.WalkRequest()
        return kelpie.Command(walk=walk, head=head)

    def play(self, world):
        if self.skill is None or (world.frame % 2 == 0 and not self.skill.committed):
            self.choose_leaf(world)
        command = self.skill.step(world)
        self.remember(self.skill)
        return self.looking_round(world, command)

    def remember(self, skill):
        """What the skill said of the ball in this frame."""
        if skill.approached:
            self.memory.approached()
        if skill.grabbed:
            self.memory.grabbed()
        if skill.hint is not None:
            self.memory.set_hint(*skill.hint)

    def after_skill(self, world) -> FindBall:
        """Watches where the ball goes; a skill that leaves no hint itself sent it ahead."""
        hinted = self.memory.hint is not None and self.memory.frame - self.memory.hint[2] <= 2
        if not hinted:
            self.memory.set_hint(*LOOK_AFTER)
        search = FindBall(world, self.memory)
        if rulebook.of(world).FORCES_LOOK and (isinstance(self.skill, KickBall) or not hinted):
            search.force(self.memory.hint[1], self.memory.frame + FORCED_FRAMES)
        self.by_map = LeafByMap()
        self.leaf = None
        return search

    def watch(self, world):
        """The ball that was just kicked is not where it was believed: what is seen of it in this
        time is not played yet, only followed."""
        command = self.skill.step(world)
        distance, off_deg = self.memory.hint[:2]
        follows = not rulebook.of(world).FORCES_LOOK
        if follows and abs(off_deg) < AHEAD and distance >= FOLLOW_FROM:
            command.walk = kelpie.WalkRequest(forward=FOLLOW, kind=kelpie.WALK_FAST)
        if self.timed_out(world, WATCH):
            self.enter(world, self.find, self.skill, 'it has rolled for {} s', WATCH)
        return command

    def box_in_the_way(self, world) -> bool:
        if world.ball.present and world.ball.position.y > BOX_LEFT_Y:
            self.box_frames = 0
        if self.fetches_from_box(world):
            return False
        return AvoidOwnBox.needed(world, self.memory.grab_lost < 2)

    def fetches_from_box(self, world) -> bool:
        """Whether it has waited long enough for a goalie that is not there."""
        return self.box_frames > BOX_WAIT_FRAMES and not has_goalie(world)

    def choose_leaf(self, world):
        situation = Situation(world, self.contested.now, self.memory.approach_lost < 3)
        leaf, self.tree_place, *why = tree.decide(situation)
        self.tree_leaf, self.tree_why = leaf, tuple(why)
        self.chosen_by = 'kept'
        run = self.run_choice(world) if rulebook.runs(world) else None
        if run is not None:
            self.chosen_by, leaf, *why = run
        elif rulebook.by_kick_map(world) and world.task.grab:
            self.chosen_by = 'leaf_by_map'
            leaf, *why = self.by_map.choose(world, situation, leaf, self.leaf)
        if leaf in tree.WITH_GRAB and not rulebook.grabs(world):
            leaf = LINE_UP
        settled = (world.ball.distance < SETTLED and
                   self.memory.frame - self.leaf_frame < KEPT_FRAMES)
        if self.skill is None or (leaf != self.leaf and not settled):
            self.skill, self.leaf, self.leaf_frame = self.make(leaf), leaf, self.memory.frame
            self.leaf_why = tuple(why)
        elif leaf == self.leaf:
            self.leaf_why = tuple(why)

    def run_choice(self, world) -> tuple | None:
        """(who says so, leaf, reason, *numbers) of who runs with the ball; None: there is time for
        a grab."""
        field, ball = world.field, point_of(world.ball)
        if in_mouth(field, ball):
            return 'run_way', *pushed_in(world)
        others = opponents(world, self.memory)
        if pressed(field, ball, others, self.leaf == tree.RUN):
            return 'open_shot', *self.run_or_shoot(world, others)
        return None

    def run_or_shoot(self, world, others) -> tuple:
        """(leaf, reason, *numbers) of who runs with the ball: a grab takes longer than who presses
        needs to it."""
        shot = open_shot(world, others, KICKS.get(self.leaf))
        if shot is None:
            return tree.RUN, 'no shot is open'
        return kelpie.KICKS[shot[0]].leaf, 'a goal with a chance of {}', shot[1]

    def make(self, leaf):
        """The skill that plays a leaf, begun anew."""
        if leaf in KICKS:
            return KickBall(self.memory, KICKS[leaf])
        if leaf == tree.RUN:
            return RunBall(self.memory)
        if leaf == tree.DRIBBLE:
            return Dribble(self.memory, self.goal_heading)
        if leaf == LINE_UP:
            return LineUpKick(self.memory, self.goal)
        if leaf == tree.AVOID_OWN_GOAL:
            return AvoidOwnBox(self.memory)
        self.held.start()
        return GrabDribble(self.memory, self.held.choose, leaf)

    def goal_heading(self, world) -> float:
        point = self.goal.where(world)
        if point is None:
            point = from_field(world.pose, 0.5 * world.field.width, world.field.length)
        return heading(*point)

    def explain(self, trace) -> None:
        trace.append((self.LAYER, self.NAME, self.state.__name__, self.why, *self.numbers))
        if self.state == self.play and self.leaf is not None:
            trace.append((kelpie.LAYER_DECISION, 'tree ' + self.tree_place, self.tree_leaf,
                          *self.tree_why))
            if (self.leaf, self.leaf_why) != (self.tree_leaf, self.tree_why):
                trace.append((kelpie.LAYER_DECISION, self.chosen_by, self.leaf, *self.leaf_why))
        if self.glance.looking:
            self.glance.explain(trace)
        if self.state == self.find and self.team_search.active:
            return self.team_search.explain(trace)
        if self.skill is not None:
            self.skill.explain(trace)


def in_mouth(field, ball) -> bool:
    """Whether the ball lies just before the opponents' goal line, between the posts."""
    return (ball[1] > field.length - IN_MOUTH and
            abs(ball[0] - 0.5 * field.width) < 0.5 * field.goal_width)


def pushed_in(world) -> tuple:
    """(leaf, reason) of a ball in the mouth: neither a grab nor a kick is as sure as a push."""
    ball = point_of(world.ball)
    on = direction(point_of(world.pose), ball)
    if leaves(world.field, ball, on) or abs(wrap(on - 90.0)) > GRAZES:
        return tree.RUN, 'pushed straight on the ball would miss the goal'
    return tree.DRIBBLE, 'the ball is in the mouth'


def has_goalie(world) -> bool:
    return any(mate.note.role == kelpie.KEEPER for mate in world.teammates)
