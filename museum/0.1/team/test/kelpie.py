# SPDX-License-Identifier: Apache-2.0
# Stands in for the host's module `kelpie` under a plain python3. Written from the field
# lists by behaviour_names when the tree is built.
GOAL_BLUE, GOAL_YELLOW, BEACON_BLUE_ON_PINK, BEACON_PINK_ON_BLUE, BEACON_YELLOW_ON_PINK, \
    BEACON_PINK_ON_YELLOW = range(6)
PINKS_OFF, PINKS_MAP, PINKS_LOCALISE = range(3)
LAYER_PLAYER, LAYER_ROLE, LAYER_DECISION, LAYER_SKILL = range(4)
WALK, WALK_FAST, WALK_TURNING, WALK_DRIBBLE, WALK_BACK, WALK_LOW, WALK_WEAK = range(7)
AIM_JOINTS, AIM_DIRECTION, AIM_POINT = range(3)
NOT_FALLEN, ON_FRONT, ON_BACK, ON_LEFT, ON_RIGHT = range(5)
RED, BLUE = range(2)
INITIAL, READY, SET, PLAYING, FINISHED = range(5)
LINE, BORDER, FIELD = range(3)
NECK_TILT, HEAD_PAN, HEAD_NOD, MOUTH = range(4)
LED_HEAD_COLOUR, LED_HEAD_WHITE, LED_MODE_RED, LED_MODE_GREEN, LED_MODE_BLUE, \
    LED_WIRELESS = (1 << i for i in range(6))
LED_FACE = tuple(1 << i for i in range(6, 20))
LED_BACK_FRONT_COLOUR, LED_BACK_FRONT_WHITE, LED_BACK_MIDDLE_COLOUR, \
    LED_BACK_MIDDLE_WHITE, LED_BACK_REAR_COLOUR, LED_BACK_REAR_WHITE = \
    (1 << i for i in range(20, 26))
ANEW = object()
NO_MOTION, STAND, SIT, KICK_FORWARD, HARD_FORWARD, WEDGE, HEAD_SWIPE_LEFT, HEAD_SWIPE_RIGHT, \
    UPENN_LEFT, UPENN_RIGHT, BLOCK, BLOCK_LEFT, BLOCK_RIGHT, GRAB, GRAB_QUICK, HOLD, RELEASE, \
    GET_UP_FRONT, GET_UP_BACK, GET_UP_LEFT, GET_UP_RIGHT, CHEER, GRAB_LIFT = range(23)
NO_ROLE, ATTACKER, SUPPORTER, STRIKER, DEFENDER, KEEPER = range(6)
GRABS_NOT, GRABS_SOON, HOLDS = range(3)
LOOSE, OURS, THEIRS = range(3)
FORWARD, GOALIE, GOALIE_2004, CHALLENGER, ONE_SKILL = range(5)
RULES_OF_KELPIE, RULES_OF_THESIS = range(2)
KICKS_BY_RULES, KICKS_BY_MAP = range(2)
AIMING_BY_SIGHT, AIMING_BY_POSE = range(2)
SEARCH_BY_CHAIN, SEARCH_BY_SPIN = range(2)
POSITIONS_BY_TREE, POSITIONS_BY_REGRESSION, POSITIONS_BY_PLAY = range(3)
ROLE_NAMES = ('none', 'attacker', 'supporter', 'striker', 'defender', 'goalie')


class Kick:
    """A kick as its file lists it: `mirror` the motion with sides exchanged, `place` cm ahead and
    to the left where the ball must lie, `distance` cm that it goes, `leaf` of the decision tree, ''
    for one that only follows a grab, `hint` (cm, deg) where to look for the ball then, or None."""
    __slots__ = ('name', 'mirror', 'place', 'distance', 'leaf', 'hint')

    def __init__(self, name, mirror, place, distance, leaf, hint):
        self.name, self.mirror, self.place = name, mirror, place
        self.distance, self.leaf, self.hint = distance, leaf, hint


KICKS = {
    KICK_FORWARD: Kick('kick_forward', KICK_FORWARD, (14.0, 0.0), 140.0, 'kick_ahead', None),
    HARD_FORWARD: Kick('hard_forward', HARD_FORWARD, (7.9, -0.1), 251.0, '', None),
    WEDGE: Kick('wedge', WEDGE, (7.9, -0.1), 125.0, '', None),
    HEAD_SWIPE_LEFT: Kick('head_swipe_left', HEAD_SWIPE_RIGHT, (13.0, -3.0), 198.0, 'head_left', (50.0, 30.0)),
    HEAD_SWIPE_RIGHT: Kick('head_swipe_right', HEAD_SWIPE_LEFT, (13.0, 3.0), 198.0, 'head_right', (50.0, -30.0)),
    UPENN_LEFT: Kick('upenn_left', UPENN_RIGHT, (12.0, -6.0), 206.0, 'upenn_left', (25.0, 30.0)),
    UPENN_RIGHT: Kick('upenn_right', UPENN_LEFT, (12.0, 6.0), 206.0, 'upenn_right', (25.0, -30.0)),
}


class GrabConstants:
    __slots__ = (
        'fast_from',
        'closing',
    )

    def __init__(self, *,
                 fast_from=33.0,
                 closing=31.0):
        self.fast_from = fast_from
        self.closing = closing


class RunConstants:
    __slots__ = (
        'round',
        'curve',
        'steer',
        'behind',
        'lead',
        'in_way',
        'body',
        'body_cost',
        'pressed',
        'shot',
    )

    def __init__(self, *,
                 round=24.0,
                 curve=1.4,
                 steer=0.6,
                 behind=35.0,
                 lead=0.25,
                 in_way=110.0,
                 body=32.0,
                 body_cost=75.0,
                 pressed=100.0,
                 shot=0.5):
        self.round = round
        self.curve = curve
        self.steer = steer
        self.behind = behind
        self.lead = lead
        self.in_way = in_way
        self.body = body
        self.body_cost = body_cost
        self.pressed = pressed
        self.shot = shot


class DribbleConstants:
    __slots__ = (
        'time_margin',
        'carry_until',
        'carry_to',
        'carry_from',
        'over_turn',
    )

    def __init__(self, *,
                 time_margin=0.8,
                 carry_until=1.8,
                 carry_to=65.0,
                 carry_from=230.0,
                 over_turn=8):
        self.time_margin = time_margin
        self.carry_until = carry_until
        self.carry_to = carry_to
        self.carry_from = carry_from
        self.over_turn = over_turn


