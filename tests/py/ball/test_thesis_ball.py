# SPDX-License-Identifier: Apache-2.0
"""Who plays the ball by the theses' rules alone, and how Kelpie differs: made situations, with the
numbers of thesis 2006 chapter 5 and sections 6.3 and 6.4."""
import kelpie
import pytest
from decisions import tree
from ideal_world import IdealWorld
from players.forward import Forward
from roles.attacker import Attacker
from situation.at_ball import Situation
from situation.memory import Memory
from situations import facing_up_point, world
from skills.walk.avoid_own_box import AvoidOwnBox

KELPIE, THESIS = kelpie.RULES_OF_KELPIE, kelpie.RULES_OF_THESIS


def by(rules, made):
    """The same world, played by those rules."""
    made.task = kelpie.Task(rules=rules)
    return made


def sort(name):
    """Left and right alike, and every leaf with a grab is a GrabDribble."""
    return 'grab' if name in tree.WITH_GRAB else name.replace('_left', '').replace('_right', '')


def played(made, contested=False):
    """The leaf that an attacker plays."""
    player = Attacker(Memory())
    player.contested.frames = 0 if contested else 100
    player.choose_leaf(made)
    return player


# The leaf: ball's y, deg of the point up-field of the ball, contested or not; section
LEAVES = [
    (150, 0, False, 'dribble'), (150, 30, False, 'head'), (150, 50, False, 'upenn'),   # Alg 5.2
    (150, 90, False, 'grab'),
    (150, 0, True, 'dribble'), (150, 50, True, 'upenn'), (150, 80, True, 'dribble'),   # Alg 5.3
    (270, 0, False, 'grab'), (270, 30, False, 'head'), (270, 100, False, 'upenn'),     # Alg 5.5
    (270, 0, True, 'grab'), (270, 50, True, 'upenn'), (270, 100, True, 'grab'),        # Alg 5.6
    (400, 0, False, 'grab'), (400, 50, False, 'grab'),                                 # Alg 5.7
    (400, 50, True, 'upenn'), (515, 0, False, 'dribble')]


@pytest.mark.parametrize('y, degrees, contested, wanted', LEAVES)
def test_by_the_theses_the_tree_alone_says_what_is_played(y, degrees, contested, wanted):
    player = played(by(THESIS, facing_up_point(degrees, (180.0, y))), contested)
    assert sort(player.leaf) == wanted and player.leaf == player.tree_leaf


@pytest.mark.parametrize('y, degrees, contested, wanted', LEAVES)
def test_kelpie_grabs_whatever_is_contested(y, degrees, contested, wanted):
    player = played(by(KELPIE, facing_up_point(degrees, (180.0, y))), contested)
    assert sort(player.leaf) == 'grab' or not contested


@pytest.mark.parametrize('rules, leaf', [(KELPIE, 'line_up_kick'), (THESIS, tree.GRAB_TURN_KICK)])
def test_by_the_theses_a_ball_is_grabbed_whatever_the_switch_says(rules, leaf):
    made = by(rules, facing_up_point(90.0, (180.0, 150.0)))
    made.task.grab = False
    assert played(made).leaf == leaf


@pytest.mark.parametrize('rules, leaf', [(KELPIE, tree.GRAB_TURN_KICK),
                                         (THESIS, tree.AVOID_OWN_GOAL)])
def test_a_contested_ball_of_the_own_third_is_not_driven_on_to_the_own_goal(rules, leaf):
    """Section 5.6: nobody runs into the ball from the wrong side."""
    made = by(rules, world(180.0, 180.0, -90.0, (180.0, 150.0)))
    assert tree.decide(Situation(made, True, False))[0] == leaf
    assert isinstance(played(made, True).skill, AvoidOwnBox) is (rules == THESIS)


def test_to_avoid_its_own_goal_a_robot_walks_to_the_side_of_the_ball():
    """Alg 4.3; it does not walk over the ball to get behind it, which section 5.6 took out."""
    made = by(THESIS, world(180.0, 180.0, -90.0, (180.0, 150.0)))
    walk = played(made, True).skill.step(made).walk
    assert abs(walk.left) > 20.0 and 0.0 < walk.forward < abs(walk.left)


class GoalOverTheBall(IdealWorld):
    """Its goal is seen by the foot, too: with a ball under the chin the camera looks down."""

    def in_view(self, point, height):
        return any(super(GoalOverTheBall, self).in_view(point, each) for each in (height, 3.0))


# Of seed 2 the ball lies 344 cm away: nobody sees it from there, and who plays by the theses' rules
# turns on the spot for ever.
@pytest.mark.parametrize('seed', [0, 1, 3, 4, 5, 6])
def test_by_the_theses_rules_a_lone_robot_scores(seed):
    ideal, player, motions = GoalOverTheBall(seed), Forward(), set()
    by(THESIS, ideal.world)
    while not ideal.scored and ideal.world.time_s < 60.0:
        command = player.step(ideal.world)
        motions.add(command.motion)
        ideal.step(command)
    assert ideal.scored and ideal.grabs > 0
    assert kelpie.KICK_FORWARD not in motions   # a kick of ours


# Sub-zones of figure 5.2: a held ball at a side edge is brought in by section 6.4.5, in a corner it
# is struck across, as Alg 6.9 passes it.
@pytest.mark.parametrize('rules, ball, leaf', [
    (THESIS, (30.0, 270.0), tree.GRAB_DRIBBLE_GOAL),
    (KELPIE, (30.0, 270.0), tree.GRAB_DRIBBLE_GOAL),
    (THESIS, (30.0, 500.0), tree.GRAB_UPENN_RIGHT),
    (KELPIE, (30.0, 500.0), tree.GRAB_TURN_SHOOT)])
def test_which_grab_it_is_goes_by_the_sub_zone(rules, ball, leaf):
    made = by(rules, world(ball[0] + 25.0, ball[1], 180.0, ball))
    assert tree.grab_leaf(Situation(made, False, False)) == leaf
