# SPDX-License-Identifier: Apache-2.0
"""What the robot that plays the ball does in a frame: which rule comes first, which skill plays a
leaf, who may take the head or interrupt it, and what it tells."""
from types import SimpleNamespace

import kelpie
import pytest
from arbiter.skill import Skill
from decisions import tree
from roles.attacker import Attacker, has_goalie
from situation.memory import Memory
from situations import put_ball, world
from skills.ball.dribble import Dribble
from skills.ball.find_ball import FindBall
from skills.ball.grab_dribble import GrabDribble
from skills.ball.kick_ball import KickBall
from skills.ball.line_up_kick import LineUpKick

LEAVES = {tree.UPENN_LEFT: kelpie.UPENN_LEFT, tree.UPENN_RIGHT: kelpie.UPENN_RIGHT,
          tree.HEAD_LEFT: kelpie.HEAD_SWIPE_LEFT, tree.HEAD_RIGHT: kelpie.HEAD_SWIPE_RIGHT}


def playing(ball=(180.0, 400.0), at=(180.0, 250.0), **changes):
    """An attacker that plays a ball it has seen for long; `changes` of its memory."""
    made, memory = world(*at, 90.0, ball), Memory(ball_lost=0)
    memory.ball_run, memory.localised_lost = 30, 0
    for name, value in changes.items():
        setattr(memory, name, value)
    player = Attacker(memory)
    player.enter(made, player.play)
    return made, player


class Stub(Skill):
    """A skill that stands, and says what it is told to."""

    def __init__(self, committed=False, done=False, hint=None, approached=False, grabbed=False):
        self.committed, self.done, self.hint = committed, done, hint
        self.approached, self.grabbed = approached, grabbed

    def step(self, made):
        return kelpie.Command()

    def explain(self, trace):
        trace.append((kelpie.LAYER_SKILL, 'stub', 'stands', ''))


def with_skill(ball=(180.0, 400.0), memory=None, **said):
    made, player = playing(ball, **(memory or {}))
    player.skill, player.leaf = Stub(**said), 'dribble'
    made.frame = 1
    return made, player


# The order of algorithm 4.2

def test_an_attacker_that_spun_for_a_far_ball_looks_at_a_landmark():
    made, player = playing(spin_lost=20, localised_lost=61)
    command = player.step(made)
    assert player.state == player.localise and command.head.aim == kelpie.AIM_POINT
    made, player = playing(spin_lost=20, localised_lost=60)
    player.step(made)
    assert player.state == player.play


@pytest.mark.parametrize('away, forward', [(150.0, 34.0), (60.0, 12.0), (49.0, 0.0)])
def test_it_walks_on_to_50_cm_before_the_ball_while_it_looks(away, forward):
    made, player = playing(spin_lost=20, localised_lost=61)
    player.step(made)
    put_ball(made, 180.0, 250.0 + away)
    assert player.localise(made).walk.forward == pytest.approx(forward)
    made.ball.present = False
    assert player.localise(made).walk.forward == 0.0


@pytest.mark.parametrize('change, state', [
    ({}, 'play'), ({'paws': [True, False]}, 'back_off'), ({'lost': 16}, 'find'),
    ({'box': True}, 'avoid_box'), ({'box': True, 'lost': 16}, 'find'),
    ({'box': True, 'paws': [True, False]}, 'back_off'), ({'ended': True}, 'watch'),
    ({'ended': True, 'lost': 16}, 'watch'), ({'ended': True, 'paws': [True, False]}, 'back_off')])
def test_of_all_that_holds_the_first_rule_is_followed(change, state):
    """Paws, a skill that has ended, a lost ball, one in the own box, a look, and play."""
    ball = (180.0, 40.0) if 'box' in change else (180.0, 400.0)
    made, player = with_skill(ball, {'ball_lost': change.get('lost', 0)},
                              done='ended' in change)
    made.motion.feeling.paw_blocked = change.get('paws', [False, False])
    player.choose(made, player.situation(made))
    assert player.state.__name__ == state


def test_a_ball_in_the_own_box_is_not_left_by_who_holds_it_already():
    for grab_lost, waits in ((1, False), (2, True)):
        made, player = playing((180.0, 40.0), (180.0, 110.0), grab_lost=grab_lost)
        assert player.box_in_the_way(made) is waits


