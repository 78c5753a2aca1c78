# SPDX-License-Identifier: Apache-2.0
# Worlds and the Commands that the PC's Python makes of them, for `play`: the same guard and
# behaviours as in the image, in tests/py's random worlds, each after the Command before. Worlds
# travel as compiled expressions, numbers with all their bits. `SHOW` runs on both sides.
import marshal
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
SHOW = """
def show(value):
    names = getattr(type(value), '__slots__', None)
    if names is not None:
        return 'kelpie.%s(%s)' % (type(value).__name__, ', '.join(
            '%s=%s' % (name, show(getattr(value, name))) for name in names))
    if isinstance(value, (list, tuple)):
        inside = ', '.join(map(show, value)) + (',' if value else '')
        return '[' + inside + ']' if isinstance(value, list) else '(' + inside + ')'
    if isinstance(value, float) and value - value != 0.0:
        return "float('%r')" % value
    return repr(value)
"""


def decide_of_pc():
    sys.dont_write_bytecode = True
    sys.path[:0] = [str(ROOT / "tests/py"), str(ROOT / "behaviour/interpreter"),
                    str(ROOT / "build/host/generated/python")]
    import guard
    import kelpie
    return guard.Version(guard.Folder(str(ROOT / "pycode")), kelpie).decide


def main():
    """Writes, for each of that many worlds of that seed, a marshalled (world, Command shown)."""
    frames, seed = int(sys.argv[1]), int(sys.argv[2])
    decide, names = decide_of_pc(), {}
    exec(SHOW, names)
    from random_world import RandomWorld
    import kelpie
    random_world, command, made = RandomWorld(seed), kelpie.Command(), []
    for _ in range(frames):
        world = random_world.next(command)
        made.append((marshal.dumps(compile(names["show"](world), "world", "eval")), None))
        command = decide(world)
        made[-1] = (made[-1][0], names["show"](command))
    sys.stdout.buffer.write(marshal.dumps(made))


if __name__ == "__main__":
    main()
