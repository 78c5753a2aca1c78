# SPDX-License-Identifier: Apache-2.0
# The decision tree of the robot that plays the ball (thesis 2006 chapter 5), as data: which skill,
# from a Situation. Nodes ask, leaves name skills; misprints are read as in checklist G27 to G33.
# The thesis leaves open what happens at offensive edges and in offensive contests, where its own
# goal is avoided, and which of its six leaves with grab a GrabDribble is: those sub-trees are ours.
# Keeps nothing.
from lib import zones
from situation.at_ball import FACING_GOAL, FAR_OUT, NEAR_LINE

# Leaves with a grab,
GRAB_TURN_KICK, GRAB_TURN_SHOOT, GRAB_DRIBBLE_GOAL, GRAB_DRIBBLE_STOP, GRAB_UPENN_LEFT, \
    GRAB_UPENN_RIGHT = WITH_GRAB = (
        'grab_turn_kick', 'grab_turn_shoot', 'grab_dribble_goal', 'grab_dribble_stop',
        'grab_upenn_left', 'grab_upenn_right')
# and without one. A ball in the own box is avoided before the tree is asked (roles/attacker.py).
DRIBBLE, UPENN_LEFT, UPENN_RIGHT, HEAD_LEFT, HEAD_RIGHT, AVOID_OWN_GOAL = WITHOUT_GRAB = (
    'dribble', 'upenn_left', 'upenn_right', 'head_left', 'head_right', 'avoid_own_goal')
LEAVES = WITH_GRAB + WITHOUT_GRAB
KICK_AHEAD = 'kick_ahead'   # ours, of the kick map alone: a free ball straight ahead
RUN = 'run'                 # ours, of lib/rulebook.py's runs(): pushed ahead and run after

SHOOTING = 170.0     # cm to the goal from which a held ball is shot at a gap
ROUGHLY_UP = 30.0    # deg: "facing roughly the right direction", Alg 5.3
MAX_REASON = 80      # characters of a trace's reason


class Node:
    """A question with its two answers: a Node or a leaf's name each. `says`: what yes and no mean,
    for reasons and the drawing; `of`: the Situation's number that it asks about, or ''."""

    def __init__(self, question, test, yes, no, says=('', ''), of=''):
        self.question, self.test, self.yes, self.no = question, test, yes, no
        self.says, self.of = says, of


def within(name, of, low, high, yes, no, closed=True):
    """low <= |number| < high; with closed=False low < |number|, as Alg 5.2 and 5.5 print it."""
    def test(s):
        size = abs(getattr(s, of))
        return (low <= size if closed else low < size) and size < high
    asked = f'{name} {low:.0f} to {high:.0f} deg aside?'
    return Node(asked, test, yes, no, (f'{name} {{}} deg aside', ''), of)


def by_side(of, left, right, left_is=1.0):
    """Left where the number, times left_is, is not negative."""
    return Node('to the left?', lambda s: left_is * getattr(s, of) >= 0.0, left, right,
                ('to the left', 'to the right'))


def upenn(of='up', left_is=1.0):
    return by_side(of, UPENN_LEFT, UPENN_RIGHT, left_is)


def swipe(of='up', left_is=1.0):
    return by_side(of, HEAD_LEFT, HEAD_RIGHT, left_is)


def contest(elsewhere):
    """Alg 5.3 and 5.6: UPenn at 35 to 70 deg, else as given. In the offensive third, where the
    listing is lost, as Alg 5.6: there section 5.8 wants a grab in most situations."""
    return within('up-field', 'up', 35.0, 70.0, upenn(), elsewhere)


def contested_own(grab):
    """Rest of Alg 5.3, which drives the ball on. Driven so by who comes to it from up-field it went
    into the own goal (2 of 16 goals of 6 matches): such a ball is turned with a grab, as Alg 5.5
    has it (G32); by the theses alone it is what section 5.6 warns of, and their leaf for that."""
    turn = Node('turned with a grab?', lambda s: s.rules.GRABS_BEFORE_OWN_GOAL, grab,
                AVOID_OWN_GOAL)
    drive = Node('own goal ahead?', lambda s: s.own_goal_ahead, turn, DRIBBLE,
                 ('own goal ahead', 'nothing better'))
    return Node('about to grab?', lambda s: s.about_to_grab, grab,
                Node('at an edge, looking up-field?',
                     lambda s: s.edge != 0 and abs(s.up) < ROUGHLY_UP, grab, drive,
                     ('at an edge, looking up-field', '')),
                ('about to grab', ''))


def at_edge(grab):
    """Alg 5.4."""
    goal_is = ('goal {} deg off the way to the ball', 'goal {} deg off the way to the ball')
    return Node('ball up-field of the robot, 20 to 160 deg?', lambda s: 20.0 <= s.across <= 160.0,
                Node('goal 30 to 80 deg off the way to the ball?',
                     lambda s: 30.0 <= abs(s.off_goal) <= 80.0, upenn('off_goal', -1.0),
                     swipe('off_goal', -1.0), goal_is, 'off_goal'),
                grab, ('', 'at an edge, ball at {} deg'), 'across')


