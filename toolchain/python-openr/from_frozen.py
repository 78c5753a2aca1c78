# SPDX-License-Identifier: Apache-2.0
# Where the guard's Version finds the behaviours on the robot: among the frozen modules, by their
# names behind `behaviours.`. A name that others stand under is an empty package. Nothing is
# compiled: the robot's Python has no compiler.
import _imp


def nothing():
    pass


class Frozen:
    def code(self, name):
        """(code, is a package) of a module, or None."""
        inside = 'behaviours.' + name
        if _imp.find_frozen(inside) is not None:
            return _imp.get_frozen_object(inside), False
        if any(known.startswith(inside + '.') for known in _imp._frozen_module_names()):
            return nothing.__code__, True
        return None
