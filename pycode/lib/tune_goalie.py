# SPDX-License-Identifier: Apache-2.0
# The numbers of the two goalies that one would tune, by who uses them. In cm, degrees and seconds,
# speeds in cm/s and deg/s. Tuned in the simulator, where no source is given.


class Body:
    """What the goalie asks of its legs."""
    SPEED = 34.0             # the walk does 36 to 38 cm/s and 214 deg/s (docs/body.md)
    TURN = 180.0
    MARGIN = 10.0            # of the box; the pose is off by 2.6 cm (docs/body.md), and others push
    SECONDS = 0.35           # to an edge of the box at least: the legs follow late


class Guard:
    GAIN = 2.5               # cm/s per cm
    TURN_GAIN = 3.0          # deg/s per deg
    LAZY, ACCURATE = 8.0, 3.0          # cm; of the goalie of 2006, after facts-2005 7.2 and K10
    LAZY_TURN, ACCURATE_TURN = 14.0, 5.0
    FRESH = 0.4              # s; for a ball unseen for longer the goalie stands still,
    SEARCH_TURN = 110.0      # deg/s to the side where a near ball was lost, up to so many deg
    MOST_TURNED = 105.0      # from up-field (who faces wrong is turned back), and slower
    KICKED_TURN = 70.0       # after a kick: a ball at the flank then rolls 20 cm and no farther,
    CHIN, BACK_OFF = 16.0, -15.0  # or back from one that was so near, at that speed,
    UNSEEN = 1.6             # then goes to the middle, unless it still looks close by,
    LOST = 6.0               # then to the line: the head sees 26 deg past the sides
    PRESSED = 22.0           # cm ahead; with a ball there that an opponent is at it stands still
    CROWDED = 50.0           # cm to an opponent: the ball is between the two, and who turns or
    CROWDED_SEEN = 1.0       # walks sweeps it in; s since that was seen
    TOLD_SD = 5.0            # cm; of vaguer balls of the team one in ten is more than 25 cm off


class Paws:
    """A ball between the paws: the rules let it lie there for 3 s."""
    ASIDE, AHEAD = 6.0, 13.0  # cm; 4 and 11 by the rules
    TOO_NEAR, TOO_FAR = 12.5, 17.0  # cm of the chest's infrared, which reads the carpet between,
    NOTHING = 60.0           # and so far when there is nothing at all
    SEEN = 3.0               # s that a belief counts
    GAP = 0.25
    LONGEST = 1.2            # s; then it steps back


class GuardEllipse:
    LAZY, ACCURATE = 15.0, 7.0         # checklist U14
    LAZY_TURN, ACCURATE_TURN = 20.0, 8.0
    UNSEEN = 4.0             # s that an unseen ball is believed; then to the middle


class Block:
    """Facts-2005 section 7.2, in cm/s and s; what differs says why."""
    SPEED = 35.0             # 12 in 2005; a slower ball is walked to, it leaves the time
    SOONEST = 0.1            # 3 frames; later than that no block is in time
    LATEST = 0.8             # 27 frames; before it, walk
    CENTRE = 9.0             # aside, to which the wide block is right
    REACH = 36.0             # 30 in 2005; block_left covers 32 (docs/body.md) and a ball's radius
    STAND_SPEED = 160.0      # up to there a ball is stopped standing, if that is enough: on its
    STAND = 5.0              # feet the goalie clears before the attacker comes, but a block takes
    STEP, STEP_LATE = 20.0, 0.25  # 1.7 s. cm/s of a step aside, and s until it begins. Of 96 balls
                             # 3 went in, 7 when every one was blocked
    BESIDE = 6.0             # beside the mouth: the velocity is off by some degrees
    SHORT = 10.0             # a ball that would stop that short of the line may still go in
    SEEN = 0.12              # a ball unseen for longer is not judged
    FRAMES = 2               # in a row that say so
    FASTEST = 240.0          # cm/s; kicks go 2.2 m, which takes 190. What is faster was lost and
    MOVED = 0.4              # of the way that the velocity says, in each of those frames
    SEEN_FRAMES = 4          # found elsewhere: a ball is judged when seen that often in a row


class Coming:
    SPEED = 10.0
    BESIDE = 15.0
    SHORT = 25.0
    LATEST = 4.0             # s; a ball that takes longer is guarded against as one that lies
    LAZY, ACCURATE = 2.0, 1.0          # no laziness now
    LAZY_TURN, ACCURATE_TURN = 30.0, 20.0  # and no turn where a step aside will do


class Attack:
    NEAR = 8.0               # cm beyond the box; the neck stays in, the legs reach farther
    LEAVE = 15.0             # cm beyond the box; thesis 2004 section 4.2.2
    SPEED = 30.0             # a faster ball is not run after
    UNSEEN = 1.0             # s; the chin hides a near ball
    TIME = 8.0
    REST = 2.0               # s without another attack after one that took longer
    GAIN = 3.0
    WALK = 34.0
    TURN_GAIN = 3.0
    TURN = 150.0
    AGAIN = 0.5              # s after which the place to kick from is chosen anew
    MOVED = 6.0              # cm that the ball rolls before that
    STAND_OFF = 4.0          # cm more from the ball until side and heading fit
    SIDE_FIRST = 4.0         # cm
    TURN_FIRST = 25.0        # deg
    LANDMARKS = 75.0         # deg from up-field: three kicks at a ball in the corner, with no
                             # landmark in view, left a heading 30 deg wrong and the box far behind
    FACING = 55.0            # deg from the way out of the goal past the ball, at most


