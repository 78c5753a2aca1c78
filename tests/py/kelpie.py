# SPDX-License-Identifier: Apache-2.0
# Stands in for the host's module `kelpie` under a plain python3. Written from the field lists:
# behaviour_names > tests/py/kelpie.py; a test compares.
GOAL_BLUE, GOAL_YELLOW, BEACON_BLUE_ON_PINK, BEACON_PINK_ON_BLUE, BEACON_YELLOW_ON_PINK, \
    BEACON_PINK_ON_YELLOW = range(6)
PINKS_OFF, PINKS_MAP, PINKS_LOCALISE = range(3)
FORWARD, GOALIE, GOALIE_2004, CHALLENGER, ONE_SKILL = range(5)
KICKS_BY_RULES, KICKS_BY_MAP = range(2)
AIMING_BY_SIGHT, AIMING_BY_POSE = range(2)
SEARCH_BY_CHAIN, SEARCH_BY_SPIN = range(2)
LAYER_PLAYER, LAYER_ROLE, LAYER_DECISION, LAYER_SKILL = range(4)
NO_MOTION, STAND, SIT, KICK_FORWARD, HARD_FORWARD, WEDGE, HEAD_SWIPE_LEFT, \
    HEAD_SWIPE_RIGHT, UPENN_LEFT, UPENN_RIGHT, BLOCK, BLOCK_LEFT, BLOCK_RIGHT, GRAB, \
    GRAB_QUICK, HOLD, RELEASE, GET_UP_FRONT, GET_UP_BACK, GET_UP_LEFT, GET_UP_RIGHT, \
    CHEER = range(22)
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


class Fields:
    __slots__ = ()

    def _take(self, given):
        for name, value in given.items():
            setattr(self, name, value)


class WalkRequest(Fields):
    __slots__ = (
        'forward',
        'left',
        'turn_deg',
        'pivot',
        'kind',
    )

    def __init__(self, **given):
        self.forward = 0.0
        self.left = 0.0
        self.turn_deg = 0.0
        self.pivot = 0.0
        self.kind = 0
        self._take(given)


class Point3(Fields):
    __slots__ = (
        'x',
        'y',
        'z',
    )

    def __init__(self, **given):
        self.x = 0.0
        self.y = 0.0
        self.z = 0.0
        self._take(given)


class HeadRequest(Fields):
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

    def __init__(self, **given):
        self.neck_tilt_deg = 0.0
        self.head_pan_deg = 0.0
        self.head_nod_deg = 0.0
        self.speed_deg = 0.0
        self.aim = 0
        self.direction_deg = 0.0
        self.elevation_deg = 0.0
        self.target = Point3()
        self._take(given)


class TailRequest(Fields):
    __slots__ = (
        'tilt_deg',
        'pan_deg',
    )

    def __init__(self, **given):
        self.tilt_deg = 29.999999999999996
        self.pan_deg = 0.0
        self._take(given)


class EarRequest(Fields):
    __slots__ = (
        'left_up',
        'right_up',
    )

    def __init__(self, **given):
        self.left_up = False
        self.right_up = False
        self._take(given)


class Command(Fields):
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
        'trace',
    )

    def __init__(self, **given):
        self.walk = WalkRequest()
        self.head = HeadRequest()
        self.mouth_open = False
        self.tail = TailRequest()
        self.ears = EarRequest()
        self.motion = 0
        self.leds = 0
        self.localise = False
        self.pinks = 0
        self.trace = []
        self._take(given)


class HeadAngles(Fields):
    __slots__ = (
        'neck_tilt_deg',
        'head_pan_deg',
        'head_nod_deg',
    )

    def __init__(self, **given):
        self.neck_tilt_deg = 0.0
        self.head_pan_deg = 0.0
        self.head_nod_deg = 0.0
        self._take(given)


class JointAngles(Fields):
    __slots__ = (
        'angle_deg',
    )

    def __init__(self, **given):
        self.angle_deg = [0.0] * 18
        self._take(given)


