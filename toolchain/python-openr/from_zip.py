# SPDX-License-Identifier: Apache-2.0
# Where the guard's Version finds the behaviours of a robot's memory stick: in the bytes of its zip,
# as toolchain/make-pyzip writes it, with .pyc files that are stored. Keeps the bytes, since a
# behaviour may import another at any time. Nothing is compiled or unpacked, for which the robot's
# Python has no modules; the stick's reader has checked every byte before.
import marshal
from _frozen_importlib_external import MAGIC_NUMBER

END, ENTRY, LOCAL = 22, 46, 30  # bytes of a zip's three kinds of records, without names
HEAD = 16                       # bytes of a .pyc before its code


def nothing():
    pass


def number(data, at, size=2):
    return int.from_bytes(data[at:at + size], 'little')


def places(data):
    """(path without .pyc, begin, end) of each entry, by the directory at the zip's end."""
    end = len(data) - END
    if end < 0 or data[end:end + 4] != b'PK\5\6':
        raise ImportError('this is no zip, or is cut off')
    at = number(data, end + 16, 4)
    for _ in range(number(data, end + 10)):
        if number(data, at + 10) != 0:
            raise ImportError('what the zip holds is packed')
        length, local = number(data, at + 28), number(data, at + 42, 4)
        name = data[at + ENTRY:at + ENTRY + length].decode()
        begin = local + LOCAL + number(data, local + 26) + number(data, local + 28)
        yield name.removesuffix('.pyc'), begin, begin + number(data, at + 20, 4)
        at += ENTRY + length + number(data, at + 30) + number(data, at + 32)


class Zip:
    def __init__(self, data):
        self.data = memoryview(data)
        self.places = {name: (begin, end) for name, begin, end in places(data)}

    def code(self, name):
        """(code, is a package) of a module, or None."""
        stem = name.replace('.', '/')
        for file, package in ((stem, False), (stem + '/__init__', True)):
            if file in self.places:
                return self.read(file), package
        if any(known.startswith(stem + '/') for known in self.places):
            return nothing.__code__, True
        return None

    def read(self, file):
        begin, end = self.places[file]
        if self.data[begin:begin + len(MAGIC_NUMBER)] != MAGIC_NUMBER:
            raise ImportError(file + '.pyc is of another Python')
        return marshal.loads(self.data[begin + HEAD:end])
