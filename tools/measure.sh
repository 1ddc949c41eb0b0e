#!/usr/bin/env bash
# Prints how far an idea is spread over the code: the files that know a name, what is compiled again after a change of a header, and the
# files of each room. Nothing depends on the numbers; they show whether a change made the next one smaller.
#
#   tools/measure.sh           all measures
#   tools/measure.sh HEADER    only what a change of this header compiles again, for example src/scene/frame/frame.h
set -euo pipefail
cd "$(dirname "$0")/.."

# Counts the files of src that have a match, or the matches themselves.
files() { git grep -lE "$1" -- src | wc -l; }
lines() { git grep -hE "$1" -- src | wc -l; }

row() { printf '%6s  %-46s %s\n' "$1" "$2" "$3"; }

spread() {
    echo "Files of src that know an idea, with the pattern that is searched for:"
    local name pattern
    while IFS='|' read -r name pattern; do row "$(files "$pattern")" "$name" "$pattern"; done <<'END'
a light's quadratic attenuation|quadratic_?[aA]ttenuation|QUADRATIC_ATTENUATION
the smooth cone|[sS]mooth_?[cC]one|smooth cone|spot_cone|cos_outer|kCosOuter
the reflection variant|\breflection\b
a light's cutoff|spot_cutoff|spotCutoff|SPOT_CUTOFF
a material inside glBegin|\.materials\b|\bmaterials_\b|vertex_materials|varies_(ambient|diffuse|specular|emission)
END
    echo
    echo "Lines of src that write an idea out:"
    while IFS='|' read -r name pattern; do row "$(lines "$pattern")" "$name" "$pattern"; done <<'END'
k0 + k1 d + k2 d d|quadratic_attenuation \* |k2 \* d|linear_attenuation \* d
whether a light has a cone|spot_cutoff_deg [!=]= 180
whether a light is attenuated|linear_attenuation != 0 \|\||constant_attenuation != 1
END
}

# The share of the lines of all .cpp files of src that a change of the header $1 compiles again: of the files that include it, directly
# or through others, and of their rooms, because a room is compiled as one file.
rebuilt() {
    git ls-files 'src/*.h' 'src/*.cpp' 'src/*.def' | xargs awk -v header="${1#src/}" '
        FNR == 1 { file = FILENAME; sub(/^src\//, "", file); if (file ~ /\.cpp$/) cpp[file] = 1 }
        /^#include "/ { split($0, part, "\""); users[part[2]] = users[part[2]] " " file }
        { if (file ~ /\.cpp$/) { ++lines[file]; ++all } }
        END {
            queue[n++] = header
            for (i = 0; i < n; ++i) {
                count = split(users[queue[i]], by, " ")
                for (j = 1; j <= count; ++j) if (!(by[j] in seen)) { seen[by[j]] = 1; queue[n++] = by[j] }
            }
            for (file in cpp) if (file in seen) {
                own += lines[file]
                room = file; sub(/\/[^\/]*$/, "", room); rooms[room] = 1
            }
            for (file in cpp) { room = file; sub(/\/[^\/]*$/, "", room); if (room in rooms) whole += lines[file] }
            printf "%5.0f %%  %5.0f %%  %s\n", 100 * own / all, 100 * whole / all, header
        }'
}

rebuilds() {
    echo "Lines of .cpp files that are compiled again after a change (make units=files; by rooms, as make does):"
    local header
    for header in "$@"; do rebuilt "$header"; done
}

rooms() {
    echo "Files of each room, those of more than 25 first:"
    git ls-files src | sed -n 's|^src/\(.*\)/[^/]*$|\1|p' | sort | uniq -c | sort -k1,1nr -k2 |
        awk '{ printf "%6d  %s\n", $1, $2 }'
    echo
    git ls-files 'src/*.h' 'src/*.cpp' 'src/*.c' 'src/*.def' 'src/*.glsl' | xargs cat | wc -l |
        awk '{ printf "%6d  lines of src (C++, C, GLSL, tables)\n", $1 }'
    git ls-files 'tests/*.h' 'tests/*.cpp' | xargs cat | wc -l | awk '{ printf "%6d  lines of tests (C++)\n", $1 }'
}

case "${1:-}" in
"")
    spread
    echo
    rebuilds src/scene/frame/frame.h src/scene/command/command.h src/lighting/equation.h
    echo
    rooms
    ;;
-h | --help) sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//p;}' "$0" ;;
*)
    [[ -f $1 ]] || { echo "$0: $1: no such header; expected a path such as src/scene/frame/frame.h" >&2; exit 2; }
    rebuilds "$1"
    ;;
esac
