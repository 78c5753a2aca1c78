# SPDX-License-Identifier: Apache-2.0
# The behaviours import each other from pycode/ and `kelpie` from the stand-in beside this file.
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path[:0] = [str(HERE.parent.parent / 'pycode'), str(HERE)]
