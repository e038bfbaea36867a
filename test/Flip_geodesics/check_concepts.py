#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Reads the manual's table of what asks for which concept, the headers and the tests, and compares them.

No header detects a member of a user's class that is not described as optional on the page of a concept.

    check_concepts.py SOURCE_DIR

What the table names is public, each concept has a page, and each public template over a triangulation or a network is
in the table. The tests that hand archetypes on name all of it.
"""

import re
import sys
from pathlib import Path

TESTS = ['test_archetypes.cpp', 'test_operators.cpp', 'test_edge_path_graph.cpp']
ROW = re.compile(r'^\| (.*) \| (.*) \| (.*)\|$')
NAME = re.compile(r'`(\w+)(?:\(\))?`')
INTERNAL = re.compile(r'^namespace (?:[\w:]*::)?internal \{.*?^\} // namespace [\w:]*internal', re.MULTILINE | re.DOTALL)
TEMPLATE = re.compile(r'^template <class (?:Triangulation_?|Network_?|Search)\b[^;{]*?[>\n](?:class (\w+)|[^;{(]*?\b(\w+)\()',
                      re.MULTILINE)


DETECTED = re.compile(r'declval<(?:[^<>]|<[^<>]*>)*>\(\)\.(\w+)|typename (?!std|boost)\w+::(\w+)')
OPTIONAL = re.compile(r'/// \(Optional\)((?:.*\n *///)*.*)\n(?: *template .*\n)?.*?(\w+)(?:\(.*)?;')
# Members of classes of CGAL and Boost and of the standard library: points and numbers, kernels, pairs, maps.
FOREIGN = {'x', 'y', 'z', 'approx', 'exact', 'FT', 'Vector_3', 'first', 'second', 'mapped_type'}
# Required members of a concept, which distinguish its models from those of another concept or from other types.
DISTINGUISHING = {'Halfedge_geometry', 'Turn', 'Has_drift', 'Face_geometry', 'Flipped_geometry', 'Kernel', 'Mesh',
                  'Place', 'Triangulation', 'number_of_curves', 'edge_sequence', 'go_further', 'on_flip', 'after_flip_out'}
# Members of classes of the package.
OWN = {'idx', 'location', 'locations'}


def template_arguments(text):
    """What follows the opening bracket of a template's arguments, up to the closing one."""
    depth = 1
    for i, c in enumerate(text):
        depth += {'<': 1, '>': -1}.get(c, 0)
        if depth == 0:
            return text[:i]
    return text


def detected_members(source):
    """The names of members that headers look for, and the headers."""
    for header in sorted((source / 'include/CGAL/Flip_geodesics').rglob('*.h')):
        for part in header.read_text().split('void_t<')[1:]:
            for member, type_name in DETECTED.findall(template_arguments(part)):
                yield member or type_name, header.name


def table(manual):
    """The names of algorithms, those of concepts and the classes that stand for one, from the manual's table."""
    text = manual.read_text()
    section = text[text.index('\\section Flip_geodesicsAsked'):]
    rows = [ROW.match(line) for line in section[:section.index('\n\\section', 1)].split('\n')]
    rows = [row for row in rows if row][1:]
    names = [name for row in rows for name in NAME.findall(row.group(1))]
    asked = {name for row in rows for column in (2, 3) for name in NAME.findall(row.group(column))}
    return names, asked


def main():
    source = Path(sys.argv[1])
    headers = {p.name: INTERNAL.sub('', p.read_text())
               for p in sorted((source / 'include/CGAL/Flip_geodesics').rglob('*.h'))
               if 'internal' not in p.parts}
    public = '\n'.join(headers.values())
    folder = source / 'test/Flip_geodesics'
    tests = '\n'.join(p.read_text() for test in TESTS for p in [folder / test, *folder.glob(test[:-4] + '/*')])
    names, asked = table(source / 'doc/Flip_geodesics/Design.txt')
    wrong = [f'{name} is twice in the table' for name in sorted(set(names)) if names.count(name) > 1]
    for name in names:
        if not re.search(rf'\b(?:class {name}\b|{name}\()', public):
            wrong.append(f'{name} of the table is not public')
        if not re.search(rf'\b{name}\b', tests):
            wrong.append(f'{name} of the table gets no archetype in {", ".join(TESTS)}')
    for name in asked - {'Edge_path_network'}:
        if not (source / f'doc/Flip_geodesics/Concepts/{name}.h').exists():
            wrong.append(f'{name} of the table has no page')
    for header, text in headers.items():
        for match in TEMPLATE.finditer(text):
            name = match.group(1) or match.group(2)
            if name not in names:
                wrong.append(f'{name} of {header} is not in the table')
    pages = '\n'.join(p.read_text() for p in (source / 'doc/Flip_geodesics/Concepts').glob('*.h'))
    optional = {match.group(2) for match in OPTIONAL.finditer(pages)}
    detected = sorted(set(detected_members(source)))
    for name, header in detected:
        if name in DISTINGUISHING and not re.search(rf'\b{name}(?:;|\()', pages):
            wrong.append(f'{name}, which {header} detects, is on no page of a concept')
        elif name not in optional | FOREIGN | DISTINGUISHING | OWN:
            wrong.append(f'{name}, which {header} detects, is not described as optional on the page of a concept')
    for name in sorted((FOREIGN | DISTINGUISHING | OWN) - {name for name, header in detected}):
        wrong.append(f'{name} is not detected by any header, but {Path(__file__).name} lists it')
    print('\n'.join(wrong) if wrong else f'{len(names)} algorithms, {len(asked)} concepts and classes')
    return 1 if wrong or not names else 0


if __name__ == '__main__':
    sys.exit(main())
