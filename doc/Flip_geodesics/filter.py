#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What Doxygen reads in place of a file of the manual or a header: filter.py FILE

Numbers figures and names them by their numbers where they are referred to, and links names of enumerators to their
enumerations. Writes formulas of a letter or two without LaTeX, so that they can be read where MathJax cannot be loaded.
Leaves out the conditions by which the compiler tells overloads apart. Lines keep their numbers.

Of the BibTeX file, it makes the chapter Bibliography, to whose anchors `\\cgalCite` leads. Doxygen's own commands for
that require bibtex and Perl.
"""

import re
import sys
import unicodedata
from functools import lru_cache
from pathlib import Path

DOC = Path(__file__).resolve().parent
HEADERS = DOC.parents[1] / 'include'
BIBLIOGRAPHY = DOC / 'Flip_geodesics.bib'
ACCENTS = {"'": '\u0301', '`': '\u0300', '"': '\u0308', 'c ': '\u0327'}


def chapters():
    """The files of the manual in the order in which they are read."""
    inputs = re.search(r'^INPUT .*?\n(?=[A-Z#\n])', (DOC / 'Doxyfile.in').read_text(), re.M | re.S).group(0)
    return [DOC / name for name in re.findall(r'DOC_DIR@/(\w+\.txt)"', inputs)]


@lru_cache(maxsize=None)
def figures():
    """The number of each figure by its name."""
    names = [name for chapter in chapters() for name in re.findall(r'\\cgalFigureBegin\{(\w+),', chapter.read_text())]
    return {name: number for number, name in enumerate(names, 1)}


def references():
    """The fields of each entry of the bibliography by its key."""
    return {key: dict(re.findall(r'^ *(\w+) *= \{(.*)\},?$', fields, re.M))
            for key, fields in re.findall(r'^@\w+\{(\w+),\n(.*?)^\}', BIBLIOGRAPHY.read_text(), re.M | re.S)}


def bibliography():
    """The chapter with all entries, in the order of the file."""
    def plain(text):
        accented = re.sub(r'\{\\([\'`"]|c )(\w)\}', lambda m: unicodedata.normalize('NFC', m[2] + ACCENTS[m[1]]), text)
        return re.sub(r'[{}]', '', accented.replace(r'\&', '&amp;')).encode('ascii', 'xmlcharrefreplace').decode()

    def item(key, fields):
        place = fields.get('journal') or fields.get('booktitle') or fields.get('note')
        issue = fields.get('volume', '') + (f'({fields["number"]})' if 'number' in fields else '')
        source = ', '.join(part for part in (f'{place or ""} {issue}'.strip(), fields.get('publisher'), fields['year']) if part)
        doi = f' <a href="https://doi.org/{fields["doi"]}">doi:{fields["doi"]}</a>' if 'doi' in fields else ''
        authors = ', '.join(fields['author'].split(' and '))
        text = f'{plain(authors)}. {plain(fields["title"])}. {plain(source)}.{doi}'
        return f'<li>\\anchor cite_{key} [{key}] {text}</li>\n'

    items = ''.join(item(key, fields) for key, fields in references().items())
    return f'/*!\n\\page Flip_geodesicsBibliography Bibliography\n\n<ul>\n{items}</ul>\n*/'


@lru_cache(maxsize=None)
def enumerators():
    """The enumeration of each public enumerator, of those that only one has."""
    owners = {}
    for header in sorted(HEADERS.rglob('*.h')):
        if 'internal' in header.parts:
            continue
        for enum, body in re.findall(r'^enum class (\w+)[^{]*\{(.*?)\n\};', header.read_text(), re.M | re.S):
            for line in body.splitlines():
                for name in re.findall(r'\b[A-Z][A-Z_]+\b', line.split('//')[0]):
                    owners.setdefault(name, set()).add(enum)
    return {name: enums.pop() for name, enums in owners.items() if len(enums) == 1}


def number_figures(line):
    line = re.sub(r'\\cgalFigureRef\{(\w+)\}', lambda m: rf'\ref fig__{m[1]} "Figure {figures()[m[1]]}"', line)
    return re.sub(r'(\\cgalFigureBegin\{(\w+),[^}]*\})', lambda m: rf'\1 <b>Figure {figures()[m[2]]}.</b>'.replace(r'\1', m[1]), line)


def link_enumerators(line):
    def link(match):
        enum = enumerators().get(match[1])
        return rf'\link CGAL::Flip_geodesics::{enum}::{match[1]} `{match[1]}`\endlink' if enum else match[0]

    return re.sub(r'`([A-Z][A-Z_]+)`', link, line)


def write_formulas(line):
    """Letters, multiples of pi, powers and orders of growth as HTML; other formulas stay."""
    def letters(text):
        return re.sub(r'[A-Za-z]+', lambda m: m[0] if m[0] == 'log' else f'<i>{m[0]}</i>', text)

    line = re.sub(r'\\f\$(\d?)\\(pi|alpha|gamma|Delta)\\f\$', r'\1&\2;', line)
    line = re.sub(r'\\f\$(\d+)\^\{-(\d+)\}\\f\$', r'\1<sup>&minus;\2</sup>', line)
    line = re.sub(r'\\cgalBigO\{([a-z](?: \\log [a-z])?)\}', lambda m: letters(rf'O({m[1]})'.replace('\\log', 'log')), line)
    return re.sub(r'\\f\$([A-Za-z]{1,2})\\f\$', lambda m: letters(m[1]), line)


def without_conditions(text):
    """Template arguments `std::enable_if_t<..., int> = 0` are left out, and `std::enable_if_t<..., T>` becomes T."""
    start = 0
    while (start := text.find('std::enable_if_t<', start)) >= 0:
        depth, end, comma = 1, start + len('std::enable_if_t<'), None
        while depth > 0:
            depth += {'<': 1, '(': 1, '>': -1, ')': -1}.get(text[end], 0)
            comma = end if text[end] == ',' and depth == 1 else comma
            end += 1
        kept, before = (text[comma + 1:end - 1].strip(), start) if comma else ('', start)
        if default := re.match(r' = 0', text[end:]):
            kept, before, end = '', text.rindex(',', 0, start), end + default.end()
        text = text[:before] + kept + '\n' * (text[before:end].count('\n') - kept.count('\n')) + text[end:]
        start = before + len(kept)
    return text


def main():
    path = Path(sys.argv[1])
    if path.suffix == '.bib':
        print(bibliography())
        return
    is_text = path.suffix == '.txt'
    in_code = False
    text = path.read_text()
    for line in (text if is_text else without_conditions(text)).splitlines():
        if re.search(r'\\code\b|\\verbatim\b', line):
            in_code = True
        if not in_code and (is_text or re.match(r'\s*(///|\*|/\*!)', line) or '///<' in line):
            line = write_formulas(link_enumerators(number_figures(line)))
        if re.search(r'\\endcode\b|\\endverbatim\b', line):
            in_code = False
        print(line)


if __name__ == '__main__':
    main()
