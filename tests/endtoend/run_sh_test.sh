#!/usr/bin/env bash
# ./run.sh without a display: two pictures with a difference that a person sees, the map, the timings, the folder
# named last; a second call is quick; wrong arguments keep their exit status.
set -euo pipefail
cd "$1"
fail() { echo "FAILED: $*"; exit 1; }

output=$(env -u DISPLAY -u WAYLAND_DISPLAY ./run.sh)
folder=$(tail -n 1 <<<"$output")
for name in before.png after.png edited.tif timings.txt; do
    [ -s "$folder/$name" ] || fail "$folder/$name is missing"
done
grep -q "^trace" "$folder/timings.txt" || fail "no timing table by stage"
# idiff fails when pixels differ by more than a tenth of the range; at least 1% of them must.
if idiff -q -fail 0.1 -failpercent 1 "$folder/before.png" "$folder/after.png" >/dev/null; then
    fail "before.png and after.png look the same"
fi
iinfo "$folder/edited.tif" | grep -q "uint16" || fail "the edited map is not 16-bit"

start=$(date +%s%N)
./run.sh --help >/dev/null
took=$((($(date +%s%N) - start) / 1000000))
echo "a second call took $took ms"
[ "$took" -lt 5000 ] || fail "a second call took $took ms"

status=0
./run.sh render /no/such/scene.json -o x.png 2>/dev/null || status=$?
[ "$status" = 2 ] || fail "a missing scene gives exit status $status"
echo passed
