# SPDX-License-Identifier: LGPL-3.0-or-later
"""Generates mutants of the headers from their syntax trees.

`mutants_of(include)` returns each place where one operator, constant, condition, call or statement can be changed. It
reads all headers as one source with the Python bindings of clang (Debian's packages python3-clang-14 and
libclang-14-dev or later). What is evaluated at compile time, and what stands in macros, has no mutants.
"""

import bisect
import collections
import hashlib
import os
import re
import subprocess

from clang import cindex
from clang.cindex import CursorKind as Kind
from clang.cindex import TypeKind

# header: relative to the package; module: its folder, or "public"; function: with its class; begin, end: offsets in the
# header; kind: `expression` or `drop`; original, replacement: source text, the former as it stands in the header;
# occurrence: counts mutants of one function with the same texts.
Mutant = collections.namedtuple("Mutant", "header module function begin end kind original replacement occurrence")

HEADERS = "CGAL/Flip_geodesics/"
OPERATORS = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "&&": "||", "||": "&&",
             "+": "-", "-": "+", "*": "/", "/": "*", "%": "*"}
FUNCTIONS = {Kind.FUNCTION_DECL, Kind.FUNCTION_TEMPLATE, Kind.CXX_METHOD, Kind.CONSTRUCTOR, Kind.DESTRUCTOR,
             Kind.CONVERSION_FUNCTION}
CLASSES = {Kind.CLASS_DECL, Kind.STRUCT_DECL, Kind.CLASS_TEMPLATE, Kind.CLASS_TEMPLATE_PARTIAL_SPECIALIZATION}
AT_COMPILE_TIME = {Kind.STATIC_ASSERT, Kind.ENUM_DECL, Kind.TYPE_ALIAS_DECL, Kind.TYPE_ALIAS_TEMPLATE_DECL,
                   Kind.TEMPLATE_NON_TYPE_PARAMETER, Kind.TEMPLATE_TYPE_PARAMETER, Kind.USING_DECLARATION}
BODIES = {Kind.COMPOUND_STMT, Kind.IF_STMT, Kind.FOR_STMT, Kind.WHILE_STMT, Kind.DO_STMT, Kind.CXX_FOR_RANGE_STMT}
STATEMENTS = {Kind.CALL_EXPR, Kind.COMPOUND_ASSIGNMENT_OPERATOR, Kind.BINARY_OPERATOR, Kind.UNARY_OPERATOR}


# What is not known before a template is instantiated.
UNKNOWN = {TypeKind.INVALID, TypeKind.UNEXPOSED, TypeKind.DEPENDENT, TypeKind.OVERLOAD}


def squeezed(text):
    """Text without the white space that formatting changes."""
    return re.sub(r"\s+", " ", text).strip()


def module_of(header):
    parts = header.split("/")
    return parts[1] if parts[0] == "internal" else "public"


def digest(mutant):
    """What identifies a mutant in results, wherever its function moves within the header."""
    texts = (mutant.header, mutant.function, mutant.kind, squeezed(mutant.original), squeezed(mutant.replacement),
             str(mutant.occurrence))
    return hashlib.sha1("\0".join(texts).encode()).hexdigest()[:12]


def other_integer(text):
    return {"0": "1", "1": "2", "2": "3"}.get(text) or (str(int(text) + 1) if text.isdigit() else None)