class SensorFrame(Fields):
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
    )

    def __init__(self, **given):
        self.joints = JointAngles()
        self.duty = [0.0] * 18
        self.head_near_distance = 50.0
        self.head_far_distance = 150.0
        self.chest_distance = 90.0
        self.acceleration = [0.0] * 3
        self.paw = [False] * 4
        self.chin = False
        self.head_touch = 0.0
        self.back = [False] * 3
        self._take(given)


class Stance(Fields):
    __slots__ = (
        'shoulder_height',
        'body_tilt_deg',
        'body_roll_deg',
    )

    def __init__(self, **given):
        self.shoulder_height = 10.0
        self.body_tilt_deg = 0.0
        self.body_roll_deg = 0.0
        self._take(given)


class OdometryVariance(Fields):
    __slots__ = (
        'forward',
        'left',
        'turn_deg2',
    )

    def __init__(self, **given):
        self.forward = 0.0
        self.left = 0.0
        self.turn_deg2 = 0.0
        self._take(given)


class Odometry(Fields):
    __slots__ = (
        'forward',
        'left',
        'turn_deg',
        'variance',
    )

    def __init__(self, **given):
        self.forward = 0.0
        self.left = 0.0
        self.turn_deg = 0.0
        self.variance = OdometryVariance()
        self._take(given)


class Feeling(Fields):
    __slots__ = (
        'current',
        'load',
        'stuck',
        'fallen',
        'ball_held',
        'paw_blocked',
    )

    def __init__(self, **given):
        self.current = 0.0
        self.load = 0.0
        self.stuck = False
        self.fallen = 0
        self.ball_held = False
        self.paw_blocked = [False] * 2
        self._take(given)


class MotionStatus(Fields):
    __slots__ = (
        'running',
        'seconds_left',
        'ready',
        'effort',
        'low_gain',
        'leg_gain',
        'feeling',
    )

    def __init__(self, **given):
        self.running = 0
        self.seconds_left = 0.0
        self.ready = False
        self.effort = 0.0
        self.low_gain = False
        self.leg_gain = 1.0
        self.feeling = Feeling()
        self._take(given)


class GameState(Fields):
    __slots__ = (
        'state',
        'team',
        'player',
        'penalised',
        'own_score',
        'opponent_score',
    )

    def __init__(self, **given):
        self.state = 3
        self.team = 0
        self.player = 1
        self.penalised = False
        self.own_score = 0
        self.opponent_score = 0
        self._take(given)


class ElevationError(Fields):
    __slots__ = (
        'value_deg',
        'variance_deg2',
    )

    def __init__(self, **given):
        self.value_deg = 0.0
        self.variance_deg2 = 0.0
        self._take(given)


class PixelPoint(Fields):
    __slots__ = (
        'x',
        'y',
    )

    def __init__(self, **given):
        self.x = 0.0
        self.y = 0.0
        self._take(given)


class BallPercept(Fields):
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

    def __init__(self, **given):
        self.present = False
        self.distance = 0.0
        self.heading_deg = 0.0
        self.elevation_deg = 0.0
        self.distance_variance = 0.0
        self.heading_variance_deg2 = 0.0
        self.elevation_error = ElevationError()
        self.centre = PixelPoint()
        self.radius = 0.0
        self._take(given)


class PixelBox(Fields):
    __slots__ = (
        'left',
        'top',
        'right',
        'bottom',
    )

    def __init__(self, **given):
        self.left = 0.0
        self.top = 0.0
        self.right = 0.0
        self.bottom = 0.0
        self._take(given)


class LandmarkPercept(Fields):
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

    def __init__(self, **given):
        self.kind = 0
        self.distance = 0.0
        self.heading_deg = 0.0
        self.elevation_deg = 0.0
        self.distance_variance = 0.0
        self.heading_variance_deg2 = 0.0
        self.elevation_error = ElevationError()
        self.left_edge_deg = 0.0
        self.right_edge_deg = 0.0
        self.left_edge_cut = False
        self.right_edge_cut = False
        self.box = PixelBox()
        self._take(given)