def defensive(grab):
    """Alg 5.2; its overlapping tests come to these (G28)."""
    rest = within('up-field', 'up', 45.0, 70.0, upenn(),
                  within('up-field', 'up', 10.0, 45.0, swipe(),
                         within('up-field', 'up', 0.0, 20.0, DRIBBLE, grab), closed=False))
    return outside(contest(contested_own(grab)), at_edge(grab), rest)


def middle(grab):
    """Alg 5.5. It grabs when it looks up-field or far away from it."""
    rest = within('up-field', 'up', 45.0, 110.0, upenn(),
                  within('up-field', 'up', 20.0, 45.0, swipe(), grab, closed=False))
    return outside(contest(grab), at_edge(grab), rest)


def offensive(grab):
    """Alg 5.7. From far, straight ahead and in the middle the ball is only driven on."""
    far = Node('very far, goal ahead, in the middle?',
               lambda s: s.goal_distance > FAR_OUT and abs(s.to_goal) < FACING_GOAL and
               s.near_centre, DRIBBLE, grab, ('goal {} cm away, ahead', ''), 'goal_distance')
    on_line = Node('close to the goal line?', lambda s: s.line_distance < NEAR_LINE, DRIBBLE, far,
                   ('{} cm before the goal line', ''), 'line_distance')
    in_corner = Node('in a corner?', lambda s: s.corner != 0,
                     within('goal front', 'crossing', 30.0, 75.0, upenn('crossing', -1.0), grab),
                     on_line)
    return outside(contest(grab), at_edge(grab), in_corner)


def outside(contested, edge, rest):
    """The two questions that all three zones ask first. A corner has its own rule."""
    return Node('contested?', lambda s: s.contested, contested,
                Node('at a side edge?', lambda s: s.side_edge != 0, edge, rest,
                     ('at an edge', '')), ('contested', ''))


def with_grab(region):
    """Ours: which of the six leaves with grab. Own third: turn up-field and kick. Else: where it
    looks out of the field, strike it in; beside the goal, carry it back; near, shoot. The kick map
    needs no plan to strike or to let go: it weighs both in every frame."""
    if region == zones.DEFENSIVE:
        return GRAB_TURN_KICK
    near = Node('near enough to shoot?', lambda s: s.goal_distance < SHOOTING, GRAB_TURN_SHOOT,
                GRAB_DRIBBLE_GOAL, ('goal {} cm away', 'goal {} cm away'), 'goal_distance')
    beside = Node('beside the goal, near its line?',
                  lambda s: s.line_distance < NEAR_LINE and not s.near_centre,
                  GRAB_DRIBBLE_STOP, near, ('beside the goal', ''))
    out = Node('at an edge and looking out?',
               lambda s: s.strike_side != 0 and 60.0 <= -s.strike_side * s.facing <= 120.0,
               by_side('strike_side', GRAB_UPENN_LEFT, GRAB_UPENN_RIGHT), beside,
               ('at an edge, looking out', ''))
    return Node('kick by the map?', lambda s: s.by_kick_map, near, out)


GRABS = {region: with_grab(region)
         for region in (zones.DEFENSIVE, zones.MIDDLE, zones.OFFENSIVE)}
TREE = Node('y < 0.4 length?', lambda s: s.zone == zones.DEFENSIVE,
            defensive(GRABS[zones.DEFENSIVE]),
            Node('y < 0.6 length?', lambda s: s.zone == zones.MIDDLE,
                 middle(GRABS[zones.MIDDLE]), offensive(GRABS[zones.OFFENSIVE]),
                 ('middle', 'offensive')), ('defensive', ''))


def decide(situation, node=TREE) -> tuple:
    """(leaf, place, reason, *numbers): the leaf's name, its id in rows(), and why, as
    Command.trace tells it."""
    place, said = '0', []
    while isinstance(node, Node):
        if node.test(situation):
            place, text, after = place + 'y', node.says[0], node.yes
        else:
            place, text, after = place + 'n', node.says[1], node.no
        if text:
            said.append((text, node.of))
        node = after
    return (node, place, *_why(said, situation))


def grab_leaf(situation) -> str:
    """The leaf with a grab for where the ball lies, whatever the tree says of a grab."""
    node = GRABS[situation.zone]
    while isinstance(node, Node):
        node = node.yes if node.test(situation) else node.no
    return node


def _why(said, situation):
    """What was said on the way, (text, whose number it tells), the newest of it where not all fits,
    and its numbers."""
    reason = '; '.join([text for text, _ in said])
    if len(reason) > MAX_REASON - 2:
        said = _fitting(said)
        reason = '; '.join([text for text, _ in said])
    numbers = [getattr(situation, of) for text, of in said if '{}' in text]
    return (reason, *numbers[:3])


def _fitting(said) -> list:
    kept, size = [], 0
    for text, of in reversed(said):
        if size + len(text) <= MAX_REASON - 2:
            size += len(text) + 2
            kept.insert(0, (text, of))
    return kept


def rows(node=TREE, name='0', above='', edge='') -> list:
    """The tree for a drawing, depth first: (id, id above, answer that leads here, text, leaf?)."""
    if not isinstance(node, Node):
        return [(name, above, edge, node, True)]
    return ([(name, above, edge, node.question, False)] +
            rows(node.yes, name + 'y', name, 'yes') + rows(node.no, name + 'n', name, 'no'))
