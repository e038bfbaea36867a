#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Reads the table of modules in the manual and the headers, and compares them.

    check_modules.py SOURCE_DIR

Each header is in one module: a public one in the row that names it, an internal one in the row of its folder. It
includes headers of its own module, and of those below it: of the modules that the row names, and of those below these.
A row names rows above it only. No header includes itself over others. The classes of a header have no friends but
functions that they define themselves, and classes of the same header. Flip_geodesics.h includes each public header but
those that its comment names.
"""

import collections
import re
import sys
from pathlib import Path

ROW = re.compile(r'^\| (\w+) \| ([\w, ]+) \| (.*) \| .* \|$')
INCLUDE = re.compile(r'^ *# *include +<CGAL/Flip_geodesics/([^>]+)>', re.MULTILINE)
COMMENT = re.compile(r'//[^\n]*|/\*.*?\*/', re.DOTALL)
FRIEND = re.compile(r'\bfriend\s+([^;{]*?)\s*([;{])')
FRIEND_NAME = re.compile(r'([\w:]+)(?:<[^;]*>)?$')


def modules_of_table(manual):
    """What is below each module of the table, and the module of each public header; what is wrong with the table."""
    lines = manual.read_text().split('\n')
    start = next((i for i, line in enumerate(lines) if line.startswith('| Module |')), len(lines))
    below, module_of, wrong = {}, {}, []
    for line in lines[start + 2:]:
        row = ROW.match(line)
        if not row:
            break
        module, used, headers = row.group(1), row.group(2).split(', '), re.findall(r'`([\w/]+\.h)`', row.group(3))
        used = [] if used == ['none'] else used
        wrong += [f'{module} is above {other} in the table, and uses it' for other in used if other not in below]
        below[module] = set(used).union(*(below.get(other, ()) for other in used))
        wrong += [f'{h} is in {module_of[h]} and in {module}' for h in headers if h in module_of]
        module_of.update((h, module) for h in headers)
    return below, module_of, wrong if below else ['the manual has no table of modules']


def module_of_header(name, module_of):
    parts = name.split('/')
    return parts[1] if parts[0] == 'internal' and len(parts) > 2 else module_of.get(name)


def find_circles(includes):
    """Headers that include themselves over others."""
    below = collections.defaultdict(set)

    def reach(name, trail):
        if name in trail:
            return [' -> '.join(trail[trail.index(name):] + [name])]
        if name in below:
            return []
        below[name].update(includes.get(name, ()))
        return [c for other in includes.get(name, ()) for c in reach(other, trail + [name])]

    return [c for name in includes for c in reach(name, [])]


def wrong_friends(text):
    """What the classes of a header befriend and may not. Boost's iterators ask for one friend."""
    code = COMMENT.sub('', text)
    declared = [what for what, end in FRIEND.findall(code) if end == ';']
    names = [name.group(1) if name else what for what in declared for name in [FRIEND_NAME.search(what)]]
    names = [re.sub('^internal::', '', name) for name in names]
    return [name for name in names if name != 'boost::iterator_core_access' and
            not re.search(rf'\b(?:class|struct)\s+{re.escape(name)}\b[^;{{]*{{', code)]


def reached(names, includes):
    """The headers that these include, over others or by themselves, and these."""
    found, open_ones = set(), list(names)
    while open_ones:
        name = open_ones.pop()
        if name not in found:
            found.add(name)
            open_ones += includes.get(name, ())
    return found


def wrong_in_umbrella(text, includes, module_of):
    """Public headers that the header of the whole package leaves out unsaid, or includes although it says not."""
    included, excepted = reached(INCLUDE.findall(text), includes), re.findall(r'`([\w/]+\.h)`', text)
    wrong = [f'Flip_geodesics.h leaves out {h}' for h in set(module_of) - included - reached(excepted, includes)]
    return sorted(wrong) + [f'Flip_geodesics.h includes {h}' for h in excepted if h in included]


def main():
    source = Path(sys.argv[1])
    folder = source / 'include/CGAL/Flip_geodesics'
    below, module_of, wrong = modules_of_table(source / 'doc/Flip_geodesics/Design.txt')
    texts = {str(p.relative_to(folder)): p.read_text() for p in sorted(folder.rglob('*.h'))}
    includes = {name: INCLUDE.findall(text) for name, text in texts.items()}
    wrong += [f'{name} befriends {friend}' for name, text in texts.items() for friend in wrong_friends(text)]
    wrong += [f'{h} of the table does not exist' for h in module_of if h not in includes]
    for name, others in includes.items():
        module = module_of_header(name, module_of)
        if module not in below:
            wrong.append(f'{name} is in no module of the table')
            continue
        for other in others:
            its_module = module_of_header(other, module_of)
            if its_module != module and its_module not in below[module]:
                wrong.append(f'{name} in {module} includes {other} of {its_module}, which is not below it')
    wrong += [f'a circle: {c}' for c in find_circles(includes)]
    wrong += wrong_in_umbrella((folder.parent / 'Flip_geodesics.h').read_text(), includes, module_of)
    print('\n'.join(wrong) if wrong else f'{len(includes)} headers in {len(below)} modules')
    return 1 if wrong or not includes else 0


if __name__ == '__main__':
    sys.exit(main())