class GoalGap(Fields):
    __slots__ = (
        'goal',
        'left_deg',
        'right_deg',
        'left_cut',
        'right_cut',
        'box',
    )

    def __init__(self, **given):
        self.goal = 0
        self.left_deg = 0.0
        self.right_deg = 0.0
        self.left_cut = False
        self.right_cut = False
        self.box = PixelBox()
        self._take(given)


class RobotPercept(Fields):
    __slots__ = (
        'team',
        'distance',
        'heading_deg',
        'elevation_deg',
        'distance_variance',
        'heading_variance_deg2',
        'box',
    )

    def __init__(self, **given):
        self.team = 0
        self.distance = 0.0
        self.heading_deg = 0.0
        self.elevation_deg = 0.0
        self.distance_variance = 0.0
        self.heading_variance_deg2 = 0.0
        self.box = PixelBox()
        self._take(given)


class PinkPercept(Fields):
    __slots__ = (
        'distance',
        'heading_deg',
        'elevation_deg',
        'distance_variance',
        'heading_variance_deg2',
        'box',
    )

    def __init__(self, **given):
        self.distance = 0.0
        self.heading_deg = 0.0
        self.elevation_deg = 0.0
        self.distance_variance = 0.0
        self.heading_variance_deg2 = 0.0
        self.box = PixelBox()
        self._take(given)


class Point2(Fields):
    __slots__ = (
        'x',
        'y',
    )

    def __init__(self, **given):
        self.x = 0.0
        self.y = 0.0
        self._take(given)


class ObstaclePoint(Fields):
    __slots__ = (
        'position',
        'pixel',
    )

    def __init__(self, **given):
        self.position = Point2()
        self.pixel = PixelPoint()
        self._take(given)


class FieldEdgePercept(Fields):
    __slots__ = (
        'at_left',
        'at_right',
        'support',
        'rms',
    )

    def __init__(self, **given):
        self.at_left = 0.0
        self.at_right = 0.0
        self.support = 0.0
        self.rms = 0.0
        self._take(given)


class LinePoint(Fields):
    __slots__ = (
        'kind',
        'position',
        'weight',
        'pixel',
    )

    def __init__(self, **given):
        self.kind = 0
        self.position = Point2()
        self.weight = 0.0
        self.pixel = PixelPoint()
        self._take(given)


class VisionCounts(Fields):
    __slots__ = (
        'sampled_pixels',
        'runs',
        'blobs',
        'refused',
    )

    def __init__(self, **given):
        self.sampled_pixels = 0
        self.runs = 0
        self.blobs = 0
        self.refused = [0] * 96
        self._take(given)


class Percepts(Fields):
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
    )

    def __init__(self, **given):
        self.ball = BallPercept()
        self.landmarks = []
        self.gaps = []
        self.robots = []
        self.pink_patches = []
        self.obstacles = []
        self.obstacles_ahead = 0
        self.field_edges = []
        self.line_points = []
        self.counts = VisionCounts()
        self._take(given)


class Pose2(Fields):
    __slots__ = (
        'position',
        'heading_deg',
    )

    def __init__(self, **given):
        self.position = Point2()
        self.heading_deg = 0.0
        self._take(given)


class CameraTilt(Fields):
    __slots__ = (
        'tilt_deg',
        'roll_deg',
        'tilt_variance_deg2',
        'roll_variance_deg2',
        'covariance_deg2',
    )

    def __init__(self, **given):
        self.tilt_deg = 0.0
        self.roll_deg = 0.0
        self.tilt_variance_deg2 = 0.08863577145031709
        self.roll_variance_deg2 = 0.08863577145031709
        self.covariance_deg2 = 0.0
        self._take(given)


class PoseMode(Fields):
    __slots__ = (
        'weight',
        'pose',
        'covariance',
        'tilt',
        'cross',
    )

    def __init__(self, **given):
        self.weight = 0.0
        self.pose = Pose2()
        self.covariance = [0.0] * 9
        self.tilt = CameraTilt()
        self.cross = [0.0] * 6
        self._take(given)