class Reader:
    """Walks through one header's part of the syntax tree."""

    def __init__(self, header, text, macros):
        self.header, self.text, self.macros = header, text, macros
        self.found = []
        self.function = ""

    def of(self, cursor):
        return self.text[cursor.extent.start.offset:cursor.extent.end.offset]

    def is_in_macro(self, begin, end):
        i = bisect.bisect_right(self.macros, (end, end)) - 1
        return any(a < end and begin < b for a, b in self.macros[max(0, i - 3):i + 1])

    def add(self, begin, end, kind, replacement):
        if begin < end and not self.is_in_macro(begin, end):
            self.found.append((self.function, begin, end, kind, replacement))

    def replace(self, cursor, replacement):
        self.add(cursor.extent.start.offset, cursor.extent.end.offset, "expression", replacement)

    def is_template_argument(self, literal):
        before, after = self.text[:literal.extent.start.offset].rstrip(), self.text[literal.extent.end.offset:]
        return before[-1:] in ",<" and after[:1] == ">"

    def have_one_type(self, a, b):
        """Can two arguments of a call be swapped? Not known within templates: no."""
        types = [c.type.get_canonical() for c in (a, b)]
        names = [re.sub(r"\bconst\b|&", "", t.spelling).strip() for t in types]
        return names[0] == names[1] and not any(t.kind in UNKNOWN for t in types)

    def binary(self, cursor, left, right):
        between = self.text[left.extent.end.offset:right.extent.start.offset].strip()
        if between == "+" and re.search(r'"|to_string', self.of(cursor)):
            return  # strings have no other operator
        if between in OPERATORS:
            self.replace(cursor, f"{self.of(left)} {OPERATORS[between]} {self.of(right)}")

    def call(self, cursor, children):
        text = self.of(cursor)
        match = re.match(r"\(?(?:std|CGAL)::(min|max)\b", text)
        if match:
            other = {"min": "max", "max": "min"}[match.group(1)]
            self.replace(cursor, text[:match.start(1)] + other + text[match.end(1):])
        elif len(children) == 3 and cursor.spelling and not cursor.spelling.startswith("operator"):
            a, b = children[1:]
            begin = cursor.extent.start.offset
            are_in_order = begin < a.extent.start.offset and a.extent.end.offset <= b.extent.start.offset
            if are_in_order and self.of(a) != self.of(b) and self.have_one_type(a, b):
                middle = self.text[a.extent.end.offset:b.extent.start.offset]
                self.replace(cursor, self.text[begin:a.extent.start.offset] + self.of(b) + middle + self.of(a)
                             + self.text[b.extent.end.offset:cursor.extent.end.offset])

    def expression(self, cursor, children):
        text = self.of(cursor)
        if cursor.kind == Kind.INTEGER_LITERAL and other_integer(text) and not self.is_template_argument(cursor):
            self.replace(cursor, other_integer(text))
        elif cursor.kind == Kind.FLOATING_LITERAL:
            self.replace(cursor, f"2 * {text}" if re.search(r"[1-9]", text.lower().split("e")[0]) else "1.0")
        elif cursor.kind in (Kind.UNARY_OPERATOR, Kind.CALL_EXPR) and re.match(r"!(?!=)", text):
            self.replace(cursor, text[1:])
        elif cursor.kind == Kind.BINARY_OPERATOR and len(children) == 2:
            self.binary(cursor, *children)
        elif cursor.kind == Kind.CALL_EXPR and len(children) == 3 and children[0].extent.end.offset <= \
                children[1].extent.start.offset and cursor.spelling.startswith("operator"):
            self.binary(cursor, children[0], children[2])
        elif cursor.kind == Kind.CALL_EXPR:
            self.call(cursor, children)

    def condition(self, cursor):
        if cursor.kind.is_expression():
            self.replace(cursor, "true" if self.of(cursor).startswith("!") else "false")

    def is_statement(self, cursor):
        text = self.of(cursor)
        if cursor.kind in (Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR):
            return re.search(r"[^=<>!]=[^=]", text) is not None
        if cursor.kind == Kind.UNARY_OPERATOR:
            return "++" in text or "--" in text
        return cursor.kind == Kind.CALL_EXPR and not re.fullmatch(r"operator([!=<>]=|<|>)", cursor.spelling)

    def statements(self, cursor, children):
        first = 0 if cursor.kind == Kind.COMPOUND_STMT else 1
        for child in children[first:]:
            end = child.extent.end.offset
            if self.is_statement(child) and self.text[end:end + 40].lstrip().startswith(";"):
                self.add(child.extent.start.offset, end, "drop", "")

    def walk(self, cursor, owner):
        outer = self.function
        head = self.text[cursor.extent.start.offset:cursor.extent.start.offset + 400]
        if cursor.kind in AT_COMPILE_TIME:
            return
        if cursor.kind in CLASSES:
            owner = cursor.spelling
        elif cursor.kind in FUNCTIONS:
            if re.match(r"(template\s*<[^{]*?>\s*)?[\w\s:]*\bconstexpr\b", head):
                return
            name = cursor.spelling.split("<")[0]
            self.function = f"{owner}::{name}" if owner else name
        elif cursor.kind == Kind.VAR_DECL and re.match(r"[\w\s]*\bconstexpr\b", head):
            return
        children = list(cursor.get_children())
        if self.function:
            self.expression(cursor, children)
            if cursor.kind in BODIES:
                self.statements(cursor, children)
            if cursor.kind == Kind.IF_STMT and children:
                if re.match(r"if\s+constexpr", head):
                    children = children[1:]
                else:
                    self.condition(children[0])
            if cursor.kind == Kind.CASE_STMT:
                children = children[1:]
        for child in children:
            self.walk(child, owner)
        self.function = outer


