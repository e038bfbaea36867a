#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Would the tests notice a wrong operator?  Generates mutants of the headers and runs the tests on each.

  python3 test/Flip_geodesics/mutations/run.py --build DIR                          20 mutants of each module: an hour
  python3 test/Flip_geodesics/mutations/run.py --build DIR --seed 7 --number 5      5 others of each module
  python3 test/Flip_geodesics/mutations/run.py --build DIR --module unfolding --tests test_certify,test_extract
  python3 test/Flip_geodesics/mutations/run.py --build DIR --header flip_out.h --number 50
  python3 test/Flip_geodesics/mutations/run.py --check                              are the explanations up to date?

generate.py finds all places where an operator, a constant, a condition, a call or a statement can be changed; the seed
draws the sample. To compile each test program once and not once per mutant, all mutants are put into one copy of the
headers: an expression E with a mutant M becomes (::mutation::is_active(17) ? (M) : (E)), a statement S that is dropped
becomes if(::mutation::is_active(17)) {} else S, and an environment variable selects the mutant. All headers are
precompiled, with the instances that tests share; mutants that do not compile there are replaced by the next of the
sample, and dropped if a test finds this. Then the tests are compiled and run one after the other, in the order of
--tests, each with the mutants that none before has killed. A first run of a program without any mutant records which
test cases reach which mutants and how long they take. A mutant is then run in the cases that reach it, the fastest
first as long as there is time for, until a check fails, the program crashes or it takes three times as long: it is
killed.

Results are appended to DIR/results.csv; a further run continues where the last one ended, and ends with a table of the
modules and the mutants that survive. These run again in tests that have changed. explanations.txt states why
mutants survive that are equivalent to the original, by function:

  [internal/flip_out/flip_out.h]
  Flip_out::shorten
  - a < b                 the original, with any white space
  + a <= b                the mutant
  = the two are never equal

