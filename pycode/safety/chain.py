# SPDX-License-Identifier: Apache-2.0
# Filters of walks: what a state or a skill asks of the legs goes through them one after the other,
# each a pure function filter(now, walk) -> walk that takes away what would do harm. `now` is the
# situation of the frame, of which a filter reads what it names. Keeps nothing.


def filtered(now, walk, filters):
    """The WalkRequest that is left of a walk."""
    for one in filters:
        walk = one(now, walk)
    return walk
