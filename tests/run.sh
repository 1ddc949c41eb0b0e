#!/usr/bin/env bash
# run.sh PROGRAM [FILTER]: runs a GoogleTest program's tests on all processors. It starts a process for every few suites and shows the
# output of each when it ends. The last lines count the tests as GoogleTest does. PROGRAM.times lists the tests with their milliseconds,
# the slowest first.
set -uo pipefail
program=$1 filter=${2:-*}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export program scratch

# One line a part: "Suite.Test:Suite.Test", whole suites with at least 8 tests together, because a process takes 30 ms to start.
"$program" --gtest_list_tests --gtest_filter="$filter" | awk '
    /^[^ ]+\.( |$)/ { if (tests >= 8) { print part; part = ""; tests = 0 } suite = $1 }
    /^  / { part = part (part == "" ? "" : ":") suite $1; ++tests }
    END { if (part != "") print part }' >"$scratch/parts"
count=$(tr ':' '\n' <"$scratch/parts" | grep -c .)
if [ "$count" -eq 0 ]; then
    echo "run.sh: no test matches '$filter'; $program --gtest_list_tests lists them" >&2
    exit 2
fi

# Prints the output of the tests. Of GoogleTest's own lines it keeps those about failed and skipped tests. Each test adds a line to
# $scratch/results: OK, FAILED or SKIPPED, its milliseconds and its name.
run_part() {
    local out status died rest
    out=$(mktemp "$scratch/out-XXXXXX")
    { "$program" --gtest_filter="$1" --gtest_print_time=1 >"$out" 2>&1; status=$?; } 2>/dev/null
    exec 9>"$scratch/lock"
    flock 9
    awk -v status=$status -v first="${1%%:*}" -v results="$scratch/results" -v died="$out.died" '
        /\[ RUN      \] / { running = $NF; next }
        /\[ +(OK|FAILED|SKIPPED) +\] .* \([0-9]+ ms\)$/ {
            match($0, /\[ +(OK|FAILED|SKIPPED) /)
            split(substr($0, RSTART), words)
            print words[2], substr($(NF - 1), 2), running >>results
            failed = failed || words[2] == "FAILED"
            running = ""
            if (words[2] != "OK") print
            next
        }
        /^Running main\(\) from |^Note: |^\[(-+|=+|  PASSED  )\]|^\[  (FAILED |SKIPPED) \] |^ ?[0-9]+ FAILED TESTS?$|^ *$/ { next }
        { print }
        END {
            if (running == "" && (status == 0 || failed)) exit
            where = running == "" ? "the end of the part that begins with " first : running
            printf "[  FAILED  ] %s: the program ended with status %d\n", where, status
            print "FAILED 0", where >>results
            if (running != "") print running >died
        }' "$out"
    exec 9>&-
    # Run the tests after the one that ended the process.
    if [ -s "$out.died" ]; then
        rest=:$1:
        rest=${rest#*:"$(cat "$out.died")":}
        if [ -n "$rest" ]; then run_part "${rest%:}"; fi
    fi
    rm -f "$out" "$out.died"
}
export -f run_part

touch "$scratch/results"
begin=$SECONDS
# One more than there are processors, because tests of windows and pages wait now and then.
xargs -d '\n' -n 1 -P $(($(nproc) + 1)) bash -c 'run_part "$1"' run_part <"$scratch/parts"
sort -k2,2nr "$scratch/results" | cut -d ' ' -f 2- >"$program.times"

number() { grep -c "^$1 " "$scratch/results"; }
tests() { if [ "$1" -eq 1 ]; then echo "1 test"; else echo "$1 tests"; fi; }
failed=$((count - $(number OK) - $(number SKIPPED)))
if [ "$failed" -eq 0 ]; then failed=$(number FAILED); fi  # the program failed after its last test
echo "[==========] $(tests "$count") ran in $((SECONDS - begin)) s on $(nproc) processors."
echo "[  PASSED  ] $(tests "$(number OK)")."
if [ "$(number SKIPPED)" -gt 0 ]; then echo "[  SKIPPED ] $(tests "$(number SKIPPED)")."; fi
[ "$failed" -eq 0 ] && exit 0
echo "[  FAILED  ] $(tests "$failed"):"
sed -nE 's/^FAILED [0-9]+ /[  FAILED  ] /p' "$scratch/results"
exit 1