class KickStandConstants:
    __slots__ = (
        'astern',
        'utility',
        'chosen',
    )

    def __init__(self, *,
                 astern=1.5,
                 utility=1.2,
                 chosen=0.3):
        self.astern = astern
        self.utility = utility
        self.chosen = chosen


class ClearanceConstants:
    __slots__ = (
        'utility',
        'far',
        'sideways',
        'across',
        'held',
    )

    def __init__(self, *,
                 utility=0.45,
                 far=180.0,
                 sideways=0.35,
                 across=0.85,
                 held=0.3):
        self.utility = utility
        self.far = far
        self.sideways = sideways
        self.across = across
        self.held = held


class ShotWatchConstants:
    __slots__ = (
        'speed',
        'stand_speed',
        'stand',
        'step',
        'falls_short',
    )

    def __init__(self, *,
                 speed=35.0,
                 stand_speed=160.0,
                 stand=5.0,
                 step=20.0,
                 falls_short=10.0):
        self.speed = speed
        self.stand_speed = stand_speed
        self.stand = stand
        self.step = step
        self.falls_short = falls_short


class AttackerConstants:
    __slots__ = (
        'lost_frames',
        'settled',
        'kept_frames',
    )

    def __init__(self, *,
                 lost_frames=15,
                 settled=35.0,
                 kept_frames=12):
        self.lost_frames = lost_frames
        self.settled = settled
        self.kept_frames = kept_frames


class PassingConstants:
    __slots__ = (
        'min_gain',
    )

    def __init__(self, *,
                 min_gain=0.08):
        self.min_gain = min_gain


class KickMapConstants:
    __slots__ = (
        'nearly',
        'still_good',
        'nearness',
        'out',
        'let_go',
        'freed',
    )

    def __init__(self, *,
                 nearly=0.93,
                 still_good=0.8,
                 nearness=0.6,
                 out=0.5,
                 let_go=0.7,
                 freed=0.4):
        self.nearly = nearly
        self.still_good = still_good
        self.nearness = nearness
        self.out = out
        self.let_go = let_go
        self.freed = freed


class GoalieConstants:
    __slots__ = (
        'between_paws',
        'coming',
        'stands',
        'near',
        'fast',
        'clears',
    )

    def __init__(self, *,
                 between_paws=1.2,
                 coming=10.0,
                 stands=0.35,
                 near=8.0,
                 fast=30.0,
                 clears=32.0):
        self.between_paws = between_paws
        self.coming = coming
        self.stands = stands
        self.near = near
        self.fast = fast
        self.clears = clears


class LeafConstants:
    __slots__ = (
        'keep',
        'grab',
        'free',
    )

    def __init__(self, *,
                 keep=0.04,
                 grab=1.3,
                 free=0.6):
        self.keep = keep
        self.grab = grab
        self.free = free


class RolesConstants:
    __slots__ = (
        'home',
    )

    def __init__(self, *,
                 home=1.0):
        self.home = home


class PositionsConstants:
    __slots__ = (
        'striker_side',
        'behind_ball',
        'defender_behind',
        'defender_reach',
        'beside',
        'back',
        'defends',
        'most',
        'sway',
    )

    def __init__(self, *,
                 striker_side=60.0,
                 behind_ball=80.0,
                 defender_behind=120.0,
                 defender_reach=60.0,
                 beside=45.0,
                 back=55.0,
                 defends=0.45,
                 most=190.0,
                 sway=22.0):
        self.striker_side = striker_side
        self.behind_ball = behind_ball
        self.defender_behind = defender_behind
        self.defender_reach = defender_reach
        self.beside = beside
        self.back = back
        self.defends = defends
        self.most = most
        self.sway = sway


class Constants:
    __slots__ = (
        'grab',
        'run',
        'dribble',
        'kick_stand',
        'clearance',
        'shot_watch',
        'attacker',
        'passing',
        'kick_map',
        'goalie',
        'leaf',
        'roles',
        'positions',
    )

    def __init__(self, *,
                 grab=ANEW,
                 run=ANEW,
                 dribble=ANEW,
                 kick_stand=ANEW,
                 clearance=ANEW,
                 shot_watch=ANEW,
                 attacker=ANEW,
                 passing=ANEW,
                 kick_map=ANEW,
                 goalie=ANEW,
                 leaf=ANEW,
                 roles=ANEW,
                 positions=ANEW):
        self.grab = GrabConstants() if grab is ANEW else grab
        self.run = RunConstants() if run is ANEW else run
        self.dribble = DribbleConstants() if dribble is ANEW else dribble
        self.kick_stand = KickStandConstants() if kick_stand is ANEW else kick_stand
        self.clearance = ClearanceConstants() if clearance is ANEW else clearance
        self.shot_watch = ShotWatchConstants() if shot_watch is ANEW else shot_watch
        self.attacker = AttackerConstants() if attacker is ANEW else attacker
        self.passing = PassingConstants() if passing is ANEW else passing
        self.kick_map = KickMapConstants() if kick_map is ANEW else kick_map
        self.goalie = GoalieConstants() if goalie is ANEW else goalie
        self.leaf = LeafConstants() if leaf is ANEW else leaf
        self.roles = RolesConstants() if roles is ANEW else roles
        self.positions = PositionsConstants() if positions is ANEW else positions


constants = Constants()


class WalkRequest:
    __slots__ = (
        'forward',
        'left',
        'turn_deg',
        'pivot',
        'kind',
    )

    def __init__(self, *,
                 forward=0.0,
                 left=0.0,
                 turn_deg=0.0,
                 pivot=0.0,
                 kind=0):
        self.forward = forward
        self.left = left
        self.turn_deg = turn_deg
        self.pivot = pivot
        self.kind = kind


class Point3:
    __slots__ = (
        'x',
        'y',
        'z',
    )

    def __init__(self, *,
                 x=0.0,
                 y=0.0,
                 z=0.0):
        self.x = x
        self.y = y
        self.z = z


