#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The recipes for package managers speak of this version, and of files that exist, and examples/run.sh installs what the
program can use: check_packages.py ROOT"""

import json
import re
import sys
from pathlib import Path


def main():
    root = Path(sys.argv[1])
    recipes = root / 'package_info'
    found = {
        'CMakeLists.txt': re.search(r'^  VERSION (\S+)', (root / 'CMakeLists.txt').read_text(), re.M)[1],
        'debian': re.search(r'\((.*?)\)', (recipes / 'debian/changelog').read_text())[1],
        'vcpkg': json.loads((recipes / 'vcpkg/vcpkg.json').read_text())['version'],
        'conan': re.search(r'^    version = "(.*)"', (recipes / 'conan/conanfile.py').read_text(), re.M)[1],
        'CITATION.cff': re.search(r'^version: (\S+)', (root / 'CITATION.cff').read_text(), re.M)[1],
        'CHANGELOG.md': re.search(r'^## (\d\S*)', (root / 'CHANGELOG.md').read_text(), re.M)[1],
    }
    problems = [] if len(set(found.values())) == 1 else [f'versions differ: {found}']
    compile((recipes / 'conan/conanfile.py').read_text(), 'conanfile.py', 'exec')
    for recipe in ('vcpkg/portfile.cmake', 'conan/conanfile.py', 'debian/rules', 'debian/tests/example'):
        for name in re.findall(r'\b(?:LICENSE|test/\w+/\w+)\b', (recipes / recipe).read_text()):
            if not (root / name).exists():
                problems.append(f'{recipe} names {name}, which is missing')
    installed = re.search(r'^packages=\((.*?)\)', (root / 'examples/run.sh').read_text(), re.M | re.S)[1].split()
    for package in ('libcli11-dev', 'libtbb-dev', 'zlib1g-dev'):
        if package not in installed:
            problems.append(f'examples/run.sh does not install {package}, and builds a program with fewer options')
    print('\n'.join(problems))
    sys.exit(1 if problems else 0)


if __name__ == '__main__':
    main()
