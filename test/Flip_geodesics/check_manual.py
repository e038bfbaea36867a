#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Reads the manual as a browser would: check_manual.py HTML

Briefs stand beside the names in all lists, figures have numbers and are named by them, citations and enumerators are
links, no sign of the markup is left over, and no type of the implementation is named. The pages beside the manual have
the pictures and files that they name, and pictures are small.
"""

import re
import sys
from html import unescape
from pathlib import Path

problems = []


def excerpt(text, match):
    return text[max(match.start() - 30, 0):match.end() + 10].strip()


def without_code(text):
    text = re.sub(r'<div class="ttc".*?</div></div>', ' ', text, flags=re.S)  # what is shown over a name in code
    text = re.sub(r'<(pre|script|head)\b.*?</\1>|<div class="(fragment|line)".*?</div>', ' ', text, flags=re.S)
    return re.sub(r'<code\b.*?</code>', ' ', text, flags=re.S)


def check_briefs(name, text):
    """Each name in a list of a page is followed by a brief."""
    rows = re.findall(r'<tr class="memitem:(\w+)"[^>]*>(.*?)</tr>\s*(?:<tr class="memdesc:\1)?', text, re.S)
    with_brief = set(re.findall(r'<tr class="memdesc:(\w+)"', text))
    for row, content in rows:
        if row and row not in with_brief and '=delete' not in content:
            plain = ' '.join(unescape(re.sub('<[^>]*>', ' ', content)).split())
            problems.append(f'{name}: no brief for "{plain}"')


def check_markup(name, text):
    """No markup that came through as it is."""
    text = re.sub(r'\\\(.*?\\\)|\\\[.*?\\\]', ' ', without_code(text), flags=re.S)  # formulas
    for found in re.findall(r'<p[^>]*>\w[\w ]*\*\s.{0,20}', text):
        problems.append(f'{name}: an asterisk was taken away before "{found}"')
    plain = unescape(re.sub(r'<[^>]*>', '', text))
    if name.startswith('Flip_geodesics') or name == 'index.html':  # the chapters, which have no pointers
        for found in re.finditer(r'\*(?=\w)|(?<!\bA)(?<!\bTheta)(?<=[\w.])\*', plain):
            problems.append(f'{name}: an asterisk is left over in "{excerpt(plain, found)}"')
    for found in re.finditer(r'`|\\[a-z]{3,}\b|\bcgal[A-Z]\w+', plain):
        problems.append(f'{name}: markup left over in "{excerpt(plain, found)}"')
    for found in re.finditer(r'(?m)^\s*< \w', plain):
        problems.append(f'{name}: a comment behind a member was misread in "{excerpt(plain, found)}"')
    if not name.startswith(('Flip_geodesics', 'hierarchy')):  # developers read of internal names, and bases are listed
        for found in re.finditer(r'\binternal::|\benable_if', plain):
            problems.append(f'{name}: an internal name in "{excerpt(plain, found)}"')


def check_signatures(name, text):
    """No signature names a type of the implementation."""
    for found in re.finditer(r'internal::\w+', unescape(re.sub(r'<[^>]*>', '', without_code(text)))):
        problems.append(f'{name}: {found[0]} is not public')


def check_citations(name, text, keys):
    """Each citation leads to the list of references."""
    plain = re.sub(r'<a class="el" href="[^"]*#cite_\w+">\w+</a>', '', without_code(text))
    plain = re.sub(r'<li>\s*<a class="anchor".*?</li>', '', plain, flags=re.S)  # the list of references
    for found in re.finditer(rf'\b(?:{"|".join(sorted(keys))})\b', plain):
        problems.append(f'{name}: citation without a link: {excerpt(plain, found)}')


def check_links(name, text, pages, folder):
    for target, anchor in re.findall(r'<a class="el" href="([\w.]+\.html)?(?:#(\w+))?"', text):
        page = pages.get(target or name)
        if page is None:
            if not (folder / target).is_file():  # a listing of a header is
                problems.append(f'{name}: a link to {target}, which is missing')
        elif anchor and f'id="{anchor}"' not in page and f'name="{anchor}"' not in page:
            problems.append(f'{name}: a link to {target}#{anchor}, which is missing')


def check_figures(pages):
    """Captions are numbered from one on, and each figure that is referred to is named by its number."""
    numbers = []
    for name, text in pages.items():
        numbers += [int(n) for n in re.findall(r'<b>Figure (\d+)\.</b>', text)]
        for label in re.findall(r'<a class="el" href="[^"]*#fig__\w+">(.*?)</a>', text):
            if not re.fullmatch(r'Figure \d+', label):
                problems.append(f'{name}: a reference to a figure reads "{label}"')
    if sorted(numbers) != list(range(1, len(numbers) + 1)) or not numbers:
        problems.append(f'figures are numbered {sorted(numbers)}')


def check_enumerators(name, text, enumerators):
    for enumerator in re.findall(r'(?<!">)<code>([A-Z][A-Z_]+)</code>(?!</a>)', text):
        if enumerator in enumerators:
            problems.append(f'{name}: {enumerator} is not linked')


def check_headers(name, text):
    """The page of a class names its header, except that of a specialisation; the page of a concept names none."""
    is_class = re.fullmatch(r'(class|struct)CGAL_1_1Flip__geodesics_1_1[A-Za-z]\w*?\.html', name) is not None
    if is_class and '_3_01' not in name and '<code>#include' not in text:
        problems.append(f'{name}: the header is missing')
    if '/Concepts/' in text:
        problems.append(f'{name}: a concept with a header')


def check_pages_of_repository(root):
    """Pictures and links of the pages that are read where the repository is hosted lead to files."""
    for name in ('README.md', 'CONTRIBUTING.md', 'doc/Flip_geodesics/Gallery.md'):
        page = root / name
        targets = re.findall(r'\](?:\(|: )([^)#\s]+)', page.read_text())
        for target in targets:
            if '://' not in target and not (page.parent / target).exists():
                problems.append(f'{name}: {target} is missing')


def check_pictures(root):
    """Each picture is on a page, and none takes long to load."""
    manual = root / 'doc/Flip_geodesics'
    pages = [*manual.glob('*.txt'), *manual.glob('*.md')]
    text = ''.join(page.read_text() for page in pages)
    for picture in (manual / 'fig').iterdir():
        if picture.name not in text:
            problems.append(f'{picture.name} is on no page')
        if picture.stat().st_size > 300_000:
            problems.append(f'{picture.name} has more than 300 000 bytes')


def check_first_program(root):
    """README.md and the chapter Getting Started print the same program."""
    listings = [re.search(pattern, (root / name).read_text(), re.S)
                for name, pattern in (('README.md', r'```cpp\n(.*?)```'),
                                      ('doc/Flip_geodesics/Getting_started.txt', r'\\code\{\.cpp\}\n(.*?)\\endcode'))]
    if None in listings or listings[0][1] != listings[1][1]:
        problems.append('README.md and Getting_started.txt do not have the same program')


def main():
    folder = Path(sys.argv[1])
    pages = {page.name: page.read_text() for page in sorted(folder.glob('*.html')) if '_source' not in page.name}
    if len(pages) < 100:
        sys.exit(f'{folder} holds {len(pages)} pages: no manual')
    sys.path.insert(0, str(Path(__file__).parents[2] / 'doc/Flip_geodesics'))
    import filter as source

    if len(source.references()) < 10 or len(source.enumerators()) < 10:
        problems.append('the references or enumerations were not found')
    for name, text in pages.items():
        if '-example.html' in name or '-members' in name:
            continue
        check_briefs(name, text)
        check_markup(name, text)
        check_signatures(name, text)
        check_citations(name, text, source.references())
        check_enumerators(name, text, source.enumerators())
        check_links(name, text, pages, folder)
        check_headers(name, text)
    check_figures(pages)
    check_pages_of_repository(Path(__file__).parents[2])
    check_pictures(Path(__file__).parents[2])
    check_first_program(Path(__file__).parents[2])
    print('\n'.join(problems))
    sys.exit(1 if problems else 0)


if __name__ == '__main__':
    main()
