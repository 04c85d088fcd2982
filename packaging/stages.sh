# Sourced by packaging/run and packaging/test: named stages with their time, and a quiet way to build.

root=$(pwd) # the scripts stand in the repository's root by now
started=$(date +%s)

# stage TITLE: says what comes now, and how long all took so far.
stage() {
    now=$(($(date +%s) - started))
    printf '\n== %s (after %d min %02d s)\n' "$1" $((now / 60)) $((now % 60))
}

# quietly LOG COMMAND...: the output goes to the log; the end of it is shown where the command fails.
quietly() {
    log=$1
    shift
    mkdir -p "$(dirname "$log")"
    "$@" > "$log" 2>&1 || {
        grep -E 'error|Error|FAILED' "$log" | head -n 40
        tail -n 20 "$log"
        echo "failed: $* (all of it in ${log#"$root"/})"
        exit 1
    }
}

# build PRESET TARGET...: configures where needed and builds with Ninja.
build() {
    preset=$1
    shift
    quietly "$root/build/$preset-configure.log" cmake -S "$root" --preset "$preset"
    # Four hundred MB a compiler at worst: as many jobs as there are processors.
    cmake --build "$root/build/$preset" --parallel "$(nproc)" --target "$@" > "$root/build/$preset-build.log" 2>&1 || {
        grep -E -A 6 'error:|FAILED:|undefined reference' "$root/build/$preset-build.log" | head -n 60
        echo "failed: the $preset build (all of it in build/$preset-build.log)"
        exit 1
    }
}
