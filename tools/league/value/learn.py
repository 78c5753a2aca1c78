#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""learn.py ROWS... --out MODEL   learns the value of play from rows of `kelpie value --rows`.

A logistic regression over curves: each feature goes straight between a few places, and the sum of
all curves is the logarithm of the odds that the team scores within the horizon. How far curves are
held flat (C) is chosen by matches that were left out, and so are the figures that are printed: no
match is judged by a model that has seen it. Needs python3-sklearn: tools/install value."""

import argparse
import csv
import json
import subprocess
import sys
from pathlib import Path

import numpy as np

# Where a feature's curve bends: close where goals are decided.
PLACES = {
    'restGoal': (0, 10, 40, 80, 140, 220, 320, 450),
    'goal': (0, 15, 40, 80, 140, 220, 320, 450),
    'towards': (-100, -20, 0, 20, 60, 150),
    'mouth': (5, 15, 30, 60, 120),
    'opening': (0, 5, 12, 25, 50, 100),
    'entering': (0, 10, 40, 120),
    'free': (0, 10, 40, 120),
    'ownReach': (5, 12, 25, 50, 100, 200),
    'otherReach': (5, 12, 25, 50, 100, 200),
    'lead': (-120, -40, -10, 10, 40, 120),
    'ownBehind': (0, 30, 70, 120, 180),
    'ownAim': (0, 30, 70, 120, 180),
    'otherBehind': (0, 30, 70, 120, 180),
    'guards': (0, 1, 2, 4),
    'ownHold': (0, 1),
    'otherHold': (0, 1),
}   # own and other are left out: too few robots were off the field to tell what that is worth
HORIZON = 10.0                       # s
FLATNESS = (0.003, 0.01, 0.03, 0.1)  # C of the regression
FOLDS = 5
BINS = 10


class Trouble(Exception):
    """Why nothing can be learnt, in one line."""


def read_rows(paths):
    """(matches as words, {column: numbers})"""
    matches, rows = [], []
    for path in paths:
        try:
            with open(path, newline='', encoding='utf-8') as file:
                table = csv.DictReader(file)
                for row in table:
                    matches.append(row.pop('match'))
                    row.pop('team')
                    rows.append([float(cell) for cell in row.values()])
                names = [name for name in table.fieldnames or [] if name not in ('match', 'team')]
        except (OSError, UnicodeDecodeError, ValueError, KeyError, TypeError) as error:
            raise Trouble(f'{path}: no rows of moments ({error})') from None
    if not rows:
        raise Trouble('there is no row to learn from')
    columns = dict(zip(names, np.array(rows).T))
    missing = [name for name in ('left', 'ends', *PLACES) if name not in columns]
    if missing:
        raise Trouble(f'the rows have no column {missing[0]}')
    return np.array(matches), columns


def scored(columns, horizon):
    """(whether the team scored within the horizon, rows of which that is known)"""
    soon = columns['left'] <= horizon
    return (soon & (columns['ends'] > 0)).astype(int), ~(soon & (columns['ends'] == 0))


def steps(places, x):
    """How far a value has gone from each place to the next: 0 to 1. Weights of these are what a
    curve rises from place to place, so that a model that is held small is one of flat curves."""
    return np.stack([np.clip((x - low) / (high - low), 0.0, 1.0)
                     for low, high in zip(places, places[1:])], axis=1)


def design(columns):
    return np.concatenate([steps(places, columns[name]) for name, places in PLACES.items()], axis=1)


def fitted(inputs, hit, flatness):
    from sklearn.linear_model import LogisticRegression
    return LogisticRegression(C=flatness, solver='newton-cholesky').fit(inputs, hit)


def log_loss(p, hit):
    p = np.clip(p, 1e-9, 1 - 1e-9)
    return float(-np.mean(np.where(hit == 1, np.log(p), np.log(1 - p))))


def folds_of(matches):
    """A number of a fold for each row: all rows of a match are in one."""
    words = {word: i % FOLDS for i, word in enumerate(sorted(set(matches)))}
    return np.array([words[word] for word in matches])


def unseen(inputs, hit, folds, flatness):
    """What models say of the matches that each was not learnt from."""
    p = np.zeros(len(hit))
    for fold in range(FOLDS):
        rest = folds != fold
        if rest.all():
            continue
        p[~rest] = fitted(inputs[rest], hit[rest], flatness).predict_proba(inputs[~rest])[:, 1]
    return p


def calibration(p, hit):
    """[(mean of p, share of hits, rows)] of bins with as many rows each, and their mean gap."""
    order = np.array_split(np.argsort(p, kind='stable'), BINS)
    bins = [(float(p[i].mean()), float(hit[i].mean()), len(i)) for i in order if len(i)]
    gap = sum(abs(said - was) * rows for said, was, rows in bins) / len(p)
    return bins, float(gap)


def curves_of(model):
    """The regression's weights as curves, from each feature's first place on."""
    weights = list(model.coef_[0])
    curves = []
    for name, places in PLACES.items():
        rises = [weights.pop(0) for _ in places[1:]]
        curves.append({'feature': name, 'at': list(places),
                       'adds': [0.0] + [round(float(height), 4) for height in np.cumsum(rises)]})
    return curves


def chosen(inputs, hit, matches):
    """(flatness, what models that have not seen the match say of each row)"""
    folds = folds_of(matches)
    tries = [(flatness, unseen(inputs, hit, folds, flatness)) for flatness in FLATNESS]
    return min(tries, key=lambda one: log_loss(one[1], hit))


def version():
    """The commit of the source tree, whose matches these are taken for."""
    try:
        done = subprocess.run(['git', '-C', str(Path(__file__).parent), 'rev-parse', '--short=8',
                               'HEAD'], capture_output=True, text=True, check=False)
        return done.stdout.strip() or 'unknown'
    except OSError:
        return 'unknown'


def learn(matches, columns, horizon=HORIZON):
    """(the model as JSON, its bins of calibration)"""
    hit, known = scored(columns, horizon)
    inputs, hit, matches = design(columns)[known], hit[known], matches[known]
    if len(set(matches)) < FOLDS or not 0 < hit.sum() < len(hit):
        raise Trouble(f'too little to learn from: {FOLDS} matches with goals at least')
    flatness, p = chosen(inputs, hit, matches)
    base = log_loss(np.full(len(hit), hit.mean()), hit)
    bins, gap = calibration(p, hit)
    model = fitted(inputs, hit, flatness)
    learnt = {'commit': version(), 'matches': len(set(matches)), 'rows': len(hit),
              'scored_share': float(hit.mean()),
              'flatness': flatness, 'log_loss': log_loss(p, hit), 'base_log_loss': base,
              'gain': 1.0 - log_loss(p, hit) / base, 'calibration_error': gap,
              'from': sorted(set(matches))}
    return {'kelpie_value': 1, 'horizon_s': horizon, 'base': round(float(model.intercept_[0]), 4),
            'curves': curves_of(model), 'learnt': learnt}, bins


def picture(bins):
    """Calibration as SVG: what was said against what was, on both axes from 0 to the largest."""
    top = max(max(said, was) for said, was, _ in bins) * 1.05 or 1.0
    place = [(40 + 340 * said / top, 360 - 340 * was / top) for said, was, _ in bins]
    dots = ''.join(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4"/>' for x, y in place)
    return f'''<svg xmlns="http://www.w3.org/2000/svg" width="400" height="400" font-size="11">
<rect width="400" height="400" fill="white"/>
<path d="M 40,20 V 360 H 380 M 40,360 L 380,20" fill="none" stroke="gray"/>
<g fill="steelblue">{dots}</g>
<text x="210" y="390" text-anchor="middle">said: 0 to {top:.3f}</text>
<text x="14" y="190" text-anchor="middle" transform="rotate(-90 14 190)">was</text>
</svg>
'''


def text_of(model):
    """A curve a line, so that a model can be read and compared."""
    curves = ',\n  '.join(json.dumps(curve) for curve in model['curves'])
    head = {key: model[key] for key in ('kelpie_value', 'horizon_s', 'base')}
    return (json.dumps(head)[:-1] + ',\n "curves": [\n  ' + curves + '],\n "learnt": '
            + json.dumps(model['learnt']) + '}\n')


def options_from(words):
    parser = argparse.ArgumentParser(prog='learn.py', description=__doc__.splitlines()[0])
    parser.add_argument('rows', nargs='+', help='CSV files')
    parser.add_argument('--out', required=True, help='the model to write')
    parser.add_argument('--plot', help='its calibration on matches that it has not seen, as SVG')
    parser.add_argument('--horizon', type=float, default=HORIZON, help='s (%(default)s)')
    options = parser.parse_args(words)
    if not 0.5 <= options.horizon <= 120.0:
        parser.error('--horizon is from 0.5 to 120 s')
    return options


def main(words):
    options = options_from(words)
    try:
        model, bins = learn(*read_rows(options.rows), options.horizon)
        Path(options.out).write_text(text_of(model), encoding='utf-8')
        if options.plot:
            Path(options.plot).write_text(picture(bins), encoding='utf-8')
    except (Trouble, OSError) as error:
        print(f'learn.py: {error}', file=sys.stderr)
        return 2
    except ImportError:
        print('learn.py: needs python3-sklearn: tools/install value', file=sys.stderr)
        return 2
    figures = {key: value for key, value in model['learnt'].items() if key != 'from'}
    print(json.dumps({**figures, 'bins': bins}, indent=1))
    return 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
