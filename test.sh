#!/usr/bin/env bash
# Installs what is missing, builds the release preset and runs every test; then everything but the driver's code again
# under the address and undefined-behaviour sanitizers. Ends with ctest's summary.
#   ./test.sh [--quick]   --quick leaves the sanitizers out
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
source .ci/packages.sh
source .ci/build.sh

relievo_install relievo_build_packages relievo_test_packages
relievo_build release all
if [ "${1:-}" != --quick ]; then
    relievo_build asan all
    # Leaks are not looked for: Vulkan drivers and the image library's plugins leave some, in modules that are unloaded
    # by the time the leak checker asks for their names, so that they cannot be told from ours.
    export ASAN_OPTIONS=detect_leaks=0
    export UBSAN_OPTIONS=print_stacktrace=1
    ctest --preset asan --output-on-failure -LE "release_only" -j 2
fi
ctest --preset release --output-on-failure -LE "sanitizers_only" -j 2