Needs clang++, Boost.Test, and for Debian's python3 the packages python3-clang-14 and libclang-14-dev.
"""

import argparse
import collections
import csv
import hashlib
import json
import os
import random
import re
import resource
import shlex
import subprocess
import sys
import tempfile
import time

import generate
from generate import Mutant, digest, mutants_of, squeezed

HERE = os.path.dirname(os.path.abspath(__file__))
TESTS = os.path.dirname(HERE)
ROOT = os.path.dirname(os.path.dirname(TESTS))
HEADERS = generate.HEADERS

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

# Tests that compute for long, optimized; see CMakeLists.txt.
own_instances = {"test_distance_field", "test_edge_path_graph", "test_hostile_traits", "test_interruption",
                 "test_isolines"}

# In lines. A diagnostic farther behind a mutant is not due to it.
longest_expression = 20

Entry = collections.namedtuple("Entry", "number mutant digest")


def fail(message):
    print("run.py: " + message, file=sys.stderr)
    sys.exit(2)


# ---------------------------------------------------------------- the sample and the explanations


class Explanations:
    """Why mutants are equivalent to the original, by header, function and the two texts."""

    def __init__(self, name):
        self.reasons, header, function, original, replacement = {}, "", "", "", ""
        for line in open(name, encoding="utf-8") if os.path.exists(name) else []:
            line = line.strip()
            if line.startswith("["):
                header = line[1:-1]
            elif line.startswith("- "):
                original, replacement = squeezed(line[2:]), ""
            elif line.startswith("+ "):
                replacement = squeezed(line[2:])
            elif line.startswith("= "):
                self.reasons[header, function, original, replacement] = line[2:]
            elif line and not line.startswith("#"):
                function = line

    def of(self, mutant):
        key = (mutant.header, mutant.function, squeezed(mutant.original), squeezed(mutant.replacement))
        return self.reasons.get(key)

    def stale(self, mutants):
        """Explanations of mutants that the headers no longer have."""
        known = {(m.header, m.function, squeezed(m.original), squeezed(m.replacement)) for m in mutants}
        return [key for key in self.reasons if key not in known]


def all_mutants(include, build):
    """The mutants of the headers, kept in `build` as long as these stay the same."""
    paths = sorted(os.path.join(folder, name) for folder, _, names in os.walk(include) for name in names)
    state = hashlib.sha1(open(generate.__file__, "rb").read())
    for path in paths:
        state.update(path.encode() + open(path, "rb").read())
    cache = os.path.join(build, "mutants-" + state.hexdigest()[:12] + ".json")
    if not os.path.exists(cache):
        mutants = mutants_of(include)
        with open(cache, "w", encoding="utf-8") as out:
            json.dump(mutants, out)
        return mutants
    return [Mutant(*fields) for fields in json.load(open(cache, encoding="utf-8"))]


def overlaps(mutant, others):
    """Does a mutant share a part of its range with one that neither holds it nor lies within it?"""
    return any(o.header == mutant.header and (o.begin < mutant.begin < o.end < mutant.end
                                              or mutant.begin < o.begin < mutant.end < o.end) for o in others)


def drawn(mutants, number, seed):
    """The first `number` mutants of each module in random order, and the queues of the others. The order is one of
    hashes, so that a change of a header affects its own mutants only."""
    per_module = collections.defaultdict(list)
    for m in mutants:
        per_module[m.module].append(m)
    sample, reserve = [], {}
    for module in sorted(per_module):
        order = sorted(per_module[module], key=lambda m: hashlib.sha1(f"{seed} {digest(m)}".encode()).digest())
        chosen = []
        while order and len(chosen) < number:
            m = order.pop(0)
            if not overlaps(m, chosen):
                chosen.append(m)
        sample, reserve[module] = sample + chosen, order
    return sample, reserve


def entries_of(sample):
    return [Entry(i + 1, m, digest(m)) for i, m in enumerate(sample)]


# ---------------------------------------------------------------- the copies


def wrapped(entry, text):
    """A mutant and what it replaces, as one piece of code."""
    condition = f"::mutation::is_active({entry.number})"
    if entry.mutant.kind == "expression":
        return f"({condition} ? ({entry.mutant.replacement}) : ({text}))"
    return f"if({condition}) {{}} else {text}"


def with_all(text, entries):
    """The text with all mutants, of which one may lie inside of another."""
    order = sorted(entries, key=lambda e: (e.mutant.begin, -e.mutant.end, e.mutant.kind == "expression"))

    def rendered(begin, end, inside):
        result, position = "", begin
        while inside:
            first = inside[0]
            a, b = first.mutant.begin, first.mutant.end
            nested = [e for e in inside[1:] if e.mutant.begin < b]
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


def copy_with_all(include, tree, entries):
    """Copies the headers with all mutants to the folder `tree`, and returns that."""
    per_header = collections.defaultdict(list)
    for e in entries:
        per_header[e.mutant.header].append(e)
    copy_headers(include, tree,
                 lambda header, text: with_all(text, per_header[header]) if header in per_header else text)
    return tree


# ---------------------------------------------------------------- compiling


def files_of(test):
    """A test is one source, and the sources and headers in a folder of its name if there is one."""
    folder = os.path.join(TESTS, test)
    parts = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
    return [folder + ".cpp"] + [os.path.join(folder, n) for n in parts]


class Compiler:
    """Compiles tests with headers in which all mutants are. What most tests instantiate is compiled once, as by
    package_info/cmake/Flip_geodesics_shared_instances.cmake."""

    def __init__(self, options, build):
        self.build, self.tree = build, os.path.join(build, "include")
        self.base = shlex.split(options.compiler) + shlex.split(options.flags) + ["-I", self.tree]
        self.sample_key = ""
        os.makedirs(os.path.join(build, "programs"), exist_ok=True)
        write_if_changed(os.path.join(build, "switch.h"), SWITCH)
        write_if_changed(os.path.join(build, "observer.cpp"), OBSERVER)

    def is_newer(self, target, depfile):
        """Is the target newer than all that it was made from?"""
        if not os.path.exists(target) or not os.path.exists(depfile):
            return False
        names = open(depfile).read().replace("\\\n", " ").split(":", 1)[1].split()
        made = os.path.getmtime(target)
        return all(os.path.exists(n) and os.path.getmtime(n) <= made for n in names)

    def run(self, arguments, log):
        with open(log, "w") as out:
            out.write(shlex.join(self.base + arguments) + "\n")
            out.flush()
            return subprocess.run(self.base + arguments, stdout=out, stderr=out, check=False).returncode == 0

    def make(self, target, source, arguments, log):
        return self.is_newer(target, target + ".d") or self.run(
            arguments + ["-MD", "-MF", target + ".d", "-o", target, source], log)

    def share(self, keeps_code=False):
        """Precompiles all headers, with the instances that tests share. Returns the log if this fails. Code that has
        more mutants than the headers can be kept."""
        headers = sorted(os.path.relpath(os.path.join(folder, name), self.tree)
                         for folder, _, names in os.walk(self.tree) for name in names if name.endswith(".h"))
        instances = os.path.join(ROOT, "package_info", "cmake", "shared_instances.h")
        shared, log = os.path.join(self.build, "shared.h"), os.path.join(self.build, "shared.log")
        write_if_changed(shared, '#include "switch.h"\n' + "".join(f"#include <{header}>\n" for header in headers)
                         + f'#include "{instances}"\n')
        options = ["-O0", "-ferror-limit=0", "-isystem", "/usr/include/eigen3", "-x", "c++-header", "-Xclang",
                   "-emit-pch", "-fpch-instantiate-templates", "-Xclang", "-fmodules-codegen"]
        if not self.make(self.pch(), shared, options, log):
            return open(log, encoding="utf-8").read()
        code = self.object("shared")
        if keeps_code:
            os.utime(code)
        if not os.path.exists(code) or os.path.getmtime(code) < os.path.getmtime(self.pch()):
            if not self.run(["-O1", "-c", self.pch(), "-o", code], log):
                fail(f"no code can be made of the shared instances, see {log}")
        return ""

    def pch(self):
        return os.path.join(self.build, "shared.pch")

    def object(self, name):
        return os.path.join(self.build, name + ".o")

    def observer(self):
        if not self.make(self.object("observer"), os.path.join(self.build, "observer.cpp"),
                         ["-c", "-include", os.path.join(self.build, "switch.h")],
                         os.path.join(self.build, "observer.log")):
            fail(f"observer.cpp does not compile, see {self.build}/observer.log")
        return self.object("observer")

    def arguments_of(self, test, text):
        """Options of the compiler and libraries of a test whose sources hold this text."""
        arguments = ["-I", TESTS, "-I", os.path.join(ROOT, "benchmark", "Flip_geodesics")]
        libraries = ["-lboost_unit_test_framework", "-lmpfr", "-lgmpxx", "-lgmp"]
        switch = ["-include", os.path.join(self.build, "switch.h")]
        if test == "test_recorded_results":
            recorded = os.path.join(TESTS, "recorded_results.txt")
            return arguments + switch + ["-O1", "-DCGAL_DISABLE_GMP",
                                         f'-DFLIP_GEODESICS_RECORDED_RESULTS="{recorded}"'], libraries
        if test == "test_readers":
            program = os.path.join(ROOT, "examples", "Flip_geodesics_program")
            arguments += ["-I", program, f'-DFLIP_GEODESICS_CORPUS="{os.path.join(TESTS, "fuzz", "corpus")}"']
        if "EIGEN3_ENABLED" in text or "<Eigen/" in text:
            eigen = ["-isystem", "/usr/include/eigen3", "-DCGAL_EIGEN3_ENABLED", "-DEIGEN_MAX_ALIGN_BYTES=16"]
            return arguments + switch + ["-O0"] + eigen, libraries
        if "LINKED_WITH_TBB" in text or "Parallel_tag" in text:
            return arguments + switch + ["-O1", "-DCGAL_LINKED_WITH_TBB", "-pthread"], libraries + ["-ltbb", "-pthread"]
        if test in own_instances:
            return arguments + switch + ["-O1"], libraries
        return arguments + ["-O0", "-include-pch", self.pch()], [self.object("shared")] + libraries

    def state_of(self, files, arguments):
        """What a program depends on, but for mutants that are dropped: it may keep those."""
        files = files + [os.path.join(TESTS, n) for n in sorted(os.listdir(TESTS)) if n.endswith(".h")]
        texts = [open(name, encoding="utf-8").read() for name in files]
        return hashlib.sha1(repr((self.sample_key, self.base, arguments, texts)).encode()).hexdigest()

    def program(self, test):
        """Compiles and links a test; its path, or none."""
        files, program = files_of(test), os.path.join(self.build, "programs", test)
        arguments, libraries = self.arguments_of(test, "".join(open(n, encoding="utf-8").read() for n in files))
        state = self.state_of(files, arguments)
        if os.path.exists(program + ".state") and open(program + ".state").read() == state:
            return program
        together = program + ".cpp"
        write_if_changed(together, "".join(f'#include "{name}"\n' for name in files if name.endswith(".cpp")))
        if not self.run(["-c", together, "-o", program + ".o"] + arguments, program + ".log"):
            return None
        if not self.run(["-o", program, program + ".o", self.observer()] + libraries, program + ".link.log"):
            fail(f"{test} cannot be linked, see {program}.link.log")
        with open(program + ".state", "w") as out:
            out.write(state)
        return program


def mutants_at(diagnostics, kind, is_near=True):
    """The numbers of the mutants at lines of headers that diagnostics of this kind name, or in all of such headers. A
    mutant can begin on an earlier line."""
    numbers = set()
    for name, line in set(re.findall(r"^([^\s:]+\.h):(\d+):\d+: " + kind, diagnostics, re.M)):
        lines = open(name, encoding="utf-8").read().split("\n") if os.path.exists(name) else []
        for text in reversed(lines[:int(line)][-longest_expression:] if is_near else lines):
            found = re.findall(r"::mutation::is_active\((\d+)\)", text)
            numbers |= set(map(int, found))
            if found and is_near:
                break
    return numbers


def mutants_in(diagnostics):
    """The numbers of the mutants that a compiler objects to: in their own lines, in what these instantiate, or, where
    a compiler deduces a type and does not name its place, in the same headers."""
    errors, notes = "(?:fatal )?error: ", "(?:note: |  required)"
    return (mutants_at(diagnostics, errors) or mutants_at(diagnostics, notes)
            or mutants_at(diagnostics, errors, False) or mutants_at(diagnostics, notes, False))


def parsing_sample(include, sample, reserve, compiler, name):
    """The sample, with mutants that do not compile replaced by the next ones of their modules. The file `name` keeps
    those that do not."""
    known = set(open(name, encoding="utf-8").read().split()) if os.path.exists(name) else set()
    bad = {e.number for e in entries_of(sample) if e.digest in known}
    while True:
        entries = entries_of(sample)
        if not bad:
            copy_with_all(include, compiler.tree, entries)
            diagnostics = compiler.share()
            if not diagnostics:
                return entries
            bad = mutants_in(diagnostics)
            if not bad:
                fail(f"the headers with mutants do not compile, see {compiler.build}/shared.log")
            print(f"{len(bad)} mutants of the sample do not compile and are replaced", flush=True)
        known |= {e.digest for e in entries if e.number in bad}
        with open(name, "w", encoding="utf-8") as out:
            out.write("\n".join(sorted(known)) + "\n")
        sample = [e.mutant for e in entries if e.number not in bad]
        for e in entries:
            queue = reserve[e.mutant.module]
            while e.number in bad and queue:
                m = queue.pop(0)
                if digest(m) not in known and not overlaps(m, sample):
                    sample.append(m)
                    break
        bad = set()


class Sample:
    """The entries of a sample with their numbers, kept in a file so that programs stay valid in later runs."""

    def __init__(self, name, draw):
        self.name = name
        if os.path.exists(name):
            rows = json.load(open(name, encoding="utf-8"))
            mutants = [(number, Mutant(*fields)) for number, fields in rows]
            self.entries = [Entry(number, m, digest(m)) for number, m in mutants]
        else:
            self.entries = draw()
            self.write()

    def write(self):
        with open(self.name, "w", encoding="utf-8") as out:
            json.dump([(e.number, e.mutant) for e in self.entries], out)

    def drop(self, numbers):
        self.entries = [e for e in self.entries if e.number not in numbers]
        self.write()


# ---------------------------------------------------------------- running


def run(program, environment, seconds, memory):
    """Exit code and what was written to standard error; a limit of processor time, and a longer one of elapsed time."""

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

    def reaching(self, mutation, most):
        """Cases, the fastest ones first as long as they take less than `most` seconds together, and their time."""
        cases, total = [], 0
        for seconds, number in sorted((s, n) for n, (s, reached) in self.cases.items() if mutation in reached):
            if not cases or total + seconds <= most:
                cases.append(number)
                total += seconds
        return cases, total


def verdict_of(program, mutation, cases, seconds, memory):
    """None if the mutation survives, or what killed it."""
    environment = {"MUTATION": str(mutation)}
    if cases is not None:
        environment["MUTATION_CASES"] = " ".join(map(str, cases))
    code, text = run(program, environment, 3 * seconds + 2, memory)
    if code == 0:
        return None
    match = re.search(r"MUTATION KILLED (.*)", text)
    return match.group(1) if match else ("a time limit" if code in (-1, -24, -9) else f"exit code {code}")


class Results:
    """What is known of mutants: digest, verdict, tests that were run, how it was killed."""

    def __init__(self, name):
        self.name, self.rows = name, {}
        if os.path.exists(name):
            with open(name, newline="", encoding="utf-8") as file:
                for row in csv.reader(file):
                    self.add(row)

    def add(self, row):
        old = self.rows.get(row[0])
        if old is None or old[1] != "killed":
            tried = set(row[2].split()) | (set(old[2].split()) if old and row[1] == "survived" else set())
            self.rows[row[0]] = [row[0], row[1], " ".join(sorted(tried)), row[3]]

    def append(self, entry, verdict, tests, how):
        row = [entry.digest, verdict, " ".join(tests), how]
        with open(self.name, "a", newline="", encoding="utf-8") as out:
            csv.writer(out).writerow(row)
        self.add(row)

    def of(self, entry):
        return self.rows.get(entry.digest)


def run_entries(entries, test, program, results, options):
    """Runs those that no other test has killed in the cases of one test, unless it has run as it is now."""
    coverage = Coverage(program, options.memory)
    run = f"{test}@{open(program + '.state').read()[:8]}"
    for e in entries:
        old = results.of(e)
        cases, seconds = coverage.reaching(e.number, options.seconds)
        if not cases or (old and (old[1] == "killed" or run in old[2].split())):
            continue
        start = time.time()
        how = verdict_of(program, e.number, cases, seconds, options.memory)
        results.append(e, "killed" if how else "survived", [run], how or "")
        print(f"{e.number} {e.mutant.header}: {'killed ' + how if how else 'survives'}, {time.time() - start:.1f} s",
              flush=True)


# ---------------------------------------------------------------- what is printed


def state_of(entry, results, explanations):
    """Killed, equivalent, survived, or not reached."""
    result = results.of(entry)
    if result and result[1] == "killed":
        return 0
    if explanations.of(entry.mutant):
        return 1
    return 2 if result else 3


def print_table(entries, results, explanations):
    rows = collections.OrderedDict()
    for e in sorted(entries, key=lambda e: e.mutant.module):
        rows.setdefault(e.mutant.module, [0, 0, 0, 0])[state_of(e, results, explanations)] += 1
    width = max(len(module) for module in rows) + 2
    print(f"{'module':{width}}{'mutants':>9}{'killed':>8}{'equivalent':>12}{'survived':>10}{'not reached':>13}"
          f"{'killed':>9}")
    for module, row in list(rows.items()) + [("all", [sum(c) for c in zip(*rows.values())])]:
        share = 100 * row[0] / max(1, sum(row) - row[1])
        print(f"{module:{width}}{sum(row):>9}{row[0]:>8}{row[1]:>12}{row[2]:>10}{row[3]:>13}{share:>8.0f}%")
    for e in entries:
        if state_of(e, results, explanations) < 2:
            continue
        result = results.of(e)
        print(f"\n[{e.mutant.header}]\n{e.mutant.function}\n- {squeezed(e.mutant.original)}")
        if e.mutant.replacement:
            print(f"+ {squeezed(e.mutant.replacement)}")
        tests = sorted({t.split("@")[0] for t in result[2].split()}) if result else []
        print(f"  {e.number} survived {' '.join(tests)}" if result else f"  {e.number} not reached by the tests that ran")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", help="a folder for copies, programs and results.csv")
    parser.add_argument("--include", default=os.path.join(ROOT, "include"))
    parser.add_argument("--tests", default="", help="programs, with commas; all if there are none")
    parser.add_argument("--seed", default="1", help="draws the sample")
    parser.add_argument("--number", type=int, default=20, help="of mutants in each module")
    parser.add_argument("--module", default="", help="only this module, a folder of internal/, or public")
    parser.add_argument("--header", default="", help="only headers whose names contain this")
    parser.add_argument("--check", action="store_true", help="only compares the explanations with the headers")
    parser.add_argument("--compiler", default="clang++")
    parser.add_argument("--flags", default="-std=c++17 -w -frounding-math -ferror-limit=0 -DBOOST_TEST_DYN_LINK "
                        "-DFLIP_GEODESICS_TEST_ALL_CASES -D_GLIBCXX_ASSERTIONS")
    parser.add_argument("--seconds", type=float, default=20, help="for the cases of a test that reach a mutant")
    parser.add_argument("--memory", type=int, default=4000, help="megabytes for a test program")
    return parser.parse_args()


def compiled(test, include, sample, compiler):
    """The program with all mutants but those that do not compile, which are dropped."""
    while True:
        start = time.time()
        path = compiler.program(test)
        if path:
            print(f"{test}: compiled in {time.time() - start:.0f} s", flush=True)
            return path
        log = os.path.join(compiler.build, "programs", test + ".log")
        bad = mutants_in(open(log, encoding="utf-8").read())
        if not bad:
            fail(f"{test} does not compile with the mutants, see {log}")
        print(f"{test}: mutants {sorted(bad)} do not compile and are left out", flush=True)
        sample.drop(bad)
        copy_with_all(include, compiler.tree, sample.entries)
        compiler.share(keeps_code=True)


def main():
    options = arguments()
    if not options.build and not options.check:
        fail("--build is missing")
    with tempfile.TemporaryDirectory() as scratch:
        build = os.path.abspath(options.build or scratch)
        os.makedirs(build, exist_ok=True)
        mutants = all_mutants(os.path.abspath(options.include), build)
        explanations = Explanations(os.path.join(HERE, "explanations.txt"))
        stale = explanations.stale(mutants)
        for header, function, original, _ in stale:
            print(f"STALE: {header}, {function}: {original}", file=sys.stderr)
        print(f"{len(mutants)} mutants of {len({m.header for m in mutants})} headers, "
              f"{len(explanations.reasons)} explained, {len(stale)} explanations stale")
        if options.check:
            sys.exit(1 if stale else 0)
        mutants = [m for m in mutants if options.header in m.header and options.module in ("", m.module)]
        key = hashlib.sha1(repr((options.number, options.seed, mutants)).encode()).hexdigest()[:12]
        compiler = Compiler(options, build)
        sample = Sample(os.path.join(build, f"sample-{key}.json"), lambda: parsing_sample(
            options.include, *drawn(mutants, options.number, options.seed), compiler,
            os.path.join(build, "not_compiling.txt")))
        compiler.sample_key = key
        copy_with_all(options.include, compiler.tree, sample.entries)
        compiler.share()
        names = sorted(n[:-4] for n in os.listdir(TESTS) if n.startswith("test_") and n.endswith(".cpp"))
        results_file = os.path.join(build, "results.csv")
        for test in options.tests.split(",") if options.tests else names:
            program = compiled(test, options.include, sample, compiler)
            results = Results(results_file)  # another run may have added to it
            run_entries(sample.entries, test, program, results, options)
        print_table(sample.entries, Results(results_file), explanations)


if __name__ == "__main__":
    main()
