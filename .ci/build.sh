# Sourced by run.sh and test.sh: configures once and builds a preset; quiet unless something fails.

# Clones of the tree share compiled objects, wherever they lie.
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1

relievo_build() {  # preset, target...
    local preset=$1 folder=build/$1 log
    shift
    log=$(mktemp)
    if [ ! -e "$folder/build.ninja" ]; then
        echo "relievo: configuring ($preset)" >&2
        cmake --preset "$preset" >"$log" 2>&1 || { cat "$log" >&2; rm -f "$log"; return 1; }
    fi
    if ninja -C "$folder" -n "$@" 2>/dev/null | grep -cE "Building|Linking|Generating" >/dev/null; then
        echo "relievo: building ($preset); the first time takes minutes" >&2
    fi
    ninja -C "$folder" "$@" >"$log" 2>&1 || { grep -E -A12 "error|FAILED" "$log" | head -n 60 >&2; rm -f "$log"; return 1; }
    rm -f "$log"
}
