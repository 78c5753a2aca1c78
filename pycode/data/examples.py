# SPDX-License-Identifier: Apache-2.0
# Examples of where the two who do not attack stand (thesis 2006 section 4.5.3 and figure 4.7), for
# decisions/positions_regression.py. Data to be edited: each row says, for a ball in the left half
# of a field of 360 x 540 cm, where the defender and the last robot (striker or supporter) stand and
# look. The other half is mirrored by the code. In cm and degrees on the field, 90 is up-field.
# `angle`: direction from the attacker to the ball, degrees left of up-field; beyond 90 the attacker
# chases the ball towards its own goal. `attacks`: 1 while the own team has the ball or is nearer to
# it, 0 when it defends. The first four are figure 4.7.

#    ball x, y, angle, attacks:  defender x, y, heading;  last x, y, heading
EXAMPLES = (
    ((180, 400, 0, 1), (180, 250, 90, 180, 320, 90)),    # both behind the attacker
    ((60, 460, 0, 1), (130, 290, 112, 200, 415, 162)),   # defender more forward, other at the box
    ((120, 200, 170, 0), (165, 100, 114, 170, 260, -130)),  # chased home: first line of defence
    ((60, 90, 0, 0), (140, 100, 173, 260, 350, -128)),   # ball deep: the other waits high

    ((180, 270, 0, 1), (180, 150, 90, 180, 190, 90)),
    ((180, 270, 0, 0), (180, 140, 90, 180, 200, 90)),
    ((100, 270, 0, 1), (155, 150, 115, 235, 240, 167)),
    ((30, 270, 0, 1), (130, 150, 130, 215, 290, -174)),
    ((30, 270, 0, 0), (125, 130, 124, 180, 230, 165)),
    ((100, 270, 180, 0), (150, 120, 108, 140, 210, 124)),
    ((180, 500, 0, 1), (180, 340, 90, 180, 420, 90)),
    ((30, 520, 0, 1), (110, 340, 111, 190, 430, 151)),
    ((120, 460, 0, 1), (155, 300, 104, 205, 405, 147)),
    ((30, 400, 0, 1), (100, 270, 118, 250, 380, 175)),
    ((100, 340, 0, 1), (150, 210, 111, 270, 350, -177)),
    ((180, 340, 0, 1), (180, 210, 90, 180, 260, 90)),
    ((180, 340, 180, 0), (180, 180, 90, 180, 250, 90)),
    ((100, 400, 180, 0), (150, 220, 106, 180, 290, 126)),
    ((180, 200, 0, 1), (180, 90, 90, 180, 340, -90)),
    ((180, 200, 0, 0), (180, 90, 90, 180, 300, -90)),
    ((100, 150, 0, 1), (150, 90, 130, 270, 340, -132)),
    ((30, 150, 0, 0), (130, 90, 149, 240, 320, -141)),
    ((30, 200, 170, 0), (125, 95, 132, 160, 250, -159)),
    ((30, 40, 0, 0), (110, 90, 148, 240, 340, -125)),
)
