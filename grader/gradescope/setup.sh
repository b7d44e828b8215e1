#!/usr/bin/env bash
# Gradescope runs this once, as root, when it makes the autograder's machine.
set -euo pipefail
cd "$(dirname "$0")/project"
bash common/setup
make -j2 build/grade $(if [[ -d contest ]]; then echo build/compete; fi) build/worker build/worker_address build/jail_{shim,probe,unpack}
# Compiles what will draw the references, and fills the driver's cache. These are our own labs.
build/grade --trusted ${LAB:+--lab "$LAB"} solutions
