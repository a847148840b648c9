#!/usr/bin/env python3
"""Which lines of the library no test has run: not in one instance of the template that they are in.

    tests/coverage/lines.py llvm-cov show BINARY ... -instr-profile=PROFILE include

runs that command, and asks each instance. (What `llvm-cov report` sums up of a template is the instance that ran most of it.)
The exit status is 1 if there is such a line.
"""

import re
import subprocess
import sys

FILE = re.compile(r"(/.*):$")
LINE = re.compile(r"(?:  \|)* *(\d+)\| *([\d.]+[kMGTPEZY]?)\|")  # of the file, or, indented, of one instance


def main():
    shown = subprocess.run([*sys.argv[1:], "-show-instantiations=true"], stdout=subprocess.PIPE, text=True, check=True)
    has_run, file = {}, None
    for text in shown.stdout.splitlines():
        if named := FILE.match(text):
            file = named[1]
        elif counted := LINE.match(text):
            line = file, int(counted[1])
            has_run[line] = has_run.get(line, False) or counted[2] != "0"
    if not has_run:
        sys.exit("lines.py: no line of code in what llvm-cov shows")
    never = [line for line, ran in has_run.items() if not ran]
    print(f"{len(has_run) - len(never)} of {len(has_run)} lines of code run in some instance")
    for file, number in never:
        print(f"{file}:{number}: no test runs this line")
    sys.exit(1 if never else 0)


if __name__ == "__main__":
    main()
