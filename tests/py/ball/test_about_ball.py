# SPDX-License-Identifier: Apache-2.0
# Who is round the ball: opponents by their uniform, and by their feet in the last images.
import kelpie
import pytest
from lib.geom import from_field, to_field
from situation.about_ball import BODY, FOOT, IMAGES, REACH, opponents
from situation.memory import FEET_KEPT, FEET_TO, Memory
from situations import opponent, world

BALL = 180.0, 260.0
HERE = 185.0, 325.0


def show(made, memory, *feet, images=IMAGES):
    """The memory after so many images with feet at those places of the field."""
    made.percepts.obstacles = [
        kelpie.ObstaclePoint(position=kelpie.Point2(x=x, y=y))
        for x, y in (from_field(made.pose, *foot) for foot in feet)]
    made.task.run = True
    for _ in range(images):
        memory.update(made)
    return memory


def there(*feet, images=IMAGES, made=None):
    made = world(ball=BALL) if made is None else made
    return opponents(made, show(made, Memory(), *feet, images=images))


def mate(x, y):
    one = kelpie.TeammateEstimate()
    one.pose.position.x, one.pose.position.y = x, y
    return one


def test_a_point_goes_to_the_field_and_back():
    made = world(x=120.0, y=80.0, heading=33.0)
    assert from_field(made.pose, *to_field(made.pose, 7.0, 40.0)) == pytest.approx((7.0, 40.0))


def test_somebody_whose_feet_alone_are_seen_is_there():
    assert there(HERE) == [pytest.approx(HERE)]


def test_feet_that_fewer_images_show_are_nobody():
    assert there(HERE, images=IMAGES - 1) == []


def test_feet_of_one_body_are_one_and_of_two_are_two():
    assert len(there(HERE, (HERE[0] + FOOT - 2.0, HERE[1]))) == 1
    assert len(there(HERE, (HERE[0] + BODY + 5.0, HERE[1]))) == 2


def test_feet_seen_a_second_ago_are_forgotten():
    made, memory = world(ball=BALL), Memory()
    show(made, memory, HERE)
    show(made, memory, images=FEET_KEPT)
    assert memory.feet == [] and opponents(made, memory) == []


def test_feet_of_one_whose_uniform_is_seen_are_his():
    made = world(ball=BALL)
    made.opponents = [opponent(190.0, 310.0)]
    assert there(HERE, made=made) == [(190.0, 310.0)]


def test_one_whose_uniform_was_seen_long_ago_is_not_there():
    made = world(ball=BALL)
    made.opponents = [opponent(190.0, 310.0, seen_s=3.0)]
    assert there(made=made) == []


@pytest.mark.parametrize('x, y', [HERE, (205.0, 300.0)])
def test_feet_of_a_mate_are_not_an_opponent(x, y):
    made = world(ball=BALL)
    made.teammates = [mate(190.0, 320.0)]
    assert there((x, y), made=made) == []


def test_feet_far_from_the_ball_and_posts_are_nobody():
    far = world(y=380.0, ball=(180.0, 260.0))
    assert there((185.0, 260.0 + REACH + 10.0), made=far) == []
    near_goal = world(y=420.0, ball=(180.0, 480.0))
    assert there((140.0, near_goal.field.length - 2.0), made=near_goal) == []


def test_own_feet_and_what_is_far_away_are_not_kept():
    memory = show(world(), Memory(), (180.0, 210.0), (180.0, 200.0 + FEET_TO + 5.0))
    assert memory.feet == []
