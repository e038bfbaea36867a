#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Removes the `#include` line, which Doxygen writes for classes, from the pages of concepts: remove_concept_headers.py HTML_DIR"""

import re
import sys
from pathlib import Path

INCLUDE = re.compile(r'<p><code>#include [^\n]*/Concepts/[^\n]*</code></p>\n')


def main():
    for page in Path(sys.argv[1]).glob('class*.html'):
        text = page.read_text()
        if INCLUDE.search(text):
            page.write_text(INCLUDE.sub('', text))


if __name__ == '__main__':
    main()
