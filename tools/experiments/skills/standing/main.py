# SPDX-License-Identifier: Apache-2.0
# An opponent that stands where it was put: what is in the way of another one.
import kelpie


def decide(world) -> kelpie.Command:
    return kelpie.Command()