def test_what_is_committed_is_not_interrupted():
    for committed in (True, False):
        made, player = with_skill(memory={'ball_lost': 30}, committed=committed)
        assert player.committed is committed
        player.step(made)
        assert (player.state == player.play) is committed


@pytest.mark.parametrize('state, committed, passed', [
    ('play', True, 4), ('play', False, 0), ('watch', False, 4), ('find', True, 0)])
def test_it_tells_whom_it_passes_to_from_the_stop_until_the_ball_has_rolled(state, committed,
                                                                          passed):
    made, player = with_skill(committed=committed)
    player.enter(made, getattr(player, state), player.skill)
    player.held.pass_to = 4
    assert player.pass_to == passed


def test_it_wants_the_ball_that_it_believes_in():
    made, player = playing((200.0, 380.0))
    assert player.wanted(made) == (200.0, 380.0)
    made.ball.present = False
    assert player.wanted(made) is None


# Skills and their leaves

@pytest.mark.parametrize('leaf, kick', LEAVES.items())
def test_a_leaf_with_a_kicks_name_is_that_kick(leaf, kick):
    skill = playing()[1].make(leaf)
    assert isinstance(skill, KickBall) and skill.which == kick


@pytest.mark.parametrize('leaf, kind', [
    ('dribble', Dribble), ('line_up_kick', LineUpKick), ('grab_turn_kick', GrabDribble),
    ('grab_turn_shoot', GrabDribble), ('grab_dribble_goal', GrabDribble),
    ('grab_upenn_left', GrabDribble)])
def test_the_other_leaves_drive_it_line_up_or_grab_with_their_plan(leaf, kind):
    made, player = playing()
    player.held.pass_to = 3
    skill = player.make(leaf)
    assert isinstance(skill, kind)
    if kind is GrabDribble:
        assert skill.plan == leaf and player.held.pass_to == 0


def test_without_grabs_a_grab_is_a_kick_from_a_line():
    made, player = playing((180.0, 300.0), (180.0, 270.0))
    made.task.grab = False
    player.choose_leaf(made)
    assert player.leaf == 'line_up_kick' and player.tree_leaf in tree.WITH_GRAB


@pytest.mark.parametrize('frame, committed, asked', [(1, False, False), (2, False, True),
                                                     (2, True, False), (3, False, False)])
def test_the_tree_is_asked_in_every_second_frame_of_a_skill_that_is_not_committed(frame, committed,
                                                                                asked):
    made, player = with_skill(committed=committed)
    player.tree_leaf, made.frame = None, frame
    player.play(made)
    assert (player.tree_leaf is not None) is asked


@pytest.mark.parametrize('away, frames, kept', [(36.0, 1, False), (34.0, 11, True),
                                                (34.0, 12, False)])
def test_a_leaf_is_kept_within_35_cm_of_the_ball_for_12_frames(away, frames, kept):
    made, player = playing((180.0, 250.0 + away))
    player.choose_leaf(made)
    player.leaf, before = 'upenn_left', player.skill
    player.memory.frame += frames
    player.choose_leaf(made)
    assert (player.skill is before) is kept


@pytest.mark.parametrize('said, remembered', [
    ({'approached': True}, ('approach_lost', 0)), ({'grabbed': True}, ('grab_lost', 0)),
    ({'hint': (30.0, 40.0)}, ('hint', (30.0, 40.0, 0)))])
def test_what_a_skill_says_of_the_ball_is_remembered(said, remembered):
    made, player = with_skill(**said)
    player.play(made)
    assert getattr(player.memory, remembered[0]) == remembered[1]
    quiet = with_skill()[1]
    quiet.play(made)
    assert (quiet.memory.approach_lost, quiet.memory.grab_lost, quiet.memory.hint) == (
        10000, 10000, None)


# Head and legs

@pytest.mark.parametrize('committed, glances', [(False, True), (True, False)])
def test_the_head_looks_at_a_landmark_on_the_way_unless_the_skill_is_committed(committed, glances):
    made, player = with_skill(memory={'localised_lost': 71}, committed=committed)
    player.play(made)
    assert player.glance.looking is glances
    assert (player.memory.localised_lost == 0) is glances


