#!/usr/bin/env bash
# Records real programs as a user would: runs each program of README.md's table for some seconds in `apitrace trace`, under
# Xvfb and Mesa's software renderer. It keeps the first frames, from the very first call on, so that all their state is
# recorded. README.md describes the output and the origin of each program.
set -uo pipefail

folder=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
table=$folder/README.md
output=build/traces

usage() {
    cat <<USAGE
usage: tests/traces/record.sh [-m] [-o FOLDER] [NAME...]
Records the named programs of the table in tests/traces/README.md, or all of them, under Xvfb with apitrace.

    -o FOLDER   where to write (default: build/traces): FOLDER/NAME.trace, and FOLDER/NAME/ with the output of
                'apitrace dump --blobs': dump.txt, and one file per blob
    -m          only programs whose recording is not kept in tests/traces
    -l          list the programs, their packages, and whether they are installed
    -h          this text

Programs that are not installed are skipped, with the name of their package. Exit status: 0 all others were recorded;
1 one of them failed; 2 wrong usage, or apitrace or Xvfb is not installed.
USAGE
}

fail() {
    echo "record.sh: $1" >&2
    exit 2
}

# The table's rows, with fields separated by tabs: name package licence API seconds frames command.
# shellcheck disable=SC2016
rows() { sed -nE '/^\| `/{s/^\| *| *\|$|`//g;s/ *\| */\t/g;p}' "$table"; }

# Debian's games and screen savers may be missing from PATH.
PATH=$PATH:/usr/games:/usr/libexec/xscreensaver
installed() { command -v "${1%% *}" >/dev/null; }

list() {
    local name package command state
    while IFS=$'\t' read -r name package _ _ _ _ command; do
        if installed "$command"; then state=installed; else state="not installed"; fi
        printf '%-14s %-22s %s\n' "$name" "$package" "$state"
    done < <(rows)
}

missing=
while getopts 'mo:lh' option; do
    case $option in
    m) missing=yes ;;
    o) output=$OPTARG ;;
    l) list && exit 0 ;;
    h) usage && exit 0 ;;
    *) usage >&2 && exit 2 ;;
    esac
done
shift $((OPTIND - 1))
for name in "$@"; do
    rows | cut -f1 | grep -qxF -- "$name" || fail "no program '$name' in $table; -l lists them"
done
for tool in apitrace Xvfb; do
    installed $tool || fail "$tool is not installed; it is in Debian's package ${tool,,}"
done
mkdir -p "$output" 2>/dev/null || fail "cannot make the folder $output; -o names another"
output=$(cd "$output" && pwd)

# Each program has its own process group, so that all its processes end with the recording.
set -m
scratch=$(mktemp -d)
server=
finish() {
    [ -z "$server" ] || kill "$server" 2>/dev/null
    rm -rf "$scratch"
}
trap finish EXIT

# One screen of a fixed size and no window manager, so a window gets the size that its program requests. Without -noreset
# the server would restart between two programs, and the next one might not find it.
Xvfb -displayfd 3 -screen 0 640x480x24 -noreset -nolisten tcp 3>"$scratch/display" >/dev/null 2>&1 &
server=$!
for _ in {1..200}; do
    [ -s "$scratch/display" ] && break
    kill -0 "$server" 2>/dev/null || fail "Xvfb did not start"
    sleep 0.1
done
display=$(cat "$scratch/display")
[ -n "$display" ] || fail "Xvfb did not answer in 20 seconds"

# Programs write settings into their home, play sounds and wait for the monitor. Gives them a temporary home and disables
# the rest.
run_traced() {  # api trace command...
    local api=$1 trace=$2
    shift 2
    mkdir -p "$scratch/home"
    cd "$scratch/home" || exit 1
    exec env -u WAYLAND_DISPLAY DISPLAY=":$display" HOME="$scratch/home" XDG_CONFIG_HOME="$scratch/home" \
        SDL_AUDIODRIVER=dummy LIBGL_ALWAYS_SOFTWARE=1 vblank_mode=0 \
        apitrace trace --api="$api" --output="$trace" "$@"
}

# Runs a program for some seconds. On SIGINT apitrace's tracer writes its buffer, then lets the signal end the program;
# some programs catch it and continue.
run_for() {  # seconds api trace command...
    local seconds=$1 group
    shift
    run_traced "$@" </dev/null &
    group=$!
    disown  # otherwise bash reports the signal
    sleep "$seconds"
    kill -INT -- "-$group" 2>/dev/null
    for _ in {1..30}; do
        kill -0 -- "-$group" 2>/dev/null || return
        sleep 0.1
    done
    kill -KILL -- "-$group" 2>/dev/null
}

# Records one row. If it fails, $why is the reason.
record() {  # name api seconds frames command...
    local name=$1 api=$2 seconds=$3 frames=$4
    shift 4
    local raw=$scratch/$name.trace log=$scratch/$name.log kept=$output/$name.trace dump=$output/$name have
    rm -rf "$kept" "${output:?}/$name"
    run_for "$seconds" "$api" "$raw" "$@" >"$log" 2>&1
    if [ ! -s "$raw" ]; then
        why="no trace came of it; its last words: $(tail -n 1 "$log")"
        return 1
    fi
    if ! apitrace trim --frames="0-$((frames - 1))" -o "$kept" "$raw" >"$log" 2>&1; then
        why="apitrace trim: $(tail -n 1 "$log")"
        return 1
    fi
    rm "$raw"
    mkdir "$dump"
    # --blobs writes its files into the working folder.
    if ! (cd "$dump" && apitrace dump --color=never --blobs "$kept" >dump.txt 2>"$log"); then
        why="apitrace dump: $(tail -n 1 "$log")"
        return 1
    fi
    have=$(grep -cE '^[0-9]+ (glX|egl)SwapBuffers' "$dump/dump.txt")
    if [ "$have" -lt "$frames" ]; then
        why="it drew $have frames in $seconds seconds, not $frames"
        return 1
    fi
}

recorded=0 failed=0 skipped=0
while IFS=$'\t' read -r -u 4 name package _ api seconds frames command; do
    [ $# -eq 0 ] || printf '%s\n' "$@" | grep -qxF -- "$name" || continue
    [ -z "$missing" ] || [ ! -d "$folder/$name" ] || continue
    read -ra words <<<"$command"
    if ! installed "$command"; then
        echo "$name: skipped: not installed; it is in Debian's package $package"
        skipped=$((skipped + 1))
    elif record "$name" "$api" "$seconds" "$frames" "${words[@]}"; then
        echo "$name: $frames frames, $(du -sb "$output/$name" | cut -f1) bytes as a dump"
        recorded=$((recorded + 1))
    else
        echo "$name: failed: $why"
        failed=$((failed + 1))
    fi
done 4< <(rows)
echo "$recorded recorded, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ]
