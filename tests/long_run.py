#!/usr/bin/env python3
"""Runs the tests that are labelled nightly, each with as many rays as it is told, and prints what they found as Markdown.

    cmake --workflow --preset test && tests/long_run.py --rays 1000000 --jobs 2

What ctest would run, but for what takes no number of rays. The results are kept: a run that is filtered, or stopped,
replaces what it measures. A test that fails is shown with what it said, and the exit status is 1.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
README = pathlib.Path(__file__).with_name("README.md")
BEGIN, END = "<!-- tests/long_run.py --update writes from here -->", "<!-- to here -->"

CASE = re.compile(r"TEST CASE:.*<(\w+)>")
COMPARED = re.compile(r"MESSAGE: (\d+) rays, \d+ hits, t off by up to (\S+) ulp more than stated, "
                      r"than the numbers given explain by \S+, \d+ points vague, undecided: (\d+)")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rays", type=int, default=10_000_000, help="RAIO_TEST_RAYS (default: ten million)")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "test",
                        help="the build folder (default: that of the preset `test`)")
    parser.add_argument("--filter", default=".", help="tests whose name matches this regular expression only")
    parser.add_argument("--jobs", type=int, default=1, help="how many run at a time (default: 1)")
    parser.add_argument("--output", type=pathlib.Path, help="the results (default: long_run.json in the build folder)")
    parser.add_argument("--show", action="store_true", help="run nothing: print what has been found before")
    parser.add_argument("--update", action="store_true", help="put the rows into tests/README.md as well")
    return parser.parse_args()


def nightly_tests(options):
    """{name: command}"""
    listed = subprocess.run(["ctest", "--test-dir", options.build, "--show-only=json-v1", "-L", "^nightly$"],
                            stdout=subprocess.PIPE, check=True)
    found = {}
    for test in json.loads(listed.stdout)["tests"]:
        properties = {p["name"]: p["value"] for p in test["properties"]}
        name = test["name"].removeprefix("nightly/")
        if "RAIO_TEST_RAYS=10000000" in properties.get("ENVIRONMENT", []) and re.search(options.filter, name):
            found[name] = test["command"], properties.get("WORKING_DIRECTORY")
    return found


def run(command, folder, rays):
    """What the test said, and what came of it."""
    with subprocess.Popen(command, cwd=folder, env=os.environ | {"RAIO_TEST_RAYS": str(rays)}, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as test:
        said = test.stdout.read()
        _, status, used = os.wait4(test.pid, 0)
        test.returncode = os.waitstatus_to_exitcode(status)
    number, compared = None, {}
    for line in said.splitlines():
        if case := CASE.search(line):
            number = case[1]
        if found := COMPARED.search(line):
            of_number = compared.setdefault(number, {"rays": 0, "ulp": 0, "undecided": 0})
            of_number["rays"] += int(found[1])
            of_number["ulp"] = max(of_number["ulp"], float(found[2]))
            of_number["undecided"] += int(found[3])
    result = {"rays": rays, "seconds": used.ru_utime + used.ru_stime, "passed": test.returncode == 0,
              "compared": compared}
    return result, said


def rows(results):
    """{name: its row}"""
    found = {}
    for name, result in results.items():
        compared = result["compared"]
        rays = sum(c["rays"] for c in compared.values())
        ulp = [f"{compared[n]['ulp']:.3f} ulp" if n in compared else "" for n in ("float", "double")]
        undecided = f"{compared['double']['undecided']:,}" if "double" in compared else ""
        found[name] = (f"| {name} | {result['rays']:,} | {f'{rays:,}' if rays else ''} | {ulp[0]} | {ulp[1]} "
                       f"| {undecided} | {result['seconds']:,.0f} | {'passed' if result['passed'] else '**failed**'} |")
    return found


def table(found):
    return "\n".join(["| test | rays | compared with 75 digits | t off by, float | double | doubles undecided | seconds | |",
                      "|---|---:|---:|---:|---:|---:|---:|---|", *(row for _, row in sorted(found.items()))])


def update(found):
    """What has not been run again stays."""
    readme = README.read_text()
    before, rest = readme.split(BEGIN)
    text, after = rest.split(END)
    known = {row[1]: row[0] for row in re.findall(r"^(\| ([\w/]+) \| [\d,]+ \|.*)$", text, re.MULTILINE)}
    README.write_text(f"{before}{BEGIN}\n\n{table(known | found)}\n\n{END}{after}")


def main():
    options = arguments()
    output = options.output or options.build / "long_run.json"
    results = json.loads(output.read_text()) if output.exists() else {}
    failed = False
    if not options.show:
        tests = nightly_tests(options)
        if not tests:
            sys.exit(f"no nightly test in {options.build} matches: build them with cmake --workflow --preset test")
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            running = {pool.submit(run, *test, options.rays): name for name, test in tests.items()}
            for done in concurrent.futures.as_completed(running):
                name, (result, said) = running[done], done.result()
                results[name] = result
                output.write_text(json.dumps(results, indent=1))
                print(f"{name}: {'passed' if result['passed'] else 'FAILED'}, {result['seconds']:.0f} s",
                      file=sys.stderr, flush=True)
                if not result["passed"]:
                    failed = True
                    print(said, file=sys.stderr, flush=True)
    print(table(rows(results)))
    if options.update:
        update(rows(results))
    sys.exit(failed)


if __name__ == "__main__":
    main()
