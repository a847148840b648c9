#!/usr/bin/env python3
"""Do the tests notice when the library is wrong?

Makes one small mistake at a time in a copy of a header: a comparison turned around or moved by its end, + for -, an abs
that is gone, a constant a little off. Compiles the test files that answer for the header against that copy, runs them, and
says whether they caught it, whether it survived, or whether it does not compile.

    tests/mutate/mutate.py --header shape/sphere.hpp             # every mistake that can be made in it
    tests/mutate/mutate.py --count 50 --seed 3                   # some of those of all headers below

A mistake that no test can catch, since it changes no answer, is listed with its reason in accepted.txt. The exit status is
1 if any other survives, or if nothing compiles.
"""

import argparse
import concurrent.futures
import os
import pathlib
import queue
import random
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
ACCEPTED = pathlib.Path(__file__).with_name("accepted.txt")

# Which shapes answer for a header beside the test of its name.
SHAPES = {
    "proof/settle.hpp": ["shape/sphere"],
    "proof/window.hpp": ["proof/settle", "proof/settle_lanes", "shape/sphere"],
    "proof/record.hpp": ["hit_record", "shape/sphere", "shape/box", "shape/teardrop"],
    "proof/settle_lanes.hpp": ["simd/shapes"],
    "proof/lanes.hpp": ["proof/settle_lanes", "shape/torus"],
    "formula/sphere.hpp": ["shape/sphere", "simd/shapes"],
    "proof/crossing.hpp": ["shape/cylinder", "shape/box"],
    "proof/chord.hpp": ["shape/cylinder", "shape/box", "shape/hyperboloid"],
    "formula/plane.hpp": ["shape/plane", "shape/disc"],
    "formula/edges.hpp": ["shape/triangle", "shape/parallelogram", "simd/shapes"],
    "formula/quadric.hpp": ["shape/cone", "shape/hyperboloid", "shape/two_sheet_hyperboloid", "shape/quadric"],
    "formula/axis.hpp": ["shape/cylinder", "shape/frustum", "shape/capsule", "shape/paraboloid", "shape/hyperboloid"],
    "proof/crossing_list.hpp": ["shape/torus"],
    "proof/polynomial_crossings.hpp": ["shape/algebraic", "shape/steiner"],
    "proof/line_part.hpp": ["shape/algebraic", "shape/steiner"],
    "proof/parabola.hpp": ["shape/quadric", "shape/hyperboloid"],
    "proof/normal.hpp": ["shape/cone", "shape/frustum", "shape/bilinear_patch"],
    "formula/revolution.hpp": ["shape/curved_surface_of_revolution"],
    "math/polynomial_roots.hpp": ["shape/torus"],
    "math/root_finder.hpp": ["math/polynomial_roots", "shape/torus"],
    "math/depressed_quartic.hpp": ["shape/torus"],
    "bvh/presplit.hpp": ["bvh/bvh"],
    "bvh/assemble.hpp": ["bvh/bvh"],
    "hit_record.hpp": ["shape/sphere"],
    "aabb.hpp": ["shape/disc"],
    "shape/surface_of_revolution.hpp": ["shape/curved_surface_of_revolution"],
    "formula/polyhedron_faces.hpp": ["shape/convex_polyhedron"],
    "shape/convex_polyhedron.hpp": ["simd/shapes"],
    "formula/sweep.hpp": ["shape/bezier_curve"],
}


def all_tests():
    """The tests that answer for each header."""
    headers = ROOT / "include/raio"
    names = sorted(path.relative_to(headers).with_suffix("").as_posix() for path in headers.rglob("*.hpp"))
    own = {f"{name}.hpp": [name] if (ROOT / "tests" / f"{name}.cpp").exists() else [] for name in names}
    tests = {header: tests + SHAPES.get(header, []) for header, tests in own.items()}
    return {header: tests for header, tests in tests.items() if tests}


TESTS = all_tests()

# What is written, and what it becomes. A space on both sides tells an operator from a template's brackets and from a sign.
MISTAKES = {
    "ends of comparisons": [(r" < ", " <= "), (r" <= ", " < "), (r" > ", " >= "), (r" >= ", " > ")],
    "comparisons turned around": [(r" < ", " > "), (r" <= ", " >= "), (r" > ", " < "), (r" >= ", " <= "), (r" == ", " != ")],
    "signs": [(r" \+ ", " - "), (r" - ", " + "), (r"\babs\(", "("), (r"\bcopysign\(", "min(")],
    "and, or, least and most": [(r" && ", " || "), (r" \|\| ", " && "), (r"\bevery\(", "some("), (r"\bsome\(", "every("),
                                (r"\bmin\(", "max("), (r"\bmax\(", "min(")],
    "constants": [(r"(?<=\()0\.5(?=\))", "0.5000001"), (r"(?<=\()2(?=\))", "1.9999"), (r"(?<=\()4(?=\))", "4.0001"),
                  (r"(?<=\()8(?= \* u)", "0.125"), (r"(?<=\()4(?= \* u)", "0.0625"), (r"(?<=\()3(?= \* u)", "0.0625")],
}


class Mutation:
    def __init__(self, kind, header, position, length, replacement, text):
        self.kind, self.header, self.position, self.length, self.replacement = kind, header, position, length, replacement
        begin, end = text.rfind("\n", 0, position) + 1, text.find("\n", position)
        self.line = text.count("\n", 0, position) + 1
        self.was = text[begin:end].strip()
        self.becomes = (text[begin:position] + replacement + text[position + length:end]).strip()

    def applied(self, text):
        return text[:self.position] + self.replacement + text[self.position + self.length:]


