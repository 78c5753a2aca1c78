# SPDX-License-Identifier: Apache-2.0
# The face's lights say what a forward plays: one pair for each role, so that who watches a match
# sees the roles change. Keeps nothing. The lights of the game's state are the body's own matter.
import kelpie

FACE = kelpie.LED_FACE
OF_ROLE = {kelpie.ATTACKER: FACE[0] | FACE[1], kelpie.SUPPORTER: FACE[2] | FACE[3],
           kelpie.STRIKER: FACE[4] | FACE[5], kelpie.DEFENDER: FACE[6] | FACE[7]}


def of_role(role) -> int:
    return OF_ROLE.get(role, 0)