class HeadRequest:
    __slots__ = (
        'neck_tilt_deg',
        'head_pan_deg',
        'head_nod_deg',
        'speed_deg',
        'aim',
        'direction_deg',
        'elevation_deg',
        'target',
    )

    def __init__(self, *,
                 neck_tilt_deg=0.0,
                 head_pan_deg=0.0,
                 head_nod_deg=0.0,
                 speed_deg=0.0,
                 aim=0,
                 direction_deg=0.0,
                 elevation_deg=0.0,
                 target=ANEW):
        self.neck_tilt_deg = neck_tilt_deg
        self.head_pan_deg = head_pan_deg
        self.head_nod_deg = head_nod_deg
        self.speed_deg = speed_deg
        self.aim = aim
        self.direction_deg = direction_deg
        self.elevation_deg = elevation_deg
        self.target = Point3() if target is ANEW else target


class TailRequest:
    __slots__ = (
        'tilt_deg',
        'pan_deg',
    )

    def __init__(self, *,
                 tilt_deg=29.999999999999996,
                 pan_deg=0.0):
        self.tilt_deg = tilt_deg
        self.pan_deg = pan_deg


class EarRequest:
    __slots__ = (
        'left_up',
        'right_up',
    )

    def __init__(self, *,
                 left_up=False,
                 right_up=False):
        self.left_up = left_up
        self.right_up = right_up


class Point2:
    __slots__ = (
        'x',
        'y',
    )

    def __init__(self, *,
                 x=0.0,
                 y=0.0):
        self.x = x
        self.y = y


class TeamNote:
    __slots__ = (
        'role',
        'time_to_ball',
        'grabs',
        'wants',
        'wanted',
        'pass_to',
        'possession',
    )

    def __init__(self, *,
                 role=0,
                 time_to_ball=1000.0,
                 grabs=0,
                 wants=False,
                 wanted=ANEW,
                 pass_to=0,
                 possession=0):
        self.role = role
        self.time_to_ball = time_to_ball
        self.grabs = grabs
        self.wants = wants
        self.wanted = Point2() if wanted is ANEW else wanted
        self.pass_to = pass_to
        self.possession = possession


class Command:
    __slots__ = (
        'walk',
        'head',
        'mouth_open',
        'tail',
        'ears',
        'motion',
        'leds',
        'localise',
        'pinks',
        'team',
        'trace',
    )

    def __init__(self, *,
                 walk=ANEW,
                 head=ANEW,
                 mouth_open=False,
                 tail=ANEW,
                 ears=ANEW,
                 motion=0,
                 leds=0,
                 localise=False,
                 pinks=0,
                 team=ANEW,
                 trace=ANEW):
        self.walk = WalkRequest() if walk is ANEW else walk
        self.head = HeadRequest() if head is ANEW else head
        self.mouth_open = mouth_open
        self.tail = TailRequest() if tail is ANEW else tail
        self.ears = EarRequest() if ears is ANEW else ears
        self.motion = motion
        self.leds = leds
        self.localise = localise
        self.pinks = pinks
        self.team = TeamNote() if team is ANEW else team
        self.trace = [] if trace is ANEW else trace


class HeadAngles:
    __slots__ = (
        'neck_tilt_deg',
        'head_pan_deg',
        'head_nod_deg',
    )

    def __init__(self, *,
                 neck_tilt_deg=0.0,
                 head_pan_deg=0.0,
                 head_nod_deg=0.0):
        self.neck_tilt_deg = neck_tilt_deg
        self.head_pan_deg = head_pan_deg
        self.head_nod_deg = head_nod_deg


class JointAngles:
    __slots__ = (
        'angle_deg',
    )

    def __init__(self, *,
                 angle_deg=ANEW):
        self.angle_deg = [0.0] * 18 if angle_deg is ANEW else angle_deg


class WorldSensors:
    __slots__ = (
        'joints',
        'duty',
        'head_near_distance',
        'head_far_distance',
        'chest_distance',
        'acceleration',
        'paw',
        'chin',
        'head_touch',
        'back',
        'head_near_threshold',
    )

    def __init__(self, *,
                 joints=ANEW,
                 duty=ANEW,
                 head_near_distance=50.0,
                 head_far_distance=150.0,
                 chest_distance=90.0,
                 acceleration=ANEW,
                 paw=ANEW,
                 chin=False,
                 head_touch=0.0,
                 back=ANEW,
                 head_near_threshold=20.0):
        self.joints = JointAngles() if joints is ANEW else joints
        self.duty = [0.0] * 18 if duty is ANEW else duty
        self.head_near_distance = head_near_distance
        self.head_far_distance = head_far_distance
        self.chest_distance = chest_distance
        self.acceleration = [0.0] * 3 if acceleration is ANEW else acceleration
        self.paw = [False] * 4 if paw is ANEW else paw
        self.chin = chin
        self.head_touch = head_touch
        self.back = [False] * 3 if back is ANEW else back
        self.head_near_threshold = head_near_threshold


class Stance:
    __slots__ = (
        'shoulder_height',
        'body_tilt_deg',
        'body_roll_deg',
    )

    def __init__(self, *,
                 shoulder_height=10.0,
                 body_tilt_deg=0.0,
                 body_roll_deg=0.0):
        self.shoulder_height = shoulder_height
        self.body_tilt_deg = body_tilt_deg
        self.body_roll_deg = body_roll_deg


class OdometryVariance:
    __slots__ = (
        'forward',
        'left',
        'turn_deg2',
    )

    def __init__(self, *,
                 forward=0.0,
                 left=0.0,
                 turn_deg2=0.0):
        self.forward = forward
        self.left = left
        self.turn_deg2 = turn_deg2


class Odometry:
    __slots__ = (
        'forward',
        'left',
        'turn_deg',
        'variance',
    )

    def __init__(self, *,
                 forward=0.0,
                 left=0.0,
                 turn_deg=0.0,
                 variance=ANEW):
        self.forward = forward
        self.left = left
        self.turn_deg = turn_deg
        self.variance = OdometryVariance() if variance is ANEW else variance


