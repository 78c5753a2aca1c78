# SPDX-License-Identifier: Apache-2.0
# The behaviours import each other from pycode/, and `kelpie` from its stand-in, which the build
# writes from the field lists.
import os
import pathlib
import sys

import pytest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
STAND_IN = pathlib.Path(os.environ.get('KELPIE_BUILD', ROOT / 'build/host')) / 'generated/python'
sys.dont_write_bytecode = True
PYCODE = os.environ.get('KELPIE_PYCODE', str(ROOT / 'pycode'))     # tools/mutate has its own
sys.path[:0] = [PYCODE, str(HERE), str(STAND_IN)]

if not (STAND_IN / 'kelpie.py').is_file():
    pytest.exit(f'{STAND_IN}/kelpie.py is not there: tools/build host behaviour_stand_in makes it',
                returncode=2)
