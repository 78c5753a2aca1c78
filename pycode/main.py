# SPDX-License-Identifier: Apache-2.0
import kelpie


def decide(world):
    return kelpie.Command()