class Feeling:
    __slots__ = (
        'current',
        'load',
        'stuck',
        'fallen',
        'lifted',
        'ball_held',
        'paw_blocked',
    )

    def __init__(self, *,
                 current=0.0,
                 load=0.0,
                 stuck=False,
                 fallen=0,
                 lifted=False,
                 ball_held=False,
                 paw_blocked=ANEW):
        self.current = current
        self.load = load
        self.stuck = stuck
        self.fallen = fallen
        self.lifted = lifted
        self.ball_held = ball_held
        self.paw_blocked = [False] * 2 if paw_blocked is ANEW else paw_blocked


class MotionStatus:
    __slots__ = (
        'running',
        'seconds_left',
        'ready',
        'lying',
        'effort',
        'low_gain',
        'leg_gain',
        'feeling',
    )

    def __init__(self, *,
                 running=0,
                 seconds_left=0.0,
                 ready=False,
                 lying=False,
                 effort=0.0,
                 low_gain=False,
                 leg_gain=1.0,
                 feeling=ANEW):
        self.running = running
        self.seconds_left = seconds_left
        self.ready = ready
        self.lying = lying
        self.effort = effort
        self.low_gain = low_gain
        self.leg_gain = leg_gain
        self.feeling = Feeling() if feeling is ANEW else feeling


class Battery:
    __slots__ = (
        'current',
        'charge',
    )

    def __init__(self, *,
                 current=0.0,
                 charge=1.0):
        self.current = current
        self.charge = charge


class GameState:
    __slots__ = (
        'state',
        'team',
        'player',
        'penalised',
        'own_score',
        'opponent_score',
        'kick_off',
        'first_half',
        'seconds_left',
    )

    def __init__(self, *,
                 state=3,
                 team=0,
                 player=1,
                 penalised=False,
                 own_score=0,
                 opponent_score=0,
                 kick_off=False,
                 first_half=True,
                 seconds_left=0.0):
        self.state = state
        self.team = team
        self.player = player
        self.penalised = penalised
        self.own_score = own_score
        self.opponent_score = opponent_score
        self.kick_off = kick_off
        self.first_half = first_half
        self.seconds_left = seconds_left


class ElevationError:
    __slots__ = (
        'value_deg',
        'variance_deg2',
    )

    def __init__(self, *,
                 value_deg=0.0,
                 variance_deg2=0.0):
        self.value_deg = value_deg
        self.variance_deg2 = variance_deg2


class PixelPoint:
    __slots__ = (
        'x',
        'y',
    )

    def __init__(self, *,
                 x=0.0,
                 y=0.0):
        self.x = x
        self.y = y


class BallPercept:
    __slots__ = (
        'present',
        'distance',
        'heading_deg',
        'elevation_deg',
        'distance_variance',
        'heading_variance_deg2',
        'elevation_error',
        'centre',
        'radius',
    )

    def __init__(self, *,
                 present=False,
                 distance=0.0,
                 heading_deg=0.0,
                 elevation_deg=0.0,
                 distance_variance=0.0,
                 heading_variance_deg2=0.0,
                 elevation_error=ANEW,
                 centre=ANEW,
                 radius=0.0):
        self.present = present
        self.distance = distance
        self.heading_deg = heading_deg
        self.elevation_deg = elevation_deg
        self.distance_variance = distance_variance
        self.heading_variance_deg2 = heading_variance_deg2
        self.elevation_error = ElevationError() if elevation_error is ANEW else elevation_error
        self.centre = PixelPoint() if centre is ANEW else centre
        self.radius = radius


class PixelBox:
    __slots__ = (
        'left',
        'top',
        'right',
        'bottom',
    )

    def __init__(self, *,
                 left=0.0,
                 top=0.0,
                 right=0.0,
                 bottom=0.0):
        self.left = left
        self.top = top
        self.right = right
        self.bottom = bottom


class LandmarkPercept:
    __slots__ = (
        'kind',
        'distance',
        'heading_deg',
        'elevation_deg',
        'distance_variance',
        'heading_variance_deg2',
        'elevation_error',
        'left_edge_deg',
        'right_edge_deg',
        'left_edge_cut',
        'right_edge_cut',
        'box',
    )

    def __init__(self, *,
                 kind=0,
                 distance=0.0,
                 heading_deg=0.0,
                 elevation_deg=0.0,
                 distance_variance=0.0,
                 heading_variance_deg2=0.0,
                 elevation_error=ANEW,
                 left_edge_deg=0.0,
                 right_edge_deg=0.0,
                 left_edge_cut=False,
                 right_edge_cut=False,
                 box=ANEW):
        self.kind = kind
        self.distance = distance
        self.heading_deg = heading_deg
        self.elevation_deg = elevation_deg
        self.distance_variance = distance_variance
        self.heading_variance_deg2 = heading_variance_deg2
        self.elevation_error = ElevationError() if elevation_error is ANEW else elevation_error
        self.left_edge_deg = left_edge_deg
        self.right_edge_deg = right_edge_deg
        self.left_edge_cut = left_edge_cut
        self.right_edge_cut = right_edge_cut
        self.box = PixelBox() if box is ANEW else box


class GoalGap:
    __slots__ = (
        'goal',
        'left_deg',
        'right_deg',
        'left_cut',
        'right_cut',
        'box',
    )

    def __init__(self, *,
                 goal=0,
                 left_deg=0.0,
                 right_deg=0.0,
                 left_cut=False,
                 right_cut=False,
                 box=ANEW):
        self.goal = goal
        self.left_deg = left_deg
        self.right_deg = right_deg
        self.left_cut = left_cut
        self.right_cut = right_cut
        self.box = PixelBox() if box is ANEW else box


class RobotPercept:
    __slots__ = (
        'team',
        'distance',
        'heading_deg',
        'elevation_deg',
        'distance_variance',
        'heading_variance_deg2',
        'box',
    )

    def __init__(self, *,
                 team=0,
                 distance=0.0,
                 heading_deg=0.0,
                 elevation_deg=0.0,
                 distance_variance=0.0,
                 heading_variance_deg2=0.0,
                 box=ANEW):
        self.team = team
        self.distance = distance
        self.heading_deg = heading_deg
        self.elevation_deg = elevation_deg
        self.distance_variance = distance_variance
        self.heading_variance_deg2 = heading_variance_deg2
        self.box = PixelBox() if box is ANEW else box