class SecondHypothesis(Fields):
    __slots__ = (
        'present',
        'mode',
    )

    def __init__(self, **given):
        self.present = False
        self.mode = PoseMode()
        self._take(given)


class BallEstimate(Fields):
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

    def __init__(self, **given):
        self.present = False
        self.position = Point2()
        self.velocity = Point2()
        self.covariance = [0.0] * 4
        self.relative = Point2()
        self.distance = 0.0
        self.heading_deg = 0.0
        self.seconds_since_seen = 0.0
        self.field_covariance = [0.0] * 4
        self.stopping_point = Point2()
        self._take(given)


class TeamBall(Fields):
    __slots__ = (
        'present',
        'position',
        'velocity',
        'covariance',
        'witnesses',
        'outvoted',
        'seconds_since_seen',
    )

    def __init__(self, **given):
        self.present = False
        self.position = Point2()
        self.velocity = Point2()
        self.covariance = [0.0] * 4
        self.witnesses = 0
        self.outvoted = 0
        self.seconds_since_seen = 0.0
        self._take(given)


class OpponentEstimate(Fields):
    __slots__ = (
        'position',
        'covariance',
        'seconds_since_seen',
    )

    def __init__(self, **given):
        self.position = Point2()
        self.covariance = [0.0] * 4
        self.seconds_since_seen = 0.0
        self._take(given)


class TeammateEstimate(Fields):
    __slots__ = (
        'player',
        'role',
        'pose',
        'position_sd',
        'heading_sd_deg',
        'seconds_since_heard',
    )

    def __init__(self, **given):
        self.player = 1
        self.role = 0
        self.pose = Pose2()
        self.position_sd = 0.0
        self.heading_sd_deg = 0.0
        self.seconds_since_heard = 0.0
        self._take(given)


class ObstacleCell(Fields):
    __slots__ = (
        'position',
        'own',
        'heard',
    )

    def __init__(self, **given):
        self.position = Point2()
        self.own = 0.0
        self.heard = 0.0
        self._take(given)


class PinkLandmark(Fields):
    __slots__ = (
        'position',
        'weight',
    )

    def __init__(self, **given):
        self.position = Point2()
        self.weight = 0.0
        self._take(given)


class Task(Fields):
    __slots__ = (
        'player',
        'points',
        'grab',
        'kicks',
        'aiming',
        'search',
        'dodge',
        'intercept',
        'skill',
    )

    def __init__(self, **given):
        self.player = 0
        self.points = [0.0] * 10
        self.grab = True
        self.kicks = 1
        self.aiming = 0
        self.search = 0
        self.dodge = True
        self.intercept = True
        self.skill = 0
        self._take(given)


class Rules(Fields):
    __slots__ = (
        'robots_a_side',
        'half_time',
        'ready_time',
        'penalty_time',
        'holding_time',
        'holding_distance',
        'throw_in_from_side',
        'throw_in_from_end',
    )

    def __init__(self, **given):
        self.robots_a_side = 4
        self.half_time = 600.0
        self.ready_time = 45.0
        self.penalty_time = 30.0
        self.holding_time = 3.0
        self.holding_distance = 50.0
        self.throw_in_from_side = 40.0
        self.throw_in_from_end = 100.0
        self._take(given)


class FieldLine(Fields):
    __slots__ = (
        'start',
        'end',
    )

    def __init__(self, **given):
        self.start = Point2()
        self.end = Point2()
        self._take(given)


class Landmark(Fields):
    __slots__ = (
        'kind',
        'position',
    )

    def __init__(self, **given):
        self.kind = 0
        self.position = Point2()
        self._take(given)


class FieldDescription(Fields):
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

    def __init__(self, **given):
        self.width = 360.0
        self.length = 540.0
        self.goal_width = 80.0
        self.goal_depth = 30.0
        self.goal_height = 30.0
        self.box_width = 130.0
        self.box_depth = 65.0
        self.circle_diameter = 36.0
        self.line_width = 2.5
        self.side_fringe = 20.0
        self.end_fringe = 30.0
        self.border_width = 0.0
        self.border_corner = 0.0
        self.beacon_radius = 5.0
        self.beacon_height = 40.0
        self.rules = Rules()
        self.lines = []
        self.landmarks = []
        self._take(given)


