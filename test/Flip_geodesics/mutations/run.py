#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Would the tests miss a wrong line?  Applies the mutations of mutations.txt one at a time and runs the tests.

  python3 test/Flip_geodesics/mutations/run.py --build DIR                 all of it: hours
  python3 test/Flip_geodesics/mutations/run.py --build DIR --shard 0/4     a quarter of the mutations
  python3 test/Flip_geodesics/mutations/run.py --build DIR --tests test_certify,test_extract --header Strip
  python3 test/Flip_geodesics/mutations/run.py --build DIR --table         what is known so far
  python3 test/Flip_geodesics/mutations/run.py --build DIR --record        the same, into results.csv beside the list
  python3 test/Flip_geodesics/mutations/run.py --check                     is the list up to date?
  python3 test/Flip_geodesics/mutations/run.py --parse                     does clang++ understand it? half a minute

To compile each test program once and not once per mutation, all mutations are put into one copy of the headers: an
expression E with a mutation M becomes (::mutation::is_active(17) ? (M) : (E)), a statement S that is dropped becomes
if(::mutation::is_active(17)) {} else S, and an environment variable says which mutation is active. A first run without
any tells which test cases reach which mutations, and how long they take; a mutation is then run in the cases that reach
it, the fastest program first, until a check fails, the program crashes, or it takes five times as long: it is killed.
What cannot be decided while running (constants, types) has the word `alone` in the list, with the programs to try: it
is put into a copy of its own and compiled.

Results are appended to DIR/results.csv, and a second run goes on where the first one ended, or where results.csv beside
the list does. What was killed stays killed as long as its texts stay the same; what survived is run again with --again,
and with programs not yet tried.

The list has a section per header. An entry is

  17                      a number that no other entry has; then nothing, or `drop`, or `statement`, or `alone test_x`
  - if(@a < b@ && c)      text of the header, which occurs there once (white space does not count); what is mutated
                          stands between @ and @, or is all of it
  + a <= b                what stands there instead; may lack for `drop`
  = equivalent: why       why it survives: `equivalent: ...` or `guard: test program and case`