class Clear:
    OFF_GOAL, SDS = 25.0, 3.0  # deg, and sd of a kick's direction, from the own goal's cone
    SEEN = 0.2               # s; of kicks at balls unseen for longer hardly one hit
    STANDS = 0.35            # s after a motion: the ball seen by a robot that lies or gets up is up
                             # to 8 cm off, and the kick misses
    NEAR = 25.0              # cm; no kick reaches farther
    WALKS = 3.0              # cm/s: a slower robot stands
    AT_BALL = 30.0           # cm from the ball to an opponent's neck. Of 38 kicks with one in 25
                             # half left the ball within 20 cm for 0.4 s, of 53 alone a quarter
    HAS = 45.0               # cm from there to one that has it, or has it before it is kicked: in
                             # 87 % of 314 frames with one within 33 cm somebody is believed so
                             # near (within 18 cm in 32 %), in 7 % of 153 with all beyond 45 cm
    HAS_SEEN, HAS_STILL = 1.0, 0.4  # s since it was seen, and for which it has the ball on; in all
    HAS_LONGEST = 4.0        # s that the ball is left to it; the rules let it hold the ball for 3
    FEET, FEET_LEAST = 24.0, 2  # cm from the ball to feet in the image, points of them at least:
                             # there in 60 % of 252 frames with an opponent within 25 cm, in none
                             # of 228 with all beyond 33 cm
    FEET_MATE = 45.0         # cm from the ball to a mate that they may be of
    MATE = 30.0              # cm from the ball to a mate's neck that grabs it: both own goals of 20
                             # matches were kicks of goalies against their own attacker's hold
    BESIDE, FARTHEST = 2.0, 16.0  # cm about a kick's window, and ahead
    LATENCY = 0.05, 0.2      # s from asking to the motion's beginning, at least and at most
    STRIKE = 0.2             # s from there to the strike: a kick's last key frame ends after 0.18
                             # to 0.24
    WORTH = 0.45             # of a kick that is done as the ball lies
    LOOK = 80.0              # cm after which the head looks for the ball
    FAR = 180.0              # cm that are as good as farther
    ASIDE = 0.35             # worth lost by a kick across the field
    ACROSS = 0.85            # share left of one that goes past the goal's middle
    OPPONENT, OPPONENT_DEG = 70.0, 25.0
    HELD = 0.3               # share left of a kick at an opponent: it comes back, or gets 10 cm
    HELD_DEG = 106.0         # where a kick to a side then goes (docs/body.md)


class Facing:
    WRONG = 120.0            # deg from up-field
    RIGHT = 50.0
    OWN_GOAL = 35.0          # deg; the own goal seen that near to straight ahead ...
    OWN_FRAMES = 5           # ... so often says that the pose is wrong
    AGAINST_POSE = 270.0     # deg of a turn while the pose says that all is well
    NOTHING = 8.0            # s without a landmark; a scrum in which none was seen for 15 s pushed
                             # the goalie round, and a pose sure to 7 cm was 200 cm off
    NOTHING_CROWDED = 16.0   # s, with an opponent at hand: of 13 turns after 8 s none was of a
                             # pose that was wrong, and one took the ball at its feet in
    OFF_BOX = 50.0           # cm
    OFF_TIME = 2.0           # s; jumps of the pose that end by themselves are shorter
    PAN, DOWN = 20.0, 6.0    # deg of the view while turning
    TURN = 120.0             # deg/s
    TIME = 5.0               # s of turning, and then of not turning


class Look:
    """Glances at landmarks; facts-2005 section 7.2: every 50 to 95 frames, for 9."""
    EVERY_LOST, EVERY_SURE = 1.7, 3.2
    SURE_SD, SURE_HEADING_SD = 6.0, 4.0
    TIME = 0.3
    SURVEY, SURVEY_TIME, SURVEY_DOWN = (75.0, 25.0, -25.0, -75.0), 0.26, 6.0  # pan, s, deg down
    AGAIN = 2.0              # s between two surveys of a lost pose
    STEADY = 0.7             # s of tracking before a glance
    FAR = 60.0               # cm to the ball; nearer it is not left alone,
    FAR_SURE = 120.0         # nor here while the pose is sure: from 100 cm the attacker shoots
    FAR_ELLIPSE = 25.0       # thesis 2004 section 4.2.3
    STILL = 15.0             # cm/s of the ball towards the goal
    FRONT = 45.0             # deg of pan in every second glance; the near beacons are at 60
    RETURN = 0.25            # s at the angle of before, then at where gps has the ball
    BELIEVED = 0.4
    LOST = 0.25              # s unseen while it is looked at
    TOLD, TOLD_EVERY = 0.5, 2.0  # s of looking to where mates see it, out of so many


class PointScan:
    BEACON = 0.22            # s; the head pans 33 deg in 0.1 s, then three images
    LOW = 0.26               # 44 deg
    NEAR_TIMES = 0.24, 0.5, 0.9, 1.65, 3.15  # s, ends of the looks; in the last two the body turns
    DOWN = 12.0              # deg below the horizontal at the beacons: a ball from 30 cm on shows
    LOW_AT = 28.0            # cm; a ball from 12 to 130 cm shows
    NEAR = 60.0              # cm; a ball lost nearer is first looked for low


class Pan:
    """The full search of 2004: from left to right at the horizon's height, then quickly at the
    feet."""
    SIDE = 88.0
    SPEED = 120.0            # deg/s
    QUICK = 250.0
    DOWN, FEET = 18.0, 48.0  # deg below the horizontal; 22 is half an image


class Paw:
    SIDE = 5.0               # cm from the middle to a front leg
    SPEED = 34.0
    TURN_GAIN = 3.0
    TURN = 120.0
    VISUAL = 15.0            # cm; a seen ball that near starts the attack
    ASIDE = 40.0             # deg; one seen farther aside ends it
