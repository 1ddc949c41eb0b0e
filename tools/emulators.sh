#!/usr/bin/env bash
# Runs the hard cases on implementations of GL that are not ours, and writes a row of docs/emulators.md for each. --help says how.
set -euo pipefail
cd "$(dirname "$0")/.."

rows=(llvmpipe softpipe zink wine emscripten trixie resolute forky)
usage() {
    cat <<END
Usage: tools/emulators.sh [ROW...]
Runs the cases of 'twinlight check --write-cases' (all rows without ROW), and writes the rows into docs/emulators.md:

  llvmpipe, softpipe        Mesa's software drivers, of this system, by EGL
  zink                      OpenGL on Vulkan, here on Mesa's lavapipe (mesa-vulkan-drivers)
  wine                      Windows' opengl32 in Wine (packages wine and mingw-w64), under Xvfb
  emscripten                -sLEGACY_GL_EMULATION in Chromium without a window (packages emscripten and chromium; Node)
  trixie, resolute, forky   llvmpipe and softpipe of Debian 13, Ubuntu 26.04 and Debian testing, on a bare one (as root)

The last run's report of each row is kept in build/emulators/ROW.
END
}
case ${1-} in --help | -h) usage; exit 0 ;; esac
[ $# -gt 0 ] || set -- "${rows[@]}"

cases=$PWD/build/emulators
doc=docs/emulators.md
make programs
say() { printf 'emulators: %s\n' "$*" >&2; }

# A fresh folder of the cases for a row.
write_cases() {
    rm -rf "${cases:?}/$1"
    build/twinlight check --write-cases "$cases/$1" >/dev/null
}

# write_row NAME WHAT COMMAND FOLDER: from the report in the folder, in place of the row with this name.
write_row() {
    local gl counts
    gl=$(sed -n 1p "$4/report.txt")
    counts=$(sed -nE '2s/^[0-9]+ cases: ([0-9]+) right, ([0-9]+) wrong, ([0-9]+) open, ([0-9]+) not run, ([0-9]+) crashed$/\1 | \2 | \3 | \4 | \5/p' "$4/report.txt")
    [ -n "$counts" ] || { say "$1: no report in $4"; return 1; }
    awk -v name="$1" -v row="| $1 | $2 | $gl | $counts | $(date -u +%F) | \`$3\` |" '
        $0 == "<!-- emulators -->" { here = 1 }
        here && index($0, "| " name " |") == 1 { print row; done = 1; next }
        here && $0 == "<!-- end -->" { if (!done) print row; here = 0 }
        { print }' "$doc" >"$cases/emulators.md"
    cat "$cases/emulators.md" >"$doc"
    say "$1: $counts (right, wrong, open, not run, crashed)"
}

# mesa NAME WHAT ARGUMENTS VARIABLE=VALUE...
mesa() {
    local name=$1 what=$2 arguments=$3
    shift 3
    write_cases "$name"
    (cd "$cases/$name" && env "XDG_RUNTIME_DIR=${XDG_RUNTIME_DIR:-/tmp}" "$@" \
        make report-at-once WINDOW=egl ARGUMENTS="$arguments" >/dev/null)
    write_row "$name" "$what" "$* make report-at-once WINDOW=egl${arguments:+ ARGUMENTS=$arguments}" "$cases/$name"
}

# another RELEASE WHAT: on a bare system, with its own Mesa.
another() {
    local command driver
    write_cases "$1"
    tar -C "$cases/$1" -cf "$cases/cases.tar" .
    command='apt-get install -y --no-install-recommends gcc libc6-dev libegl-dev libgl-dev libegl-mesa0 libgl1-mesa-dri >/dev/null
        for driver in llvmpipe softpipe; do
            mkdir -p "build/$driver" && tar -C "build/$driver" -xf /srv/cases.tar
            (cd "build/$driver" && LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=$driver make -j report WINDOW=egl >/dev/null)
            mv "build/$driver/report.txt" "build/$driver.txt"
        done'
    tools/in-clean-root.sh --give "$cases/cases.tar" --take 'build/*.txt' "$1" "$command"
    for driver in llvmpipe softpipe; do
        mkdir -p "$cases/$1/$driver"
        mv "build/$1/$driver.txt" "$cases/$1/$driver/report.txt"
        write_row "$1 $driver" "$2, EGL" "LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=$driver make report WINDOW=egl" "$cases/$1/$driver"
    done
}

for row; do
    case $row in
    llvmpipe) mesa llvmpipe "Mesa, EGL" "" LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe ;;
    # In Mesa 22.3, softpipe crashes in feedback mode if it uses LLVM for vertices.
    softpipe) mesa softpipe "Mesa, EGL" "" LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=softpipe DRAW_USE_LLVM=0 ;;
    # Its feedback mode crashes.
    zink) mesa zink "Mesa on lavapipe, EGL" --pixel LIBGL_ALWAYS_SOFTWARE=1 MESA_LOADER_DRIVER_OVERRIDE=zink ;;
    wine)
        write_cases wine
        wine=$(wine --version)
        (cd "$cases/wine" && export WINEDEBUG=-all WINEPREFIX="$cases/wine/prefix" &&
            make build/all.exe WINDOW=win32 EXE=.exe CC=x86_64-w64-mingw32-gcc >/dev/null &&
            LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s '-screen 0 800x600x24' \
                make report-at-once WINDOW=win32 EXE=.exe CC=x86_64-w64-mingw32-gcc RUN=wine >/dev/null)
        write_row wine "$wine, which passes the calls to" \
            'make report-at-once WINDOW=win32 EXE=.exe CC=x86_64-w64-mingw32-gcc RUN=wine' "$cases/wine" ;;
    emscripten)
        write_cases emscripten
        mkdir -p "$cases/emscripten/build"
        (cd "$cases/emscripten" &&
            emcc -std=c99 -O1 -DNO_FEEDBACK -I. all.c hard_case.c window_glut.c -o build/cases.js -sLEGACY_GL_EMULATION=1 \
                -sSINGLE_FILE=1 -sERROR_ON_UNDEFINED_SYMBOLS=0 -sEXIT_RUNTIME=1 -lglut 2>build/log.txt)
        node tools/emscripten-cases.mjs "$cases/emscripten" >"$cases/emscripten/results.txt"
        (cd "$cases/emscripten" && sh report.sh results.txt >/dev/null)
        write_row emscripten "Emscripten $(emcc -dumpversion), LEGACY_GL_EMULATION" 'tools/emulators.sh emscripten' "$cases/emscripten" ;;
    trixie) another trixie "Debian 13's Mesa" ;;
    resolute) another resolute "Ubuntu 26.04's Mesa" ;;
    forky) another forky "Debian testing's Mesa" ;;
    *) say "there is no row '$row'; the rows are ${rows[*]}"; exit 2 ;;
    esac
done