"""

import argparse
import collections
import csv
import hashlib
import os
import re
import resource
import shlex
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
TESTS = os.path.dirname(HERE)
ROOT = os.path.dirname(os.path.dirname(TESTS))
HEADERS = "CGAL/Flip_geodesics/"

# Found out for each program while it runs; ends it at the first check that fails while a mutation is active.
SWITCH = r"""#ifndef MUTATION_SWITCH_H
#define MUTATION_SWITCH_H
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost_mp.h>
#include <CGAL/boost/graph/helpers.h>
#include <boost/multiprecision/mpfr.hpp>
#include <cstdlib>
namespace mutation {
inline const int active = std::getenv("MUTATION") ? std::atoi(std::getenv("MUTATION")) : 0;
inline unsigned char reached[100000] = {};
inline bool is_active(int i)
{
  reached[i] = 1;
  return i == active;
}
} // namespace mutation
#endif
"""

OBSERVER = r"""
#include <boost/test/unit_test.hpp>
#include <boost/test/tree/observer.hpp>
#include <boost/test/tree/traverse.hpp>
#include <boost/test/tree/visitor.hpp>
#include <boost/test/framework.hpp>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <set>
#include <sstream>
#include <unistd.h>
namespace ut = boost::unit_test;
namespace {
struct Observer : ut::test_observer
{
  int number = -1; // of the test case
  std::clock_t start = 0;
  void test_unit_start(const ut::test_unit& unit) override
  {
    if(unit.p_type != ut::TUT_CASE)
      return;
    number = static_cast<int>(unit.p_id.get() & 0xffff);
    std::fill(std::begin(mutation::reached), std::end(mutation::reached), 0);
    start = std::clock();
  }
  void test_unit_finish(const ut::test_unit& unit, unsigned long) override
  {
    const char* name = std::getenv("MUTATION_COVERAGE");
    if(unit.p_type != ut::TUT_CASE || !name)
      return;
    std::ofstream out(name, std::ios::app);
    out << number << '\t' << unit.full_name() << '\t' << double(std::clock() - start) / CLOCKS_PER_SEC << '\t';
    for(int i = 0; i < 100000; ++i)
      if(mutation::reached[i])
        out << i << ' ';
    out << std::endl;
  }
  void fail(const char* how)
  {
    if(!mutation::active)
      return;
    std::fprintf(stderr, "MUTATION KILLED %s in %s\n", how, ut::framework::current_test_case().full_name().c_str());
    _exit(3);
  }
  void assertion_result(ut::assertion_result r) override { if(r == ut::AR_FAILED) fail("by a check"); }
  void exception_caught(const boost::execution_exception&) override { fail("by an exception"); }
  int priority() override { return 10; }
};
struct Disable : ut::test_tree_visitor
{
  std::set<int> kept;
  void visit(const ut::test_case& c) override
  {
    if(!kept.count(static_cast<int>(c.p_id.get() & 0xffff)))
      const_cast<ut::test_case&>(c).p_run_status.value = ut::test_unit::RS_DISABLED;
  }
};
struct Setup
{
  static Observer& observer()
  {
    static Observer result;
    return result;
  }
  void setup()
  {
    ut::framework::register_observer(observer());
    if(const char* cases = std::getenv("MUTATION_CASES")) {
      Disable disable;
      std::istringstream in(cases);
      for(int i; in >> i;)
        disable.kept.insert(i);
      ut::traverse_test_tree(ut::framework::master_test_suite().p_id, disable, true);
    }
  }
  void teardown() { ut::framework::deregister_observer(observer()); }
};
} // namespace
BOOST_TEST_GLOBAL_FIXTURE(Setup);
"""

Entry = collections.namedtuple("Entry", "number kind tests header original replacement explanation digest line")


def fail(message):
    print("run.py: " + message, file=sys.stderr)
    sys.exit(2)


# ---------------------------------------------------------------- the list


def digest_of(header, kind, original, replacement):
    """What a result is known by, wherever its header moves to."""
    texts = (os.path.basename(header), kind, original, replacement)
    return hashlib.sha1("\0".join(texts).encode()).hexdigest()[:12]


def read_list(name):
    entries, header = [], None
    lines = open(name, encoding="utf-8").read().split("\n")
    i = 0
    while i < len(lines):
        line = lines[i].strip()
        if not line or line.startswith("#"):
            i += 1
            continue
        match = re.fullmatch(r"\[(.*)\]", line)
        if match:
            header = match.group(1)
            i += 1
            continue
        words = line.split()
        if header is None or not words[0].isdigit():
            fail(f"{name}:{i + 1}: a number, and before it a [header], expected: {line}")
        start, parts = i + 1, {"-": [], "+": [], "=": []}
        i += 1
        while i < len(lines) and lines[i][:1] in parts and lines[i].strip():
            parts[lines[i][0]].append(lines[i][1:].strip())
            i += 1
        original, replacement = "\n".join(parts["-"]), "\n".join(parts["+"])
        kind = words[1] if len(words) > 1 else "expression"
        if kind not in ("expression", "drop", "statement", "alone") or not original:
            fail(f"{name}:{start}: a kind and the lines of an entry expected")
        digest = digest_of(header, kind, original, replacement)
        entries.append(Entry(int(words[0]), kind, words[2:], header, original, replacement, " ".join(parts["="]), digest,
                             start))
    numbers = collections.Counter(e.number for e in entries)
    twice = [str(n) for n, count in numbers.items() if count > 1]
    if twice:
        fail("numbers that occur twice: " + " ".join(twice))
    return entries


TOKEN = r"[A-Za-z0-9_.]+|\S"


def pattern(text):
    """Any white space may stand between two tokens."""
    return r"\s*".join(re.escape(token) for token in re.findall(TOKEN, text))


def locate(entry, text):
    """The range of the mutated part, or a message."""
    parts = entry.original.split("@")
    if len(parts) not in (1, 3):
        return None, "one pair of @ expected"
    before, part, after = parts if len(parts) == 3 else ("", parts[0], "")
    whole = (r"(?<!\w)" if re.match(r"\w", entry.original) else "") + pattern(before)
    whole += r"\s*(" + pattern(part) + r")\s*" + pattern(after)
    found = list(re.finditer(whole, text))
    if len(found) != 1:
        return None, "its text is no longer in the header" if not found else f"its text occurs {len(found)} times"
    return found[0].span(1), None


def locate_all(entries, include):
    """Entry number to range; says which entries are stale."""
    ranges, stale, texts = {}, [], {}
    for e in entries:
        path = os.path.join(include, HEADERS, e.header)
        if e.header not in texts:
            texts[e.header] = open(path, encoding="utf-8").read() if os.path.exists(path) else None
        if texts[e.header] is None:
            stale.append((e, "there is no such header"))
            continue
        where, message = locate(e, texts[e.header])
        if message:
            stale.append((e, message))
        else:
            ranges[e.number] = where
    for e, message in stale:
        print(f"STALE: mutation {e.number} (line {e.line}) of {e.header}: {message}: {e.original}", file=sys.stderr)
    return ranges, stale


# ---------------------------------------------------------------- the copies


def wrapped(entry, text):
    """A mutation and what it replaces, as one piece of code."""
    condition = f"::mutation::is_active({entry.number})"
    if entry.kind == "expression":
        return f"({condition} ? ({entry.replacement}) : ({text}))"
    mutated = entry.replacement if entry.kind == "statement" else ""
    return f"if({condition}) {{ {mutated} }} else {text}"


def with_all(text, entries, ranges):
    """The text with all mutations, of which one may lie inside of another."""
    order = sorted(entries, key=lambda e: (ranges[e.number][0], -ranges[e.number][1], e.kind == "expression"))

    def rendered(begin, end, inside):
        result, position = "", begin
        while inside:
            first = inside[0]
            a, b = ranges[first.number]
            nested = [e for e in inside[1:] if ranges[e.number][0] < b]
            for e in nested:
                if ranges[e.number][1] > b:
                    fail(f"mutations {first.number} and {e.number} of {first.header} overlap")
            result += text[position:a] + wrapped(first, rendered(a, b, nested))
            position = b
            inside = inside[1 + len(nested):]
        return result + text[position:end]

    return rendered(0, len(text), order)


def write_if_changed(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    if os.path.exists(path) and open(path, encoding="utf-8").read() == text:
        return
    with open(path, "w", encoding="utf-8") as out:
        out.write(text)


def copy_headers(include, target, change):
    """Copies the tree of headers; `change(header, text)` is what is written."""
    for folder, _, names in os.walk(include):
        for name in names:
            path = os.path.join(folder, name)
            relative = os.path.relpath(path, include)
            text = open(path, encoding="utf-8").read()
            header = relative[len(HEADERS):] if relative.startswith(HEADERS) else relative
            write_if_changed(os.path.join(target, relative), change(header, text))


def copy_with_all(include, tree, entries, ranges):
    """Copies the headers, with all mutations that are decided while running, to the folder `tree`, and returns that."""
    per_header = collections.defaultdict(list)
    for e in entries:
        if e.kind != "alone" and e.number in ranges:
            per_header[e.header].append(e)
    copy_headers(include, tree,
                 lambda header, text: with_all(text, per_header[header], ranges) if header in per_header else text)
    return tree


# ---------------------------------------------------------------- compiling


def files_of(test):
    """A test is one source, and the sources and headers in a folder of its name if there is one."""
    folder = os.path.join(TESTS, test)
    parts = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
    return [folder + ".cpp"] + [os.path.join(folder, n) for n in parts]


class Compiler:
    def __init__(self, options, build):
        self.build = build
        self.base = shlex.split(options.compiler) + shlex.split(options.flags)
        write_if_changed(os.path.join(build, "switch.h"), SWITCH)
        write_if_changed(os.path.join(build, "observer.cpp"), OBSERVER)

    def is_newer(self, target, depfile):
        """Is the target newer than all that it was made from?"""
        if not os.path.exists(target) or not os.path.exists(depfile):
            return False
        names = open(depfile).read().replace("\\\n", " ").split(":", 1)[1].split()
        made = os.path.getmtime(target)
        return all(os.path.exists(n) and os.path.getmtime(n) <= made for n in names)

    def make(self, target, source, arguments, log):
        depfile = target + ".d"
        if self.is_newer(target, depfile):
            return True
        command = self.base + arguments + ["-MD", "-MF", depfile, "-o", target, source]
        with open(log, "w") as out:
            out.write(" ".join(command) + "\n")
            out.flush()
            result = subprocess.run(command, stdout=out, stderr=out, check=False)
        return result.returncode == 0

    def precompile(self):
        header = os.path.join(self.build, "switch.h")
        if not self.make(header + ".gch", header, ["-x", "c++-header"], os.path.join(self.build, "switch.log")):
            fail(f"switch.h does not compile, see {self.build}/switch.log")
        observer = os.path.join(self.build, "observer.o")
        if not self.make(observer, os.path.join(self.build, "observer.cpp"), ["-c", "-include", header],
                         os.path.join(self.build, "observer.log")):
            fail(f"observer.cpp does not compile, see {self.build}/observer.log")
        return observer

    def program(self, test, include, folder):
        """Compiles and links a test with the headers in `include`; its path, or none."""
        os.makedirs(folder, exist_ok=True)
        observer, files = self.precompile(), files_of(test)
        text = "".join(open(name, encoding="utf-8").read() for name in files)
        arguments = ["-c", "-I", include, "-I", TESTS, "-I", os.path.join(ROOT, "benchmark", "Flip_geodesics")]
        libraries = ["-lboost_unit_test_framework", "-lmpfr", "-lgmp"]
        if "FLIP_GEODESICS_RECORDED_RESULTS" in text:
            recorded = os.path.join(TESTS, "recorded_results.txt")
            arguments.append(f'-DFLIP_GEODESICS_RECORDED_RESULTS="{recorded}"')
        if "EIGEN3_ENABLED" in text or "<Eigen/" in text:
            arguments += ["-I", "/usr/include/eigen3", "-DCGAL_EIGEN3_ENABLED", "-DEIGEN_MAX_ALIGN_BYTES=16"]
        elif "LINKED_WITH_TBB" in text or "Parallel_tag" in text:
            arguments += ["-DCGAL_LINKED_WITH_TBB", "-pthread"]
            libraries += ["-ltbb", "-pthread"]
        else:
            arguments += ["-include", os.path.join(self.build, "switch.h")]
        if arguments[-2] != "-include": # other macros, other precompiled headers
            arguments += ["-include", self.plain_switch()]
        target = os.path.join(folder, test + ".o")
        log = os.path.join(folder, test + ".log")
        together = os.path.join(folder, test + ".cpp")
        write_if_changed(together, "".join(f'#include "{name}"\n' for name in files if name.endswith(".cpp")))
        if not self.make(target, together, arguments, log):
            return None
        program = os.path.join(folder, test)
        if not os.path.exists(program) or os.path.getmtime(program) < os.path.getmtime(target):
            command = self.base[:1] + ["-o", program, target, observer] + libraries
            with open(log, "a") as out:
                if subprocess.run(command, stdout=out, stderr=out, check=False).returncode != 0:
                    return None
        return program

    def plain_switch(self):
        name = os.path.join(self.build, "plain", "switch.h")
        write_if_changed(name, SWITCH)
        return name


def parse(include, entries, ranges):
    """Do all mutations parse, with names that are known where templates are read? clang++ looks at them together, in one
    source with all headers, and goes on after errors. Prints what does not parse; entries `alone` are not looked at."""
    with tempfile.TemporaryDirectory() as build:
        tree = copy_with_all(include, os.path.join(build, "include"), entries, ranges)
        write_if_changed(os.path.join(build, "switch.h"), SWITCH)
        headers = sorted(os.path.relpath(os.path.join(folder, name), tree) for folder, _, names in os.walk(tree)
                         for name in names if name.endswith(".h"))
        source = os.path.join(build, "all.cpp")
        write_if_changed(source, "".join(f"#include <{header}>\n" for header in headers))
        command = ["clang++", "-std=c++17", "-fsyntax-only", "-w", "-frounding-math", "-ferror-limit=0", "-I", tree,
                   "-isystem", "/usr/include/eigen3", "-include", os.path.join(build, "switch.h"), source]
        try:
            result = subprocess.run(command, stderr=subprocess.PIPE, universal_newlines=True, check=False)
        except FileNotFoundError:
            fail("--parse needs clang++")
        for name, line, message in re.findall(r"^(.*):(\d+):\d+: (?:fatal )?error: (.*)$", result.stderr, re.M):
            text = open(name, encoding="utf-8").read().split("\n")[int(line) - 1]
            numbers = re.findall(r"::mutation::is_active\((\d+)\)", text)
            print(f"DOES NOT PARSE: {' or '.join(numbers) or 'mutations'} of {os.path.relpath(name, tree)}: {message}")
        print("all headers with all mutations parse" if result.returncode == 0 else "some mutations do not parse")
        return result.returncode == 0


# ---------------------------------------------------------------- running


def run(program, environment, seconds, memory):
    """Exit code and what was written to standard error; a time limit of the processor, and a longer one of the clock."""

    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (int(seconds) + 1, int(seconds) + 2))
        resource.setrlimit(resource.RLIMIT_AS, (memory << 20, memory << 20))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    environment = dict(os.environ, **environment)
    with tempfile.TemporaryFile() as out:
        try:
            code = subprocess.run([program, "--log_level=nothing", "--report_level=no", "--catch_system_errors=yes"],
                                  env=environment, preexec_fn=limit, timeout=20 * seconds + 60, check=False,
                                  stdout=subprocess.DEVNULL, stderr=out, cwd=os.path.dirname(program)).returncode
        except subprocess.TimeoutExpired:
            code = -1
        out.seek(0)
        return code, out.read()[-20000:].decode("utf-8", "replace")


class Coverage:
    """Which cases of a program reach which mutations, and their times."""

    def __init__(self, program, memory):
        name = program + ".coverage"
        if not os.path.exists(name) or os.path.getmtime(name) < os.path.getmtime(program):
            if os.path.exists(name):
                os.remove(name)
            code, text = run(program, {"MUTATION": "0", "MUTATION_COVERAGE": name}, 3600, memory)
            if code != 0:
                if os.path.exists(name):
                    os.remove(name)
                fail(f"{program} fails without any mutation (exit code {code}): {text[-2000:]}")
        self.cases = {}
        for line in open(name, encoding="utf-8"):
            number, _, seconds, reached = line.rstrip("\n").split("\t")
            self.cases[int(number)] = (float(seconds), {int(i) for i in reached.split()})

    def reaching(self, mutation):
        """Cases, and their time."""
        cases = [n for n, (_, reached) in self.cases.items() if mutation in reached]
        return cases, sum(self.cases[n][0] for n in cases)


def verdict_of(program, mutation, cases, seconds, memory):
    """None if the mutation survives, or what killed it."""
    environment = {"MUTATION": str(mutation)}
    if cases is not None:
        environment["MUTATION_CASES"] = " ".join(map(str, cases))
    code, text = run(program, environment, 5 * seconds + 2, memory)
    if code == 0:
        return None
    match = re.search(r"MUTATION KILLED (.*)", text)
    return match.group(1) if match else ("a time limit" if code in (-1, -24, -9) else f"exit code {code}")


class Results:
    def __init__(self, recorded, name):
        """Begins with the file `recorded`, goes on with the file `name`, and appends to that."""
        self.name, self.rows = name, {}
        for known in filter(os.path.exists, (recorded, name)):
            with open(known, newline="", encoding="utf-8") as file:
                for row in csv.reader(file):
                    if len(row) == 5 and row[0] != "number":
                        self.add(row)

    def record(self, entries, name):
        """Writes what is known of entries, a line each."""
        with open(name, "w", newline="", encoding="utf-8") as out:
            writer = csv.writer(out, lineterminator="\n")
            writer.writerow(["number", "texts", "verdict", "tests", "how"])
            for row in filter(None, map(self.of, sorted(entries, key=lambda e: e.number))):
                writer.writerow([*row[:4], row[4].split("<")[0]])

    def add(self, row):
        key = (int(row[0]), row[1])
        old = self.rows.get(key)
        if old is None or old[2] != "killed":
            tried = set(row[3].split()) | (set(old[3].split()) if old and row[2] == "survived" else set())
            self.rows[key] = [row[0], row[1], row[2], " ".join(sorted(tried)), row[4]]

    def append(self, entry, verdict, tests, how):
        row = [str(entry.number), entry.digest, verdict, " ".join(tests), how]
        with open(self.name, "a", newline="", encoding="utf-8") as out:
            csv.writer(out).writerow(row)
        self.add(row)

    def of(self, entry):
        return self.rows.get((entry.number, entry.digest))


def run_schemata(entries, programs, results, options):
    """`programs`: test to path, which all contain all mutations."""
    coverage = {test: Coverage(path, options.memory) for test, path in programs.items()}
    for e in entries:
        old = results.of(e)
        if old and old[2] == "killed":
            continue
        tried = set(old[3].split()) if old and old[2] == "survived" and not options.again else set()
        order = sorted((coverage[t].reaching(e.number)[1], t) for t in programs
                       if t not in tried and coverage[t].reaching(e.number)[0])
        if not order and not old:
            print(f"{e.number} {e.header}: no test of those compiled reaches it", flush=True)
            results.append(e, "survived", [], "not reached")
        for position, (seconds, test) in enumerate(order):
            start = time.time()
            how = verdict_of(programs[test], e.number, coverage[test].reaching(e.number)[0], seconds, options.memory)
            if how:
                results.append(e, "killed", [test], how)
                print(f"{e.number} {e.header}: killed by {test}, {how}, {time.time() - start:.1f} s", flush=True)
                break
            results.append(e, "survived", [test], "")
            if position + 1 == len(order):
                print(f"{e.number} {e.header}: SURVIVED {' '.join(t for _, t in order)}", flush=True)


def run_alone(entries, ranges, include, compiler, results, options):
    for e in entries:
        old = results.of(e)
        if old and (old[2] == "killed" or not options.again):
            continue
        a, b = ranges[e.number]
        tree = os.path.join(compiler.build, "alone", "include")
        copy_headers(include, tree,
                     lambda header, text, e=e, a=a, b=b: text[:a] + e.replacement + text[b:] if header == e.header else text)
        verdict = ("survived", " ".join(e.tests))
        for test in e.tests:
            program = compiler.program(test, tree, os.path.join(compiler.build, "alone"))
            if program is None:
                verdict = ("killed", "does not compile")
                break
            how = verdict_of(program, e.number, None, 60, options.memory)
            if how:
                verdict = ("killed", how)
                break
        results.append(e, verdict[0], [test], verdict[1])
        print(f"{e.number} {e.header}: {verdict[0]} {verdict[1]}", flush=True)


# ---------------------------------------------------------------- what is printed


def print_table(entries, results):
    rows = collections.OrderedDict()
    for e in sorted(entries, key=lambda e: e.header):
        row, result = rows.setdefault(e.header, [0, 0, 0, 0, 0]), results.of(e)
        row[0] += 1
        if result is None:
            row[4] += 1
        elif result[2] == "killed":
            row[1] += 1
        else:
            row[2] += 1
            row[3] += 1 if e.explanation else 0
    width = max(len(header) for header in rows) + 2
    print(f"{'header':{width}}{'mutations':>10}{'killed':>8}{'survived':>10}{'explained':>11}{'not run':>9}")
    for header, row in list(rows.items()) + [("all", [sum(c) for c in zip(*rows.values())])]:
        print(f"{header:{width}}{row[0]:>10}{row[1]:>8}{row[2]:>10}{row[3]:>11}{row[4]:>9}")
    for e in entries:
        result = results.of(e)
        if result and result[2] == "survived" and not e.explanation:
            print(f"survived, unexplained: {e.number} {e.header}: {e.original} -> {e.replacement or 'nothing'}"
                  f" ({result[3] or result[4]})")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", help="a folder for copies, programs and results.csv")
    parser.add_argument("--list", default=os.path.join(HERE, "mutations.txt"))
    parser.add_argument("--include", default=os.path.join(ROOT, "include"))
    parser.add_argument("--tests", default="", help="programs, with commas; all if there are none")
    parser.add_argument("--header", default="", help="only headers whose names contain this")
    parser.add_argument("--only", default="", help="numbers, with commas")
    parser.add_argument("--shard", default="0/1", help="i/n: every n-th entry, from the i-th on")
    parser.add_argument("--again", action="store_true", help="what survived is run again")
    parser.add_argument("--check", action="store_true", help="only checks the list against the headers")
    parser.add_argument("--parse", action="store_true", help="only checks list and syntax of mutations, by clang++")
    parser.add_argument("--table", action="store_true", help="only prints the table")
    parser.add_argument("--record", action="store_true", help="only writes what is known beside the list")
    parser.add_argument("--skip-alone", action="store_true", help="without those that are compiled by themselves")
    parser.add_argument("--compiler", default="g++")
    parser.add_argument("--flags", default="-std=c++17 -O1 -w -frounding-math -DBOOST_TEST_DYN_LINK")
    parser.add_argument("--memory", type=int, default=4000, help="megabytes for a test program")
    return parser.parse_args()


def chosen(entries, options):
    shard, shards = map(int, options.shard.split("/"))
    only = {int(n) for n in options.only.split(",") if n}
    return [e for i, e in enumerate(entries) if i % shards == shard and options.header in e.header
            and (not only or e.number in only)]


def main():
    options = arguments()
    entries = read_list(options.list)
    ranges, stale = locate_all(entries, options.include)
    print(f"{len(entries)} mutations of {len({e.header for e in entries})} headers, {len(stale)} stale")
    if options.check or options.parse:
        parses = not options.parse or parse(options.include, entries, ranges)
        sys.exit(1 if stale or not parses else 0)
    if not options.build:
        fail("--build is missing")
    build = os.path.abspath(options.build)
    os.makedirs(build, exist_ok=True)
    recorded = os.path.join(HERE, "results.csv")
    results = Results(recorded, os.path.join(build, "results.csv"))
    if options.record:
        results.record(entries, recorded)
    if options.table or options.record:
        print_table(entries, results)
        sys.exit(1 if stale else 0)

    fresh = [e for e in entries if e.number in ranges]
    tree = copy_with_all(options.include, os.path.join(build, "include"), fresh, ranges)
    compiler = Compiler(options, build)
    names = sorted(n[:-4] for n in os.listdir(TESTS) if n.startswith("test_") and n.endswith(".cpp"))
    programs = {}
    for test in options.tests.split(",") if options.tests else names:
        start = time.time()
        path = compiler.program(test, tree, os.path.join(build, "programs"))
        if path is None:
            fail(f"{test} does not compile with the mutations, see {build}/programs/{test}.log")
        if time.time() - start > 1:
            print(f"{test}: compiled in {time.time() - start:.0f} s", flush=True)
        programs[test] = path
    selected = chosen(fresh, options)
    run_schemata([e for e in selected if e.kind != "alone"], programs, results, options)
    if not options.skip_alone:
        run_alone([e for e in selected if e.kind == "alone"], ranges, options.include, compiler, results, options)
    print_table(entries, results)
    sys.exit(1 if stale else 0)


if __name__ == "__main__":
    main()