def parse(include):
    names = sorted(os.path.relpath(os.path.join(folder, name), include) for folder, _, files in os.walk(include)
                   for name in files if name.endswith(".h"))
    source = "".join(f"#include <{name}>\n" for name in names)
    resources = subprocess.run(["clang++", "-print-resource-dir"], stdout=subprocess.PIPE, universal_newlines=True,
                               check=True).stdout.strip()
    arguments = ["-std=c++17", "-w", "-frounding-math", "-I", include, "-resource-dir", resources,
                 "-isystem", "/usr/include/eigen3"]
    options = cindex.TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD
    unit = cindex.Index.create().parse("all_headers.cpp", arguments, [("all_headers.cpp", source)], options)
    errors = [d for d in unit.diagnostics if d.severity >= cindex.Diagnostic.Error]
    if errors:
        raise RuntimeError(f"clang does not parse the headers: {errors[0]}")
    return unit


def readers_of(unit, include):
    """A reader for each header, and the cursors at its top."""
    readers, tops, macros = {}, collections.defaultdict(list), collections.defaultdict(list)
    package = os.path.join(include, HEADERS)

    def header_of(cursor):
        file = cursor.location.file
        return file.name[len(package):] if file and file.name.startswith(package) else None

    def collect(cursor):
        for child in cursor.get_children():
            header = header_of(child)
            if header is None:
                continue
            if child.kind == Kind.MACRO_INSTANTIATION:
                macros[header].append((child.extent.start.offset, child.extent.end.offset))
            elif child.kind == Kind.NAMESPACE:
                collect(child)
            elif not child.kind.is_preprocessing():
                tops[header].append(child)

    collect(unit.cursor)
    for header in tops:
        with open(package + header, encoding="utf-8") as file:
            readers[header] = Reader(header, file.read(), sorted(macros[header]))
    return readers, tops


def numbered(reader):
    """The reader's findings as mutants, each once, in the order of the text."""
    counts = collections.Counter()
    for function, begin, end, kind, replacement in sorted(set(reader.found), key=lambda f: (f[1], f[2], f[3], f[4])):
        original = reader.text[begin:end]
        key = (function, kind, squeezed(original), squeezed(replacement))
        yield Mutant(reader.header, module_of(reader.header), function, begin, end, kind, original, replacement,
                     counts[key])
        counts[key] += 1


def mutants_of(include):
    """All mutants of the headers below `include`; some do not compile. Takes as long as compiling all headers."""
    readers, tops = readers_of(parse(include), include)
    result = []
    for header in sorted(readers):
        for cursor in tops[header]:
            readers[header].walk(cursor, "")
        result += numbered(readers[header])
    return result
