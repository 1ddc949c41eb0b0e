#!/usr/bin/env bash
# nightly.sh [PART...]: what takes too long for each change; `make nightly` runs it. Each part is run once for a commit: a part that
# has succeeded on this commit is skipped, so that an interrupted run can go on. Each writes its row into docs/testing.md.
set -uo pipefail
cd "$(dirname "$0")/.."
unset MAKEFLAGS MAKELEVEL  # each part's make uses all processors, also when make started this script

parts=(headers cases fuzz recipes release bookworm trixie forky noble resolute)
usage() {
    cat <<END
Usage: tools/nightly.sh [PART...]
Runs the parts of the nightly tests (all of them without PART), and writes their rows into docs/testing.md:

  headers   each header compiled by itself
  cases     every test with all of its cases
  fuzz      random input into everything that reads files, ten minutes a target (FUZZ_TIME=seconds)
  recipes   small changes by the recipes of CONTRIBUTING.md, each built and tested (tests/recipes)
  release   'make release SYSTEMS=all', and a try of each file: the sources are built, the packages are installed (as root)
  bookworm, trixie, forky, noble, resolute
            'make demo && make test' on a bare Debian 12, Debian 13, Debian testing, Ubuntu 24.04 and Ubuntu 26.04 (as root)

A part that has succeeded on this commit is skipped; build/nightly/PART names the commit. Exit status: 0 if all succeeded.
END
}
case ${1-} in --help | -h) usage; exit 0 ;; esac
[ $# -gt 0 ] || set -- "${parts[@]}"
for part; do
    case " ${parts[*]} " in
    *" $part "*) ;;
    *) echo "nightly: there is no part '$part'; the parts are ${parts[*]}" >&2; exit 2 ;;
    esac
done

commit=$(git rev-parse --short=8 HEAD)
if ! git diff --quiet HEAD -- . ':!docs/testing.md'; then
    echo "nightly: there are uncommitted changes, and the rows name a commit; commit them first" >&2
    exit 2
fi
mkdir -p build/nightly

# Puts a row into the table of docs/testing.md that begins with the line "<!-- nightly: NAME -->", in place of the row with this key
# (the text between its first two bars) or at the end of the table.
write_row() {
    awk -v name="$1" -v row="$2" '
        function key(line) { split(line, cells, "|"); return cells[2] cells[3] }
        $0 == "<!-- nightly: " name " -->" { here = 1 }
        here && /^\|/ { table = 1; if (key($0) == key(row)) { print row; done = 1; next } }
        here && table && !/^\|/ { if (!done) print row; here = 0; done = 1 }
        { print }
        END { if (here && table && !done) print row }' docs/testing.md >build/nightly/testing.md &&
        cat build/nightly/testing.md >docs/testing.md
}

failed=()
for part; do
    done=build/nightly/$part
    if [ "$(cat "$done" 2>/dev/null)" = "$commit" ]; then
        echo "nightly: $part has succeeded on $commit"
        continue
    fi
    echo "nightly: $part"
    rm -f "$done"
    begin=$SECONDS status=0
    case $part in
    headers) command="make headers" ;;
    cases) command="make test ALL_CASES=true" ;;
    fuzz) command="make fuzz TIME=${FUZZ_TIME:-600}" ;;
    recipes) command="tools/try-recipes.sh" ;;
    release) command="make release SYSTEMS=all && tools/try-release.sh" ;;
    *) command="" ;;
    esac
    if [ -n "$command" ]; then
        bash -c "$command" 2>&1 | tee "build/nightly/$part.log" || status=1
        result=succeeded
        [ "$status" -eq 0 ] || result=failed
        write_row parts "| $part | \`$command\` | $(date -u +%F) | $commit | $(((SECONDS - begin + 30) / 60)) min | $result |"
    else
        rm -f "build/nightly/$part.row"
        tools/in-clean-root.sh --row "build/nightly/$part.row" "$part" 'make demo && make test' || status=$?
        if [ "$status" -eq 77 ]; then continue; fi  # this machine cannot; the script said why
        write_row systems "$(cat "build/nightly/$part.row")"
    fi
    if [ "$status" -eq 0 ]; then echo "$commit" >"$done"; else failed+=("$part"); fi
done
if [ ${#failed[@]} -gt 0 ]; then
    echo "nightly: failed: ${failed[*]}" >&2
    exit 1
fi