class PinkPercept:
    __slots__ = (
        'distance',
        'heading_deg',
        'elevation_deg',
        'distance_variance',
        'heading_variance_deg2',
        'box',
    )

    def __init__(self, *,
                 distance=0.0,
                 heading_deg=0.0,
                 elevation_deg=0.0,
                 distance_variance=0.0,
                 heading_variance_deg2=0.0,
                 box=ANEW):
        self.distance = distance
        self.heading_deg = heading_deg
        self.elevation_deg = elevation_deg
        self.distance_variance = distance_variance
        self.heading_variance_deg2 = heading_variance_deg2
        self.box = PixelBox() if box is ANEW else box


class ObstaclePoint:
    __slots__ = (
        'position',
        'pixel',
    )

    def __init__(self, *,
                 position=ANEW,
                 pixel=ANEW):
        self.position = Point2() if position is ANEW else position
        self.pixel = PixelPoint() if pixel is ANEW else pixel


class FieldEdgePercept:
    __slots__ = (
        'at_left',
        'at_right',
        'support',
        'rms',
    )

    def __init__(self, *,
                 at_left=0.0,
                 at_right=0.0,
                 support=0.0,
                 rms=0.0):
        self.at_left = at_left
        self.at_right = at_right
        self.support = support
        self.rms = rms


class LinePoint:
    __slots__ = (
        'kind',
        'position',
        'weight',
        'pixel',
    )

    def __init__(self, *,
                 kind=0,
                 position=ANEW,
                 weight=0.0,
                 pixel=ANEW):
        self.kind = kind
        self.position = Point2() if position is ANEW else position
        self.weight = weight
        self.pixel = PixelPoint() if pixel is ANEW else pixel


class VisionCounts:
    __slots__ = (
        'sampled_pixels',
        'runs',
        'blobs',
        'refused',
    )

    def __init__(self, *,
                 sampled_pixels=0,
                 runs=0,
                 blobs=0,
                 refused=ANEW):
        self.sampled_pixels = sampled_pixels
        self.runs = runs
        self.blobs = blobs
        self.refused = [0] * 96 if refused is ANEW else refused


class LightGains:
    __slots__ = (
        'brightness',
        'colour',
    )

    def __init__(self, *,
                 brightness=1.0,
                 colour=1.0):
        self.brightness = brightness
        self.colour = colour


class LightMemory:
    __slots__ = (
        'images',
        'brightness',
        'colour',
    )

    def __init__(self, *,
                 images=0.0,
                 brightness=0.0,
                 colour=0.0):
        self.images = images
        self.brightness = brightness
        self.colour = colour


class CameraLight:
    __slots__ = (
        'applied',
        'before',
        'parts_to_make',
        'carpet',
        'line',
        'landmark',
        'glare',
        'missing',
    )

    def __init__(self, *,
                 applied=ANEW,
                 before=ANEW,
                 parts_to_make=0,
                 carpet=ANEW,
                 line=ANEW,
                 landmark=ANEW,
                 glare=False,
                 missing=0):
        self.applied = LightGains() if applied is ANEW else applied
        self.before = LightGains() if before is ANEW else before
        self.parts_to_make = parts_to_make
        self.carpet = LightMemory() if carpet is ANEW else carpet
        self.line = LightMemory() if line is ANEW else line
        self.landmark = LightMemory() if landmark is ANEW else landmark
        self.glare = glare
        self.missing = missing


class Percepts:
    __slots__ = (
        'ball',
        'landmarks',
        'gaps',
        'robots',
        'pink_patches',
        'obstacles',
        'obstacles_ahead',
        'field_edges',
        'line_points',
        'counts',
        'light',
    )

    def __init__(self, *,
                 ball=ANEW,
                 landmarks=ANEW,
                 gaps=ANEW,
                 robots=ANEW,
                 pink_patches=ANEW,
                 obstacles=ANEW,
                 obstacles_ahead=0,
                 field_edges=ANEW,
                 line_points=ANEW,
                 counts=ANEW,
                 light=ANEW):
        self.ball = BallPercept() if ball is ANEW else ball
        self.landmarks = [] if landmarks is ANEW else landmarks
        self.gaps = [] if gaps is ANEW else gaps
        self.robots = [] if robots is ANEW else robots
        self.pink_patches = [] if pink_patches is ANEW else pink_patches
        self.obstacles = [] if obstacles is ANEW else obstacles
        self.obstacles_ahead = obstacles_ahead
        self.field_edges = [] if field_edges is ANEW else field_edges
        self.line_points = [] if line_points is ANEW else line_points
        self.counts = VisionCounts() if counts is ANEW else counts
        self.light = CameraLight() if light is ANEW else light


class Pose2:
    __slots__ = (
        'position',
        'heading_deg',
    )

    def __init__(self, *,
                 position=ANEW,
                 heading_deg=0.0):
        self.position = Point2() if position is ANEW else position
        self.heading_deg = heading_deg


class CameraTilt:
    __slots__ = (
        'tilt_deg',
        'roll_deg',
        'tilt_variance_deg2',
        'roll_variance_deg2',
        'covariance_deg2',
    )

    def __init__(self, *,
                 tilt_deg=0.0,
                 roll_deg=0.0,
                 tilt_variance_deg2=0.08863577145031709,
                 roll_variance_deg2=0.08863577145031709,
                 covariance_deg2=0.0):
        self.tilt_deg = tilt_deg
        self.roll_deg = roll_deg
        self.tilt_variance_deg2 = tilt_variance_deg2
        self.roll_variance_deg2 = roll_variance_deg2
        self.covariance_deg2 = covariance_deg2


class PoseMode:
    __slots__ = (
        'weight',
        'pose',
        'covariance',
        'tilt',
        'cross',
    )

    def __init__(self, *,
                 weight=0.0,
                 pose=ANEW,
                 covariance=ANEW,
                 tilt=ANEW,
                 cross=ANEW):
        self.weight = weight
        self.pose = Pose2() if pose is ANEW else pose
        self.covariance = [0.0] * 9 if covariance is ANEW else covariance
        self.tilt = CameraTilt() if tilt is ANEW else tilt
        self.cross = [0.0] * 6 if cross is ANEW else cross


class SecondHypothesis:
    __slots__ = (
        'present',
        'mode',
    )

    def __init__(self, *,
                 present=False,
                 mode=ANEW):
        self.present = present
        self.mode = PoseMode() if mode is ANEW else mode


