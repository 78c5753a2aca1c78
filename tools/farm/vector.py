# SPDX-License-Identifier: Apache-2.0
"""The constants of the behaviours (behaviour/constants.toml) as a vector that is searched, and a
vector as a team's folder. A vector is {parameter's key: number}; what it leaves out is at its
default."""

import hashlib
import json
import sys
from pathlib import Path

from farm.variant import task_lines
from farm.work import ROOT, Trouble

sys.path.insert(0, str(ROOT / 'behaviour'))

from constants import Wrong, constants  # noqa: E402

SCHEMA = ROOT / 'behaviour/constants.toml'


def described(groups=''):
    """The constants of those groups, `grab,dribble`; of all when there is no word."""
    try:
        found = constants(SCHEMA)
    except Wrong as wrong:
        raise Trouble(wrong) from None
    wanted = [word for word in groups.split(',') if word]
    known = list(dict.fromkeys(one.group for one in found))
    for word in wanted:
        if word not in known:
            raise Trouble(f"--groups {word}: there are {', '.join(known)}")
    return [one for one in found if not wanted or one.group in wanted]


def defaults(found):
    return {one.key: one.default for one in found}


def kept(one, number):
    """The number as the parameter holds it, within its range."""
    number = min(max(number, one.low), one.high)
    return round(number) if one.counts else round(float(number), 4)


def name_of(vector):
    return hashlib.sha256(json.dumps(vector, sort_keys=True).encode()).hexdigest()[:10]


def team_text(found, vector, about):
    """A team.toml; `about` is its first comment."""
    lines = ['# SPDX-License-Identifier: Apache-2.0', f'# {about}', *task_lines()]
    changed = [one for one in found if vector.get(one.key, one.default) != one.default]
    for group in dict.fromkeys(one.group for one in changed):
        lines += ['', f'[behaviour.constants.{group}]']
        lines += [f'{one.name} = {one.value(vector[one.key])}   # {one.default:g}: {one.what}'
                  for one in changed if one.group == group]
    return '\n'.join(lines) + '\n'


def write_team(folder, found, vector, about):
    """The folder."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / 'team.toml').write_text(team_text(found, vector, about), encoding='utf-8')
    return folder
