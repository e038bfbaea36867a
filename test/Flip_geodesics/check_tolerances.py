#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Finds literal tolerances in headers other than the one in which all of them are named and derived.

    check_tolerances.py SOURCE_DIR

A literal tolerance is a floating-point number with an exponent, such as 1e-9 or 0x1p-53, a power of two written as
ldexp(1, -20), a decimal number below 0.01, or the epsilon of double. Comments and strings do not count. Each constant
of tolerances.h has a comment and is used.
"""

import re
import sys
from pathlib import Path

TOLERANCES = 'internal/numbers/tolerances.h'
EXEMPT = ()

TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)
LITERAL = re.compile(r'(?<![\w.])(?:0[xX][\da-fA-F.]+[pP][-+]?\d+|(?:\d+\.?\d*|\.\d+)[eE][-+]?\d+|0?\.00\d*[1-9]\d*)|'
                     r'\bldexp\(\s*1(?:\.0*)?\s*,\s*-\s*\d+\s*\)|numeric_limits<double>::epsilon\(\)')


def without_comments(text):
    """The code, with lines where they were."""
    return TOKEN.sub(lambda found: re.sub(r'[^\n]', ' ', found.group()), text)


def literals(text):
    code = without_comments(text)
    return [(code.count('\n', 0, found.start()) + 1, found.group()) for found in LITERAL.finditer(code)]


def wrong_constants(text, others):
    """The constants that nothing uses, and those that neither a comment before them nor one behind them describes."""
    names = set()
    for line in without_comments(text).split(';'):
        if 'constexpr' in line:
            names.update(re.findall(r'(\w+) (?:= |\()', line))
    used = set(re.findall(r'\w+', without_comments(others)))
    own = without_comments(text)
    for name in sorted(names):
        if name not in used and len(re.findall(rf'\b{name}\b', own)) < 2:
            yield f'{TOLERANCES}: nothing uses {name}'
    for block in re.split(r'\n\s*\n', text):
        if re.search(r'^(?:inline )?constexpr', block, re.MULTILINE) and '/*' not in block:
            for line in block.split('\n'):
                if 'constexpr' in line and '//' not in line:
                    yield f'{TOLERANCES}: no comment describes {line.strip()}'


def main(source):
    folder = source / 'include/CGAL/Flip_geodesics'
    headers = sorted(folder.rglob('*.h'))
    wrong, others = [], ''
    for header in headers:
        name = header.relative_to(folder).as_posix()
        if name == TOLERANCES:
            continue
        text = header.read_text()
        others += text
        if not name.startswith(EXEMPT):
            wrong += [f'{name}:{line}: {literal} is a literal tolerance: name and derive it in {TOLERANCES}'
                      for line, literal in literals(text)]
    wrong += wrong_constants((folder / TOLERANCES).read_text(), others)
    print('\n'.join(wrong) or f'{len(headers)} headers have no literal tolerances')
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main(Path(sys.argv[1])))