def test_beside_the_own_box_the_head_looks_at_landmarks_too_and_the_frames_are_counted():
    made, player = playing((180.0, 40.0), (180.0, 110.0), localised_lost=71)
    player.step(made)
    assert player.state == player.avoid_box and player.glance.looking and player.box_frames == 1
    player.step(made)
    assert player.box_frames == 2


@pytest.mark.parametrize('roles, heard', [((kelpie.KEEPER,), True), ((kelpie.STRIKER,), False),
                                          ((kelpie.STRIKER, kelpie.KEEPER), True), ((), False)])
def test_a_goalie_is_a_mate_that_says_so(roles, heard):
    mates = [kelpie.TeammateEstimate(note=kelpie.TeamNote(role=role)) for role in roles]
    assert has_goalie(SimpleNamespace(teammates=mates)) is heard


def test_alone_it_searches_alone_and_with_mates_where_the_team_says():
    made, player = playing()
    calls = []
    player.enter(made, player.find, None)
    player.team_search = SimpleNamespace(step=lambda one: calls.append(one) or kelpie.Command(),
                                         active=False)
    player.find(made)
    assert isinstance(player.skill, FindBall) and not calls
    made.teammates = [kelpie.TeammateEstimate()]
    player.find(made)
    assert calls == [made]


@pytest.mark.parametrize('lost, together', [(100, False), (167, True)])
def test_an_attacker_searches_alone_for_166_frames(lost, together):
    made, player = playing(ball_lost=lost)
    made.ball.present = made.percepts.ball.present = False
    made.game.player, made.teammates = 2, [kelpie.TeammateEstimate(player=3)]
    player.enter(made, player.find, FindBall(made, player.memory))
    player.find(made)
    assert player.team_search.active is together


def test_a_search_goes_on_from_where_a_watch_left_it():
    made, player = playing()
    search = player.skill_of('watch', SimpleNamespace(world=made))
    player.skill = search
    assert player.skill_of('find', SimpleNamespace(world=made)) is search
    player.skill = Stub()
    assert isinstance(player.skill_of('find', SimpleNamespace(world=made)), FindBall)


def test_after_a_skill_its_leaf_and_the_maps_values_are_forgotten():
    made, player = with_skill()
    before = player.by_map
    player.after_skill(made)
    assert player.leaf is None and player.by_map is not before


@pytest.mark.parametrize('side', [1.0, -1.0])
def test_without_sight_or_pose_of_the_goal_a_ball_is_driven_where_the_pose_has_it(side):
    made, player = playing()
    made.heading_sd_deg, made.pose.heading_deg = 90.0, 90.0 - side * 30.0
    assert player.goal_heading(made) == pytest.approx(side * 30.0)


# What it tells

def told(player):
    trace = []
    player.explain(trace)
    return [step[1:3] for step in trace]


def test_it_tells_the_trees_leaf_and_who_played_another():
    made, player = with_skill()
    player.tree_leaf, player.tree_why, player.tree_place = 'dribble', ('why',), '0y'
    player.leaf_why = ('why',)
    assert told(player) == [('attacker', 'play'), ('tree 0y', 'dribble'), ('stub', 'stands')]
    player.leaf, player.chosen_by = 'upenn_left', 'leaf_by_map'
    assert told(player) == [('attacker', 'play'), ('tree 0y', 'dribble'),
                            ('leaf_by_map', 'upenn_left'), ('stub', 'stands')]
    player.enter(made, player.back_off, player.skill)
    assert told(player) == [('attacker', 'back_off'), ('stub', 'stands')]


def test_it_tells_of_a_glance_and_of_the_teams_search():
    made, player = with_skill(memory={'localised_lost': 71})
    player.play(made)
    assert ('glance', 'look') in told(player)
    player.enter(made, player.find, player.skill)
    player.team_search = SimpleNamespace(
        active=True, explain=lambda trace: trace.append((kelpie.LAYER_SKILL, 'together', 'x', '')))
    assert told(player)[-1] == ('together', 'x')
    player.team_search.active = False
    assert told(player)[-1] == ('stub', 'stands')
