#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""No header uses a name that headers of a system define as a macro: those of Windows, of macOS and of glibc.

    check_macros.py ROOT

`min` and `max` of Windows take arguments, and may stand in parentheses: (std::max)(a, b).
"""

import pathlib
import re
import sys

MACROS = {
    "near", "far", "small", "hyper", "interface", "check", "verify", "require", "minor", "major", "unix", "linux",
    "IN", "OUT", "OPTIONAL", "CONST", "VOID", "TRUE", "FALSE", "ERROR", "STRICT", "DELETE", "DOMAIN", "OVERFLOW",
    "UNDERFLOW", "I",
}
TOKEN = re.compile(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\])*\"|'(?:\\.|[^'\\])+'|\b[A-Za-z_]\w*\b", re.S)
CALL = re.compile(r"(?<!\w)(?:min|max)\s*\(")


def main():
    root = pathlib.Path(sys.argv[1])
    headers = sorted((root / "include").rglob("*.h"))
    wrong = []
    for header in headers:
        text = header.read_text()
        for match in TOKEN.finditer(text):
            name = match.group()
            if name in MACROS or (name in ("min", "max") and CALL.match(text, match.start())):
                line = text.count("\n", 0, match.start()) + 1
                wrong.append(f"{header.relative_to(root)}:{line}: {name} is a macro elsewhere")
    print("\n".join(wrong) or f"{len(headers)} headers use no name of a macro")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
