#!/usr/bin/env bash
# gallery.sh PROGRAM FOLDER [SCENE...]: draws the built-in scenes (all, or these), each of their steps, with every renderer, and writes a
# page of the pictures, FOLDER/index.html. Each row leads to the page of `twinlight compare` for that step, and to the page of `make web`
# if that is in FOLDER/../web.
set -euo pipefail
program=$1 folder=$2
shift 2
mkdir -p "$folder"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# "scene NAME TEXT" and, after it, "step NUMBER TITLE" lines, with tabs between; a scene without steps has the step 0. The JSON has
# one string a line.
"$program" scenes --json | awk -v chosen=" $* " '
    function string() {
        match($0, /".*"/)
        value = substr($0, RSTART + 1, RLENGTH - 2)
        gsub(/\\"/, "\"", value); gsub(/\\\\/, "\\", value)
        gsub(/&/, "\\&amp;", value); gsub(/</, "\\&lt;", value); gsub(/>/, "\\&gt;", value)
        return value
    }
    /^ *"name": / { sub(/"name": /, ""); name = string(); next }
    /^ *"description": / { sub(/"description": /, ""); about = string(); next }
    /^ *"steps": \[/ {
        shown = chosen == "  " || index(chosen, " " name " ")
        if (shown) print "scene\t" name "\t" about
        count = 0; in_steps = 1
        if (/\]/) { in_steps = 0; if (shown) print "step\t0\t" }
        next
    }
    in_steps && /^ *\]/ { in_steps = 0; next }
    in_steps { if (shown) print "step\t" ++count "\t" string() }
' >"$work/list"
[ -s "$work/list" ] || { echo "gallery.sh: there is no such scene: $*" >&2; exit 2; }

# Exit status 1 is a difference, which the page shows.
draw() {
    local scene=$1 name=$1 step=()
    if [ "$2" != 0 ]; then name=$1-$2 step=(--step "$2"); fi
    "$program" compare "$scene" "${step[@]}" -o "$folder/$name" >"$work/$name.out" 2>"$work/$name.err" && return
    [ $? -eq 1 ] || { cat "$work/$name.err" >&2; return 255; }
}
export -f draw
export program folder work
awk -F '\t' '$1 == "scene" { scene = $2 } $1 == "step" { print scene, $2 }' "$work/list" |
    xargs -P "$(nproc)" -L 1 bash -c 'draw "$1" "$2"' draw

style=$(dirname "$0")/../src/judge/report/pages/page.css
{
    cat <<END
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Twinlight: all scenes</title>
<style>
$(cat "$style")
.row { display: grid; grid-template-columns: repeat(4, 1fr); gap: .75rem; margin: .5rem 0 1.5rem; }
@media (max-width: 45rem) { .row { grid-template-columns: repeat(2, 1fr); } }
.row figcaption { color: var(--quiet); font-size: .8125rem; }
.index { columns: 12rem; list-style: none; padding: 0; }
h3 { margin: 1.25rem 0 .25rem; font-size: 1rem; font-weight: 650; }
h2 + p { max-width: 46rem; }
.answer { color: var(--quiet); font-size: .875rem; }
a { color: var(--accent); }
</style>
</head>
<body>
<p class="product">Twinlight $("$program" --version | sed -n 's/^twinlight //p')</p>
<h1>All scenes, by all renderers</h1>
<p class="hint">The first three pictures light vertices, as GL's fixed function does, and must agree. The fourth lights every pixel. A
click on a row's answer opens its comparison, with the differences.</p>
<ul class="index">
END
    awk -F '\t' '$1 == "scene" { printf "<li><a href=\"#%s\">%s</a></li>\n", $2, $2 }' "$work/list"
    echo "</ul>"
    while IFS=$'\t' read -r kind name text; do
        if [ "$kind" = scene ]; then
            scene=$name
            printf '<h2 id="%s">%s</h2>\n<p>%s</p>\n' "$scene" "$scene" "$text"
            continue
        fi
        place=$scene
        if [ "$name" != 0 ]; then
            place=$scene-$name
            printf '<h3>%s. %s</h3>\n' "$name" "$text"
        fi
        answer=$(sed -n 3p "$work/$place.out" | sed 's/&/\&amp;/g; s/</\&lt;/g; s/>/\&gt;/g')
        change=
        if [ -e "$folder/../web/twinlight.html" ]; then
            change=" <a href=\"../web/twinlight.html#scene=$scene&amp;step=$name\">Change this scene</a>"
        fi
        printf '<p class="answer"><a href="%s/index.html">%s</a>%s</p>\n<div class="row">\n' "$place" "$answer" "$change"
        for picture in "fixed:fixed function" "shaders:shaders" "reference:reference" "shaders-phong:shaders, every pixel"; do
            [ -e "$folder/$place/${picture%%:*}.png" ] || { echo "gallery.sh: $folder/$place has no picture ${picture%%:*}.png" >&2; exit 1; }
            printf '<figure><img loading="lazy" src="%s/%s.png" alt="%s: %s"><figcaption>%s</figcaption></figure>\n' \
                "$place" "${picture%%:*}" "$place" "${picture#*:}" "${picture#*:}"
        done
        echo "</div>"
    done <"$work/list"
    printf '</body>\n</html>\n'
} >"$folder/index.html"
echo "$folder/index.html"
