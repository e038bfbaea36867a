#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Reads the manual, and the comments and messages of the headers and examples, and reports idioms to avoid.

    check_language.py SOURCE_DIR

WORDS lists turns of phrase together with what to write instead, usually the term of the field. In addition, a brief of a
public function begins with a verb in the third person, each \\throws names one exception, headings are not questions,
and the sentences and chapters of the manual are not too long.
"""

import re
import sys
from bisect import bisect_right
from pathlib import Path

WORDS = [(better, re.compile(expression)) for better, expression in [
    ('shorten to a geodesic', r'\bpull\w*(?: \w+)? (?:tight|taut)\b|\btaut\b'),
    ('X is not a Y; without', r'(?<!there )\b(?:is|are|was|were) no (?!(?:more|less|(?:long|short|great|larg|small|farth|clos|low|high|lat|near)er)\b)[a-z]'),
    ('given, measured from, returns', r'\btold\b|\btells?\b(?! apart)'),
    ('recomputed from the input', r'\bafresh\b|\banew\b'),
    ('verified', r'\bbeliev\w+'),
    ('requires, queries', r'\bask(?:s|ed|ing)\b'),
    ('determines, has', r'\bknows\b'),
    ('returns, states', r'\bsays\b'),
    ('degenerate', r'\bwithout (?:an )?area\b|\bedges? of (?:zero length|length zero)\b'),
    ('coincident', r'\bvertices in one place\b'),
    ('If or When', r'(?<=[.;:] )Where\b'),
    ('a conjunction inside the sentence', r'(?<=[.;] )(?:So|Hence)\b(?! that)'),
    ('%', r'\bper cent\b'),
    ('90th percentile', r'\bnine in ten\b'),
    ('wall-clock time', r'\bclock on the wall\b'),
    ('modules', r'\brooms\b'),
    ('outgoing halfedge', r'\bspokes?\b'),
    ('portal', r'\bgates?\b'),
    ('overlapping segments, bundle', r'\bstrands?\b'),
    ('edge sequence', r'\bcrossing words?\b'),
    ('umbrellas', r'\bsheets of the surface\b'),
    ('bitwise identical', r'\bto the bit\b|\bbit (?:by|for) bit\b'),
    ('multiprecision', r'\bnumbers (?:of|with) many digits\b'),
    ('a noun', r'\bby as much\b|\bwhat (?:it|this|that) costs\b'),
    ('repeatedly', r'\bagain and again\b'),
    ('blocked', r'\bheld up\b'),
    ('rolled back', r'\btaken back\b'),
    ('competing methods, reference implementation, adversarial', r'\bopponents?\b|\breferee\b|\bhostile\b'),
    ('rounding errors', r'\broundings\b'),
    ('double-double arithmetic', r'\bpairs of doubles\b'),
    ('free functions', r'\bone-call\b'),
    ('predicates', r'\b(?:in)?(?:exact|certified|close) decisions?\b|\bdecisions (?:that|which) (?:can )?err'),
    ('must, should', r'\b(?:is|are) to (?:be|have|go|become)\b'),
]]

COMMENT_OR_STRING = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"', re.S)
CODE = re.compile(r'^```.*?^```|\\code.*?\\endcode|^    [^\n]*|`[^`]*`|\\f\$.*?\\f\$|\\f\[.*?\\f\]', re.S | re.M)
BLOCK = re.compile(r'(?:^ *///[^\n]*\n)+|^ */\*!.*?\*/\n', re.S | re.M)
FUNCTION = re.compile(r'(?:template *<.*?> *)?[\w:<>,&* ]*?\b(?!if|for|while)\w+\(', re.S)
VERB = re.compile(r'(?:\w+ly )?(?:\(Optional\) )?(?:[A-Za-z]+s|Has|Is|Called)\b')
LONGEST_SENTENCE = 70  # words; the longest are lists
LONGEST_CHAPTER = 3000
NOTES = {'Design.txt', 'Theory.txt', 'PackageDescription.txt'}  # not chapters for users


class Prose:
    """The words of a text with single spaces between them, and the lines that they come from."""

    def __init__(self, path):
        text = path.read_text()
        if path.suffix in ('.h', '.cpp'):
            text = self.of_code(text)
        text = CODE.sub(lambda match: '_' + '\n' * match.group(0).count('\n'), text)
        words = [(match.group(0), line) for line, content in enumerate(text.split('\n'), 1)
                 for match in re.finditer(r'\S+', content)]
        self.text, self.starts, self.lines = '', [], []
        for word, line in words:
            self.starts.append(len(self.text))
            self.lines.append(line)
            self.text += word + ' '

    @staticmethod
    def of_code(text):
        prose, end = '', 0
        for match in COMMENT_OR_STRING.finditer(text):
            content = re.sub(r'(?m)^ *(?:\*/?|//[/!]?<?)|^/\*!?|\*/$|^"|"$', '', match.group(0))
            prose += '\n' * text.count('\n', end, match.start()) + ' ' + content
            end = match.end()
        return prose

    def line(self, position):
        return self.lines[bisect_right(self.starts, position) - 1]


def wrong_words(prose):
    for better, expression in WORDS:
        for match in expression.finditer(prose.text):
            around = prose.text[max(match.start() - 25, 0):match.end() + 25].strip()
            yield f'{prose.line(match.start())}: "{around}": rather {better}'


def wrong_briefs(text):
    """Of functions: what follows the comment ends in a parenthesis."""
    for match in BLOCK.finditer(text):
        block = match.group(0)
        line = text.count('\n', 0, match.start()) + 1
        for found in re.finditer(r'\\(?:throws|exception) +\w+(?:,| or | and \w+ if)', block):
            yield f'{line}: several exceptions in "{found.group(0)}"'
        brief = re.sub(r'^[\s/*!]*', '', block)
        if FUNCTION.match(text[match.end():].lstrip()) and not brief.startswith(('\\', '@')) and not VERB.match(brief):
            yield f'{line}: a brief begins with a verb: "{brief[:40].splitlines()[0]}"'


def wrong_headings(text):
    for match in re.finditer(r'^\\(?:page|section|subsection|subsubsection) +\w+ +(.*)', text, re.M):
        if re.match(r'(?:What|How|Why|Where|When|Who)\b', match.group(1)) or match.group(1).endswith('?'):
            yield f'{text.count(chr(10), 0, match.start()) + 1}: a heading is a noun phrase: "{match.group(1)}"'


def wrong_lengths(path):
    text = re.sub(r'^\\(?:page|mainpage|section|subsection|anchor|authors|example|snippet|include|cgal\w+)[^\n]*|^\|[^\n]*|<[^>]*>',
                  '\n\n', CODE.sub('_', path.read_text()), flags=re.M)
    number = len(text.split())
    if number > LONGEST_CHAPTER and path.name not in NOTES:
        yield f'1: {number} words are too many for a chapter'
    for paragraph in re.split(r'\n\s*\n|^ *(?:-|\d+\.) ', text, flags=re.M):
        for sentence in re.split(r'(?<=[.:;?!]) ', ' '.join(paragraph.split())):
            if len(sentence.split()) > LONGEST_SENTENCE:
                yield f'{path.read_text().count(chr(10), 0, path.read_text().find(sentence[:20])) + 1}: ' \
                      f'a sentence of {len(sentence.split())} words: "{sentence[:60]}..."'


def main(source):
    manual = source / 'doc/Flip_geodesics'
    pages = [*sorted(manual.glob('*.txt')), *sorted(source.glob('*.md'))]
    pages = [page for page in pages if page.name != 'CMakeLists.txt']
    concepts = sorted((manual / 'Concepts').glob('*.h'))
    headers = sorted((source / 'include').rglob('*.h'))
    examples = [path for path in sorted((source / 'examples').rglob('*')) if path.suffix in ('.h', '.cpp')]
    problems = []

    def report(path, found):
        problems.extend(f'{path.relative_to(source)}:{problem}' for problem in found)

    for path in pages + concepts + headers + examples:
        report(path, wrong_words(Prose(path)))
    for path in concepts + [header for header in headers if 'internal' not in header.parts]:
        report(path, wrong_briefs(path.read_text()))
    for path in pages:
        report(path, wrong_headings(path.read_text()))
        if path.parent == manual:
            report(path, wrong_lengths(path))
    print('\n'.join(problems) if problems else f'{len(pages + concepts + headers + examples)} files read well')
    return 1 if problems or not headers or not pages else 0


if __name__ == '__main__':
    sys.exit(main(Path(sys.argv[1]).resolve()))
