# SPDX-License-Identifier: Apache-2.0
# Where each player stands at a kick-off (facts-2005 section 7.2, ready positions): plain data by
# player number, in the own half and out of the centre circle. Keeps nothing. Numbers 2 to 4 are the
# forwards beside goalie 1; a forward with number 1 plays without a goalie and takes the place that
# is left. Alone, it is the one who kicks off.
KICKER_BEHIND = 45.0   # cm behind the ball: paws reach 18, the circle 18
WIDE = 0.28            # of the width, from the middle
GOALIE_Y = 20.0  # cm

# Player: shares of the width from the middle and of the length; None: who kicks off.
KICKING = {2: (0.0, None), 3: (-0.19, 0.2), 4: (0.29, 0.43), 1: (0.17, 0.25)}
RECEIVING = {2: (-WIDE, 0.43), 3: (0.0, 0.21), 4: (WIDE, 0.43), 1: (0.0, 0.34)}


def forward(field, player, kicks_off, alone):
    """The place of a forward on the field; it looks up-field."""
    if alone and player == 1:
        player = 2
    x, share = (KICKING if kicks_off else RECEIVING).get(player, RECEIVING[1])
    y = 0.5 * field.length - KICKER_BEHIND if share is None else share * field.length
    return (0.5 + x) * field.width, y


def goalie(field):
    return 0.5 * field.width, GOALIE_Y
