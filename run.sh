#!/usr/bin/env bash
# Builds Relievo (installing what is missing) and runs it.
#   ./run.sh              with a display: the editor on the sample scene; without: sculpts a recorded journal headless
#                         and leaves before.png, after.png, the edited map and a timing table in a folder
#   ./run.sh VERB ...     relievo VERB ... (try ./run.sh --help)
set -euo pipefail
start_folder=$PWD
cd "$(dirname "${BASH_SOURCE[0]}")"
root=$PWD
source .ci/packages.sh
source .ci/build.sh

relievo_install relievo_build_packages
relievo_build release relievo relievo_sample_assets
relievo=$root/build/release/relievo
assets=$root/build/release/assets

if [ $# -gt 0 ]; then
    cd "$start_folder"
    exec "$relievo" "$@"
fi
if [ -n "${DISPLAY:-}" ] || [ -n "${WAYLAND_DISPLAY:-}" ]; then
    exec "$relievo" edit "$assets/scenes/asteroid.json"
fi
out=$root/out/sample
mkdir -p "$out"
"$relievo" replay "$assets/strokes/stump_rocks.jsonl" --live --timings --spp 16 \
    --render-before "$out/before.png" --render "$out/after.png" -o "$out/edited.tif" | tee "$out/timings.txt"
echo "before.png, after.png, edited.tif (the sculpted map) and timings.txt are in:"
echo "$out"