def mutations(header):
    text = (ROOT / "include/raio" / header).read_text()
    for kind, pattern, replacement in ((kind, *mistake) for kind, mistakes in MISTAKES.items() for mistake in mistakes):
        for found in re.finditer(pattern, text):
            line = text[text.rfind("\n", 0, found.start()) + 1:found.end()].strip()
            if not re.match(r"//|\*|#|template|requires|static_assert", line) and "//" not in line:
                yield Mutation(kind, header, found.start(), found.end() - found.start(), replacement, text)


def passes(program, rays, seconds):
    """What does not end is caught as well."""
    try:
        ran = subprocess.run([str(program), "--abort-after=1"], capture_output=True, timeout=seconds,
                             env=os.environ | {"RAIO_TEST_RAYS": str(rays)})
    except subprocess.TimeoutExpired:
        return False
    return ran.returncode == 0


def outcome(mutation, folder, arguments):
    """'caught', 'survived' or 'does not compile'."""
    path = folder / "include/raio" / mutation.header
    original = path.read_text()
    path.write_text(mutation.applied(original))
    try:
        programs = []
        for test in TESTS[mutation.header]:
            programs.append(folder / test.replace("/", "_"))
            compiled = subprocess.run(
                [arguments.compiler, "-std=c++20", "-O1", "-w", "-DRAIO_FLATTEN=", "-DGLM_FORCE_XYZW_ONLY",
                 f"-I{folder}/include", f"-I{ROOT}/tests", f"{ROOT}/tests/{test}.cpp",
                 *map(str, folder.parent.glob("*.o")), "-lmpfr", "-lgmp", "-o", str(programs[-1])],
                capture_output=True)
            if b"static assertion" in compiled.stderr or b"static_assert" in compiled.stderr:
                return "caught"  # before the program runs
            if compiled.returncode != 0:
                return "does not compile"
            if not passes(programs[-1], arguments.rays, arguments.timeout):
                return "caught"
        if not all(passes(program, arguments.all_rays, 10 * arguments.timeout) for program in programs):
            return "caught"
        return "survived"
    finally:
        path.write_text(original)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--header", action="append", choices=sorted(TESTS), metavar="PATH", help="below include/raio; all if not given")
    parser.add_argument("--count", type=int, help="that many, chosen at random; all if not given")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--rays", type=int, default=5000, help="of each comparison in the tests, at first")
    parser.add_argument("--all-rays", type=int, default=100_000, help="of what those do not catch; ctest sends that many")
    parser.add_argument("--timeout", type=float, default=120, help="seconds of one test at first; what takes longer is caught")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="mistakes that are tried at the same time")
    parser.add_argument("--compiler", default="g++")
    parser.add_argument("--list", action="store_true", help="only say what would be tried")
    arguments = parser.parse_args()

    tried = [m for header in arguments.header or sorted(TESTS) for m in mutations(header)]
    if arguments.count is not None and arguments.count < len(tried):
        tried = random.Random(arguments.seed).sample(tried, arguments.count)
    if arguments.list:
        for m in tried:
            print(f"{m.header}:{m.line}: {m.was}\n    {m.becomes}")
        return 0

    accepted = {tuple(line.split(" | ")[:2]) for line in ACCEPTED.read_text().splitlines()[1:] if " | " in line}
    for header, line in accepted - {(header, m.becomes) for header in TESTS for m in mutations(header)}:
        print(f"accepted, but made no more: {header}: {line}")
    counts = {kind: {"caught": 0, "survived": 0, "accepted": 0, "does not compile": 0} for kind in MISTAKES}
    with tempfile.TemporaryDirectory() as name, concurrent.futures.ThreadPoolExecutor(arguments.jobs) as jobs:
        folders = queue.SimpleQueue()
        for job in range(arguments.jobs):
            shutil.copytree(ROOT / "include", pathlib.Path(name, str(job), "include"))
            folders.put(pathlib.Path(name, str(job)))
        for shared in ["main", "support/oracle"]:
            subprocess.run([arguments.compiler, "-std=c++20", "-O2", f"-I{ROOT}/include", f"-I{ROOT}/tests", "-c",
                            f"{ROOT}/tests/{shared}.cpp", "-o", str(pathlib.Path(name, shared.replace("/", "_"))) + ".o"], check=True)

        def judged(mutation):
            folder = folders.get()
            try:
                return outcome(mutation, folder, arguments)
            finally:
                folders.put(folder)

        for m, result in zip(tried, jobs.map(judged, tried)):
            if result == "survived" and (m.header, m.becomes) in accepted:
                result = "accepted"
            counts[m.kind][result] += 1
            print(f"{result}: {m.header}:{m.line}", flush=True)
            if result != "caught":
                print(f"    {m.was}\n    {m.becomes}", flush=True)
    everything = {result: sum(of_kind[result] for of_kind in counts.values()) for result in counts["signs"]}
    for kind, results in [*counts.items(), ("all", everything)]:
        compiled = sum(results.values()) - results["does not compile"]
        noticed = 100 * (results["caught"] + results["accepted"]) / max(compiled, 1)
        print(f"{kind}: " + ", ".join(f"{count} {result}" for result, count in results.items()) +
              f"; {noticed:.1f} % of what compiles is caught or accepted")
    # Where nothing compiles it is not the mistakes.
    return 0 if not everything["survived"] and everything["caught"] + everything["accepted"] > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
