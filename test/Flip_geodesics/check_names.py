#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Reads what is said of functions and sources, and looks whether there are such functions and sources.

    check_names.py SOURCE_DIR

A function that the manual or a comment of a header names between backticks, with parentheses behind it, is a name in the
code of the headers or of a concept's page, and so is one that a drawing of the manual names in the monospaced font.
Functions of other libraries are named with their namespace. No word stands twice in a row, and no two groups of the
reference have the same brief.

Sources are cited by their keys in the bibliography, as \\cgalCite{KEY} or \\cgalCite{KEY,place} where Doxygen reads, and as
[KEY] or [KEY, place] elsewhere. Each entry of the bibliography is cited.
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
COMMENTS = re.compile(r'(/\*!.*?\*/|///[^\n]*)|(//[^\n]*|/\*.*?\*/)', re.DOTALL)  # those that Doxygen reads, and others
SURNAME = re.compile(r'(?<!! )\[[A-Z][a-z]{3,}(?:\]|, [A-Z][^\]]*\]|(?: and| et al|,? (?:19|20)\d\d)[^\]]*\])')
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


def wrong_citations(path, text, keys, cited):
    """Sources by another name than a key of the bibliography, or in the wrong form; adds the keys to `cited`."""
    is_read = path.suffix == '.txt' or 'internal' not in path.parts and path.parts[0] in ('doc', 'include')
    for read, plain in ((text, ''),) if path.suffix == '.txt' else COMMENTS.findall(text):
        found = [(key, True) for key in re.findall(r'\\cgalCite\{(\w*)', read + plain)]
        found += [(key, False) for names in re.findall(r'\[([A-Z]+\d\d[a-z]?\b[^\]]*)', read + plain)
                  for key in re.findall(r'\b[A-Z]+\d\d[a-z]?\b', names)]
        for key, is_command in found:
            cited.add(key)
            if key not in keys:
                yield f'the bibliography has no entry {key}'
            if is_command != (is_read and plain == ''):
                yield f'{key} is cited as {"[...]" if is_read and plain == "" else "a command"}'
        for name in SURNAME.findall(read + plain):
            yield f'cited without a key: {name}'


def citations(source):
    manual = source / 'doc/Flip_geodesics'
    keys = set(re.findall(r'^@\w+\{(\w+),$', (manual / 'Flip_geodesics.bib').read_text(), re.M))
    pages = [page for page in manual.glob('*.txt') if page.name != 'CMakeLists.txt']
    code = [path for folder in ('doc', 'include', 'examples', 'benchmark', 'test')
            for path in (source / folder).rglob('*') if path.suffix in ('.h', '.cpp')]
    cited, wrong = set(), []
    for path in sorted(pages + code):
        name = path.relative_to(source)
        wrong += [f'{name}: {citation}' for citation in wrong_citations(name, path.read_text(), keys, cited)]
    for script in manual.glob('*.py'):
        cited.update(re.findall(r'\[([A-Z]+\d\d[a-z]?)\b', script.read_text()))
    return wrong + [f'the entry {key} of the bibliography is cited nowhere' for key in sorted(keys - cited)]


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
    wrong += citations(source)
    wrong += equal_briefs((manual / 'PackageDescription.txt').read_text())
    print('\n'.join(wrong) if wrong else f'{len(headers)} headers and {len(pages) + len(concepts)} pages name what there is')
    return 1 if wrong or not headers or not pages else 0


if __name__ == '__main__':
    sys.exit(main(Path(sys.argv[1])))