class WorldFrame(Fields):
    __slots__ = (
        'time_s',
        'frame',
        'elapsed_s',
        'head',
        'sensors',
        'stance',
        'odometry',
        'motion',
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

    def __init__(self, **given):
        self.time_s = 0.0
        self.frame = 0
        self.elapsed_s = 0.0
        self.head = HeadAngles()
        self.sensors = SensorFrame()
        self.stance = Stance()
        self.odometry = Odometry()
        self.motion = MotionStatus()
        self.game = GameState()
        self.last_command = Command()
        self.percepts = Percepts()
        self.pose = Pose2()
        self.position_sd = 0.0
        self.heading_sd_deg = 0.0
        self.seconds_since_landmark = 0.0
        self.seconds_since_lines = 0.0
        self.stuck = 0.0
        self.covariance = [0.0] * 9
        self.modes = []
        self.second = SecondHypothesis()
        self.ball = BallEstimate()
        self.team_ball = TeamBall()
        self.opponents = []
        self.teammates = []
        self.obstacles = []
        self.pink_map = []
        self.task = Task()
        self.field = FieldDescription()
        self._take(given)


FIELDS = {
    '2006': FieldDescription(width=360.0, length=540.0, goal_width=80.0, goal_depth=30.0, goal_height=30.0, box_width=130.0, box_depth=65.0, circle_diameter=36.0, line_width=2.5, side_fringe=20.0, end_fringe=30.0, border_width=0.0, border_corner=0.0, beacon_radius=5.0, beacon_height=40.0, rules=Rules(robots_a_side=4, half_time=600.0, ready_time=45.0, penalty_time=30.0, holding_time=3.0, holding_distance=50.0, throw_in_from_side=40.0, throw_in_from_end=100.0), lines=[FieldLine(start=Point2(x=1.25, y=1.25), end=Point2(x=358.75, y=1.25)), FieldLine(start=Point2(x=358.75, y=538.75), end=Point2(x=1.25, y=538.75)), FieldLine(start=Point2(x=358.75, y=1.25), end=Point2(x=358.75, y=538.75)), FieldLine(start=Point2(x=1.25, y=538.75), end=Point2(x=1.25, y=1.25)), FieldLine(start=Point2(x=1.25, y=270.0), end=Point2(x=358.75, y=270.0)), FieldLine(start=Point2(x=116.25, y=1.25), end=Point2(x=116.25, y=63.75)), FieldLine(start=Point2(x=116.25, y=63.75), end=Point2(x=243.75, y=63.75)), FieldLine(start=Point2(x=243.75, y=63.75), end=Point2(x=243.75, y=1.25)), FieldLine(start=Point2(x=116.25, y=538.75), end=Point2(x=116.25, y=476.25)), FieldLine(start=Point2(x=116.25, y=476.25), end=Point2(x=243.75, y=476.25)), FieldLine(start=Point2(x=243.75, y=476.25), end=Point2(x=243.75, y=538.75))], landmarks=[Landmark(kind=0, position=Point2(x=180.0, y=540.0)), Landmark(kind=1, position=Point2(x=180.0, y=0.0)), Landmark(kind=2, position=Point2(x=-15.0, y=405.0)), Landmark(kind=3, position=Point2(x=375.0, y=405.0)), Landmark(kind=4, position=Point2(x=-15.0, y=135.0)), Landmark(kind=5, position=Point2(x=375.0, y=135.0))]),
    'osaka2005': FieldDescription(width=363.0, length=542.0, goal_width=80.0, goal_depth=30.0, goal_height=30.0, box_width=128.0, box_depth=65.0, circle_diameter=36.0, line_width=2.4, side_fringe=19.0, end_fringe=29.0, border_width=0.0, border_corner=0.0, beacon_radius=5.0, beacon_height=40.0, rules=Rules(robots_a_side=4, half_time=600.0, ready_time=45.0, penalty_time=30.0, holding_time=3.0, holding_distance=50.0, throw_in_from_side=40.0, throw_in_from_end=100.0), lines=[FieldLine(start=Point2(x=1.2, y=1.2), end=Point2(x=361.8, y=1.2)), FieldLine(start=Point2(x=361.8, y=540.8), end=Point2(x=1.2, y=540.8)), FieldLine(start=Point2(x=361.8, y=1.2), end=Point2(x=361.8, y=540.8)), FieldLine(start=Point2(x=1.2, y=540.8), end=Point2(x=1.2, y=1.2)), FieldLine(start=Point2(x=1.2, y=271.0), end=Point2(x=361.8, y=271.0)), FieldLine(start=Point2(x=118.7, y=1.2), end=Point2(x=118.7, y=63.8)), FieldLine(start=Point2(x=118.7, y=63.8), end=Point2(x=244.3, y=63.8)), FieldLine(start=Point2(x=244.3, y=63.8), end=Point2(x=244.3, y=1.2)), FieldLine(start=Point2(x=118.7, y=540.8), end=Point2(x=118.7, y=478.2)), FieldLine(start=Point2(x=118.7, y=478.2), end=Point2(x=244.3, y=478.2)), FieldLine(start=Point2(x=244.3, y=478.2), end=Point2(x=244.3, y=540.8))], landmarks=[Landmark(kind=0, position=Point2(x=181.5, y=542.0)), Landmark(kind=1, position=Point2(x=181.5, y=0.0)), Landmark(kind=2, position=Point2(x=-13.0, y=406.0)), Landmark(kind=3, position=Point2(x=376.0, y=406.0)), Landmark(kind=4, position=Point2(x=-13.0, y=136.0)), Landmark(kind=5, position=Point2(x=376.0, y=136.0))]),
    '2004': FieldDescription(width=290.0, length=440.0, goal_width=60.0, goal_depth=30.0, goal_height=30.0, box_width=100.0, box_depth=50.0, circle_diameter=30.0, line_width=2.4, side_fringe=0.0, end_fringe=0.0, border_width=10.0, border_corner=50.0, beacon_radius=5.0, beacon_height=40.0, rules=Rules(robots_a_side=4, half_time=600.0, ready_time=45.0, penalty_time=30.0, holding_time=3.0, holding_distance=50.0, throw_in_from_side=40.0, throw_in_from_end=100.0), lines=[FieldLine(start=Point2(x=115.0, y=11.2), end=Point2(x=175.0, y=11.2)), FieldLine(start=Point2(x=175.0, y=428.8), end=Point2(x=115.0, y=428.8)), FieldLine(start=Point2(x=10.0, y=220.0), end=Point2(x=280.0, y=220.0)), FieldLine(start=Point2(x=96.2, y=11.2), end=Point2(x=96.2, y=58.8)), FieldLine(start=Point2(x=96.2, y=58.8), end=Point2(x=193.8, y=58.8)), FieldLine(start=Point2(x=193.8, y=58.8), end=Point2(x=193.8, y=11.2)), FieldLine(start=Point2(x=96.2, y=428.8), end=Point2(x=96.2, y=381.2)), FieldLine(start=Point2(x=96.2, y=381.2), end=Point2(x=193.8, y=381.2)), FieldLine(start=Point2(x=193.8, y=381.2), end=Point2(x=193.8, y=428.8))], landmarks=[Landmark(kind=0, position=Point2(x=145.0, y=440.0)), Landmark(kind=1, position=Point2(x=145.0, y=0.0)), Landmark(kind=2, position=Point2(x=-5.0, y=445.0)), Landmark(kind=3, position=Point2(x=295.0, y=445.0)), Landmark(kind=4, position=Point2(x=-5.0, y=-5.0)), Landmark(kind=5, position=Point2(x=295.0, y=-5.0))]),
}