class BallEstimate:
    __slots__ = (
        'present',
        'position',
        'velocity',
        'covariance',
        'relative',
        'distance',
        'heading_deg',
        'seconds_since_seen',
        'field_covariance',
        'stopping_point',
    )

    def __init__(self, *,
                 present=False,
                 position=ANEW,
                 velocity=ANEW,
                 covariance=ANEW,
                 relative=ANEW,
                 distance=0.0,
                 heading_deg=0.0,
                 seconds_since_seen=0.0,
                 field_covariance=ANEW,
                 stopping_point=ANEW):
        self.present = present
        self.position = Point2() if position is ANEW else position
        self.velocity = Point2() if velocity is ANEW else velocity
        self.covariance = [0.0] * 4 if covariance is ANEW else covariance
        self.relative = Point2() if relative is ANEW else relative
        self.distance = distance
        self.heading_deg = heading_deg
        self.seconds_since_seen = seconds_since_seen
        self.field_covariance = [0.0] * 4 if field_covariance is ANEW else field_covariance
        self.stopping_point = Point2() if stopping_point is ANEW else stopping_point


class TeamBall:
    __slots__ = (
        'present',
        'position',
        'velocity',
        'covariance',
        'witnesses',
        'outvoted',
        'seconds_since_seen',
    )

    def __init__(self, *,
                 present=False,
                 position=ANEW,
                 velocity=ANEW,
                 covariance=ANEW,
                 witnesses=0,
                 outvoted=0,
                 seconds_since_seen=0.0):
        self.present = present
        self.position = Point2() if position is ANEW else position
        self.velocity = Point2() if velocity is ANEW else velocity
        self.covariance = [0.0] * 4 if covariance is ANEW else covariance
        self.witnesses = witnesses
        self.outvoted = outvoted
        self.seconds_since_seen = seconds_since_seen


class OpponentEstimate:
    __slots__ = (
        'position',
        'covariance',
        'seconds_since_seen',
    )

    def __init__(self, *,
                 position=ANEW,
                 covariance=ANEW,
                 seconds_since_seen=0.0):
        self.position = Point2() if position is ANEW else position
        self.covariance = [0.0] * 4 if covariance is ANEW else covariance
        self.seconds_since_seen = seconds_since_seen


class TeammateEstimate:
    __slots__ = (
        'player',
        'note',
        'pose',
        'position_sd',
        'heading_sd_deg',
        'seconds_since_heard',
        'seconds_since_ball',
    )

    def __init__(self, *,
                 player=1,
                 note=ANEW,
                 pose=ANEW,
                 position_sd=0.0,
                 heading_sd_deg=0.0,
                 seconds_since_heard=0.0,
                 seconds_since_ball=0.0):
        self.player = player
        self.note = TeamNote() if note is ANEW else note
        self.pose = Pose2() if pose is ANEW else pose
        self.position_sd = position_sd
        self.heading_sd_deg = heading_sd_deg
        self.seconds_since_heard = seconds_since_heard
        self.seconds_since_ball = seconds_since_ball


class ObstacleCell:
    __slots__ = (
        'position',
        'own',
        'heard',
    )

    def __init__(self, *,
                 position=ANEW,
                 own=0.0,
                 heard=0.0):
        self.position = Point2() if position is ANEW else position
        self.own = own
        self.heard = heard


class PinkLandmark:
    __slots__ = (
        'position',
        'weight',
    )

    def __init__(self, *,
                 position=ANEW,
                 weight=0.0):
        self.position = Point2() if position is ANEW else position
        self.weight = weight


class Task:
    __slots__ = (
        'player',
        'rules',
        'points',
        'grab',
        'run',
        'kicks',
        'aiming',
        'search',
        'dodge',
        'intercept',
        'positions',
        'passing',
        'distributed_find',
        'bird_of_prey',
        'score_aware',
        'skill',
    )

    def __init__(self, *,
                 player=0,
                 rules=0,
                 points=ANEW,
                 grab=True,
                 run=False,
                 kicks=1,
                 aiming=0,
                 search=0,
                 dodge=True,
                 intercept=True,
                 positions=0,
                 passing=False,
                 distributed_find=True,
                 bird_of_prey=True,
                 score_aware=False,
                 skill=0):
        self.player = player
        self.rules = rules
        self.points = [0.0] * 10 if points is ANEW else points
        self.grab = grab
        self.run = run
        self.kicks = kicks
        self.aiming = aiming
        self.search = search
        self.dodge = dodge
        self.intercept = intercept
        self.positions = positions
        self.passing = passing
        self.distributed_find = distributed_find
        self.bird_of_prey = bird_of_prey
        self.score_aware = score_aware
        self.skill = skill


class Rules:
    __slots__ = (
        'robots_a_side',
        'half_time',
        'ready_time',
        'penalty_time',
        'holding_time',
        'holding_distance',
        'throw_in_from_side',
        'throw_in_from_end',
        'initial_time',
        'ready_still',
        'set_time',
        'own_box_time',
        'leaving_time',
        'pushing_time',
        'fallen_time',
        'stuck_time',
        'stuck_distance',
        'stuck_reach',
    )

    def __init__(self, *,
                 robots_a_side=4,
                 half_time=600.0,
                 ready_time=45.0,
                 penalty_time=30.0,
                 holding_time=3.0,
                 holding_distance=50.0,
                 throw_in_from_side=40.0,
                 throw_in_from_end=100.0,
                 initial_time=5.0,
                 ready_still=2.0,
                 set_time=3.0,
                 own_box_time=1.0,
                 leaving_time=1.0,
                 pushing_time=3.0,
                 fallen_time=20.0,
                 stuck_time=25.0,
                 stuck_distance=10.0,
                 stuck_reach=50.0):
        self.robots_a_side = robots_a_side
        self.half_time = half_time
        self.ready_time = ready_time
        self.penalty_time = penalty_time
        self.holding_time = holding_time
        self.holding_distance = holding_distance
        self.throw_in_from_side = throw_in_from_side
        self.throw_in_from_end = throw_in_from_end
        self.initial_time = initial_time
        self.ready_still = ready_still
        self.set_time = set_time
        self.own_box_time = own_box_time
        self.leaving_time = leaving_time
        self.pushing_time = pushing_time
        self.fallen_time = fallen_time
        self.stuck_time = stuck_time
        self.stuck_distance = stuck_distance
        self.stuck_reach = stuck_reach


