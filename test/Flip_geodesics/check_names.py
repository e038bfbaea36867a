#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Reads what is said of functions, and looks whether there are such functions.

    check_names.py SOURCE_DIR

A function that the manual or a comment of a header names between backticks, with parentheses behind it, is a name in the
code of the headers or of a concept's page, and so is one that a drawing of the manual names in the monospaced font.
Functions of other libraries are named with their namespace. No word stands twice in a row, and no two groups of the
reference have the same brief.
"""

import re
import sys
from pathlib import Path

COMMENT = re.compile(r'//[^\n]*|/\*.*?\*/', re.DOTALL)
SPAN = re.compile(r'`([^`\n]+(?:\n[^`\n]+)?)`')  # maybe over the end of a line
CALL = re.compile(r'(?<![\w:])((?:\w+::)*)(\w+)\(')
OTHERS = re.compile(r'(?:std|boost|Eigen|CGAL::(?!Flip_geodesics::).*)::$|CGAL::$')
LANGUAGE = {'for', 'sizeof', 'static_cast'}
DRAWN_CODE = re.compile(r'<tspan [^>]*Mono[^>]*>([^<]*)<')
GROUP = re.compile(r'\\defgroup (\w+) [^\n]*\n((?:/// [^\\][^\n]*\n)+)')


def prose(path):
    """The comments of a header, a page without its code, or the names in a drawing; line breaks stay."""
    text = path.read_text()
    if path.suffix == '.h':
        return ''.join(re.sub(r'^ *(?:///<?|/\*!|/\*|\*/|\*|//)|\*/', ' ', line) + '\n'
                       for line in text.split('\n') if re.match(r' *(/?\*|//)', line) or '///<' in line)
    if path.suffix == '.svg':
        return '\n'.join(f'`{code}`' for code in DRAWN_CODE.findall(text))
    text = re.sub(r'^```.*?^```', '', text, flags=re.MULTILINE | re.DOTALL)
    return '\n'.join(line for line in text.split('\n') if not line.startswith('    '))


def unknown_functions(text, known):
    for span in SPAN.findall(text):
        for namespace, name in CALL.findall(span):
            if not OTHERS.match(namespace) and name not in known and name not in LANGUAGE:
                yield f'{namespace}{name}()'


def doubled_words(text):
    plain = SPAN.sub(' . ', text)
    return [' '.join(found.group(0).split()) for found in re.finditer(r'\b([a-z]{2,})(?: | ?\n *)\1\b(?![-.]\w)', plain)]


def equal_briefs(text):
    first = {}
    for group, brief in GROUP.findall(text):
        if first.setdefault(brief, group) != group:
            yield f'{first[brief]} and {group} have the same brief'


def main(source):
    headers = sorted((source / 'include').rglob('*.h'))
    manual = source / 'doc/Flip_geodesics'
    concepts = sorted((manual / 'Concepts').glob('*.h'))
    pages = sorted(manual.glob('*.txt')) + sorted(manual.glob('*.md')) + [source / 'README.md']
    pages += sorted((manual / 'fig').glob('*.svg'))
    known = set(re.findall(r'\w+', ' '.join(COMMENT.sub(' ', h.read_text()) for h in headers)))
    for page in concepts:  # functors stand in their comments
        known.update(re.findall(r'\w+', page.read_text()))
    wrong = []
    for path in headers + concepts + [page for page in pages if page.name != 'CMakeLists.txt']:
        text, name = prose(path), path.relative_to(source)
        wrong += [f'{name}: there is no {function}' for function in unknown_functions(text, known)]
        wrong += [f'{name}: a word stands twice: {words}' for words in doubled_words(text)]
    wrong += equal_briefs((manual / 'PackageDescription.txt').read_text())
    print('\n'.join(wrong) if wrong else f'{len(headers)} headers and {len(pages) + len(concepts)} pages name what there is')
    return 1 if wrong or not headers or not pages else 0


if __name__ == '__main__':
    sys.exit(main(Path(sys.argv[1])))
