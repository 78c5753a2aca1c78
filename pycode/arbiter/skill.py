# SPDX-License-Identifier: Apache-2.0
# What every skill, role and player has in common, so that whoever plays it needs to know no more:
# making one is its start; step() is its answer for a frame; done and committed say how it stands;
# end() tells it that somebody else goes on. Its folder says what the answer is: a WalkRequest of
# skills/walk, a HeadRequest of skills/head, a motion's number of skills/motion, a whole Command of
# all others and of the skills of walk that need the head for their way.
import kelpie


class Skill:
    """Asked for one step per camera frame while it is played, and for none when it is not."""

    LAYER = kelpie.LAYER_SKILL
    NAME = ''           # whose decision a trace tells; a subclass names it as its file is named
    done = False        # it has come to its end: another step would do nothing new
    committed = False   # nobody should take the robot from it in this frame
    # What it says of the ball in this frame, for its player to remember:
    approached = False  # it walks up to the ball for a grab,
    grabbed = False     # grabs or holds it,
    hint = None         # (cm, deg): where the ball will come out (thesis 2006 table 6.1)

    def step(self, world, asked=None):
        """The answer for this frame. `asked`: what its player wants of it now, such as a place."""
        raise NotImplementedError

    def end(self) -> None:
        """Somebody else goes on; the next step is a new beginning."""

    def explain(self, trace) -> None:
        """Appends what it does and why to a list for Command.trace."""