class FieldLine:
    __slots__ = (
        'start',
        'end',
    )

    def __init__(self, *,
                 start=ANEW,
                 end=ANEW):
        self.start = Point2() if start is ANEW else start
        self.end = Point2() if end is ANEW else end


class Landmark:
    __slots__ = (
        'kind',
        'position',
    )

    def __init__(self, *,
                 kind=0,
                 position=ANEW):
        self.kind = kind
        self.position = Point2() if position is ANEW else position


class FieldDescription:
    __slots__ = (
        'width',
        'length',
        'goal_width',
        'goal_depth',
        'goal_height',
        'box_width',
        'box_depth',
        'circle_diameter',
        'line_width',
        'side_fringe',
        'end_fringe',
        'border_width',
        'border_corner',
        'beacon_radius',
        'beacon_height',
        'rules',
        'lines',
        'landmarks',
    )

    def __init__(self, *,
                 width=360.0,
                 length=540.0,
                 goal_width=80.0,
                 goal_depth=30.0,
                 goal_height=30.0,
                 box_width=130.0,
                 box_depth=65.0,
                 circle_diameter=36.0,
                 line_width=2.5,
                 side_fringe=20.0,
                 end_fringe=30.0,
                 border_width=0.0,
                 border_corner=0.0,
                 beacon_radius=5.0,
                 beacon_height=40.0,
                 rules=ANEW,
                 lines=ANEW,
                 landmarks=ANEW):
        self.width = width
        self.length = length
        self.goal_width = goal_width
        self.goal_depth = goal_depth
        self.goal_height = goal_height
        self.box_width = box_width
        self.box_depth = box_depth
        self.circle_diameter = circle_diameter
        self.line_width = line_width
        self.side_fringe = side_fringe
        self.end_fringe = end_fringe
        self.border_width = border_width
        self.border_corner = border_corner
        self.beacon_radius = beacon_radius
        self.beacon_height = beacon_height
        self.rules = Rules() if rules is ANEW else rules
        self.lines = [] if lines is ANEW else lines
        self.landmarks = [] if landmarks is ANEW else landmarks


class WorldFrame:
    __slots__ = (
        'time_s',
        'frame',
        'elapsed_s',
        'head',
        'sensors',
        'stance',
        'odometry',
        'motion',
        'battery',
        'game',
        'last_command',
        'percepts',
        'pose',
        'position_sd',
        'heading_sd_deg',
        'seconds_since_landmark',
        'seconds_since_lines',
        'stuck',
        'covariance',
        'modes',
        'second',
        'ball',
        'team_ball',
        'opponents',
        'teammates',
        'obstacles',
        'pink_map',
        'task',
        'field',
    )

    def __init__(self, *,
                 time_s=0.0,
                 frame=0,
                 elapsed_s=0.0,
                 head=ANEW,
                 sensors=ANEW,
                 stance=ANEW,
                 odometry=ANEW,
                 motion=ANEW,
                 battery=ANEW,
                 game=ANEW,
                 last_command=ANEW,
                 percepts=ANEW,
                 pose=ANEW,
                 position_sd=0.0,
                 heading_sd_deg=0.0,
                 seconds_since_landmark=0.0,
                 seconds_since_lines=0.0,
                 stuck=0.0,
                 covariance=ANEW,
                 modes=ANEW,
                 second=ANEW,
                 ball=ANEW,
                 team_ball=ANEW,
                 opponents=ANEW,
                 teammates=ANEW,
                 obstacles=ANEW,
                 pink_map=ANEW,
                 task=ANEW,
                 field=ANEW):
        self.time_s = time_s
        self.frame = frame
        self.elapsed_s = elapsed_s
        self.head = HeadAngles() if head is ANEW else head
        self.sensors = WorldSensors() if sensors is ANEW else sensors
        self.stance = Stance() if stance is ANEW else stance
        self.odometry = Odometry() if odometry is ANEW else odometry
        self.motion = MotionStatus() if motion is ANEW else motion
        self.battery = Battery() if battery is ANEW else battery
        self.game = GameState() if game is ANEW else game
        self.last_command = Command() if last_command is ANEW else last_command
        self.percepts = Percepts() if percepts is ANEW else percepts
        self.pose = Pose2() if pose is ANEW else pose
        self.position_sd = position_sd
        self.heading_sd_deg = heading_sd_deg
        self.seconds_since_landmark = seconds_since_landmark
        self.seconds_since_lines = seconds_since_lines
        self.stuck = stuck
        self.covariance = [0.0] * 9 if covariance is ANEW else covariance
        self.modes = [] if modes is ANEW else modes
        self.second = SecondHypothesis() if second is ANEW else second
        self.ball = BallEstimate() if ball is ANEW else ball
        self.team_ball = TeamBall() if team_ball is ANEW else team_ball
        self.opponents = [] if opponents is ANEW else opponents
        self.teammates = [] if teammates is ANEW else teammates
        self.obstacles = [] if obstacles is ANEW else obstacles
        self.pink_map = [] if pink_map is ANEW else pink_map
        self.task = Task() if task is ANEW else task
        self.field = FieldDescription() if field is ANEW else field


