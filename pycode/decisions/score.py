# SPDX-License-Identifier: Apache-2.0
# What the score changes (thesis 2006 section 5.2): a goalie goes forward when its team is behind by
# more than three goals. A switch, world.task.score_aware, since an empty goal costs more than one
# attacker gains in any closer match. Keeps nothing.
import kelpie

BEHIND = 3   # goals


def goes_forward(world) -> bool:
    """Whether a goalie plays as a forward does."""
    game, task = world.game, world.task
    return (task.score_aware and task.player in (kelpie.GOALIE, kelpie.GOALIE_2004) and
            game.opponent_score - game.own_score > BEHIND)