FIELDS = {
    '2006': FieldDescription(width=360.0, length=540.0, goal_width=80.0, goal_depth=30.0, goal_height=30.0, box_width=130.0, box_depth=65.0, circle_diameter=36.0, line_width=2.5, side_fringe=20.0, end_fringe=30.0, border_width=0.0, border_corner=0.0, beacon_radius=5.0, beacon_height=40.0, rules=Rules(robots_a_side=4, half_time=600.0, ready_time=45.0, penalty_time=30.0, holding_time=3.0, holding_distance=50.0, throw_in_from_side=40.0, throw_in_from_end=100.0, initial_time=5.0, ready_still=2.0, set_time=3.0, own_box_time=1.0, leaving_time=1.0, pushing_time=3.0, fallen_time=20.0, stuck_time=25.0, stuck_distance=10.0, stuck_reach=50.0), lines=[FieldLine(start=Point2(x=1.25, y=1.25), end=Point2(x=358.75, y=1.25)), FieldLine(start=Point2(x=358.75, y=538.75), end=Point2(x=1.25, y=538.75)), FieldLine(start=Point2(x=358.75, y=1.25), end=Point2(x=358.75, y=538.75)), FieldLine(start=Point2(x=1.25, y=538.75), end=Point2(x=1.25, y=1.25)), FieldLine(start=Point2(x=1.25, y=270.0), end=Point2(x=358.75, y=270.0)), FieldLine(start=Point2(x=116.25, y=1.25), end=Point2(x=116.25, y=63.75)), FieldLine(start=Point2(x=116.25, y=63.75), end=Point2(x=243.75, y=63.75)), FieldLine(start=Point2(x=243.75, y=63.75), end=Point2(x=243.75, y=1.25)), FieldLine(start=Point2(x=116.25, y=538.75), end=Point2(x=116.25, y=476.25)), FieldLine(start=Point2(x=116.25, y=476.25), end=Point2(x=243.75, y=476.25)), FieldLine(start=Point2(x=243.75, y=476.25), end=Point2(x=243.75, y=538.75))], landmarks=[Landmark(kind=0, position=Point2(x=180.0, y=540.0)), Landmark(kind=1, position=Point2(x=180.0, y=0.0)), Landmark(kind=2, position=Point2(x=-15.0, y=405.0)), Landmark(kind=3, position=Point2(x=375.0, y=405.0)), Landmark(kind=4, position=Point2(x=-15.0, y=135.0)), Landmark(kind=5, position=Point2(x=375.0, y=135.0))]),
    'osaka2005': FieldDescription(width=363.0, length=542.0, goal_width=80.0, goal_depth=30.0, goal_height=30.0, box_width=128.0, box_depth=65.0, circle_diameter=36.0, line_width=2.4, side_fringe=19.0, end_fringe=29.0, border_width=0.0, border_corner=0.0, beacon_radius=5.0, beacon_height=40.0, rules=Rules(robots_a_side=4, half_time=600.0, ready_time=45.0, penalty_time=30.0, holding_time=3.0, holding_distance=50.0, throw_in_from_side=40.0, throw_in_from_end=100.0, initial_time=5.0, ready_still=2.0, set_time=3.0, own_box_time=1.0, leaving_time=1.0, pushing_time=3.0, fallen_time=20.0, stuck_time=25.0, stuck_distance=10.0, stuck_reach=50.0), lines=[FieldLine(start=Point2(x=1.2, y=1.2), end=Point2(x=361.8, y=1.2)), FieldLine(start=Point2(x=361.8, y=540.8), end=Point2(x=1.2, y=540.8)), FieldLine(start=Point2(x=361.8, y=1.2), end=Point2(x=361.8, y=540.8)), FieldLine(start=Point2(x=1.2, y=540.8), end=Point2(x=1.2, y=1.2)), FieldLine(start=Point2(x=1.2, y=271.0), end=Point2(x=361.8, y=271.0)), FieldLine(start=Point2(x=118.7, y=1.2), end=Point2(x=118.7, y=63.8)), FieldLine(start=Point2(x=118.7, y=63.8), end=Point2(x=244.3, y=63.8)), FieldLine(start=Point2(x=244.3, y=63.8), end=Point2(x=244.3, y=1.2)), FieldLine(start=Point2(x=118.7, y=540.8), end=Point2(x=118.7, y=478.2)), FieldLine(start=Point2(x=118.7, y=478.2), end=Point2(x=244.3, y=478.2)), FieldLine(start=Point2(x=244.3, y=478.2), end=Point2(x=244.3, y=540.8))], landmarks=[Landmark(kind=0, position=Point2(x=181.5, y=542.0)), Landmark(kind=1, position=Point2(x=181.5, y=0.0)), Landmark(kind=2, position=Point2(x=-13.0, y=406.0)), Landmark(kind=3, position=Point2(x=376.0, y=406.0)), Landmark(kind=4, position=Point2(x=-13.0, y=136.0)), Landmark(kind=5, position=Point2(x=376.0, y=136.0))]),
    '2004': FieldDescription(width=290.0, length=440.0, goal_width=60.0, goal_depth=30.0, goal_height=30.0, box_width=100.0, box_depth=50.0, circle_diameter=30.0, line_width=2.4, side_fringe=0.0, end_fringe=0.0, border_width=10.0, border_corner=50.0, beacon_radius=5.0, beacon_height=40.0, rules=Rules(robots_a_side=4, half_time=600.0, ready_time=45.0, penalty_time=30.0, holding_time=3.0, holding_distance=50.0, throw_in_from_side=40.0, throw_in_from_end=100.0, initial_time=5.0, ready_still=2.0, set_time=3.0, own_box_time=1.0, leaving_time=1.0, pushing_time=3.0, fallen_time=20.0, stuck_time=25.0, stuck_distance=10.0, stuck_reach=50.0), lines=[FieldLine(start=Point2(x=115.0, y=11.2), end=Point2(x=175.0, y=11.2)), FieldLine(start=Point2(x=175.0, y=428.8), end=Point2(x=115.0, y=428.8)), FieldLine(start=Point2(x=10.0, y=220.0), end=Point2(x=280.0, y=220.0)), FieldLine(start=Point2(x=96.2, y=11.2), end=Point2(x=96.2, y=58.8)), FieldLine(start=Point2(x=96.2, y=58.8), end=Point2(x=193.8, y=58.8)), FieldLine(start=Point2(x=193.8, y=58.8), end=Point2(x=193.8, y=11.2)), FieldLine(start=Point2(x=96.2, y=428.8), end=Point2(x=96.2, y=381.2)), FieldLine(start=Point2(x=96.2, y=381.2), end=Point2(x=193.8, y=381.2)), FieldLine(start=Point2(x=193.8, y=381.2), end=Point2(x=193.8, y=428.8))], landmarks=[Landmark(kind=0, position=Point2(x=145.0, y=440.0)), Landmark(kind=1, position=Point2(x=145.0, y=0.0)), Landmark(kind=2, position=Point2(x=-5.0, y=445.0)), Landmark(kind=3, position=Point2(x=295.0, y=445.0)), Landmark(kind=4, position=Point2(x=-5.0, y=-5.0)), Landmark(kind=5, position=Point2(x=295.0, y=-5.0))]),
}
