#!/bin/sh
# The lecture for a projector: tools/slides/slides.sh TWINLIGHT FOLDER; `make slides` runs it. Writes FOLDER/index.html and zh.html from
# docs/lecture.md and its Chinese translation, the pictures, and a page for each scene that can be drawn in a browser.
set -eu
twinlight=$1 out=$2
here=tools/slides
rm -rf "$out"
mkdir -p "$out/scenes" "$out/lecture" "$out/lessons/pictures"
cp docs/lecture/*.png "$out/lecture/"

# The scenes that the lecture's commands name.
scenes=$(sed -n 's/.*build\/twinlight[a-z-]* \(\(compare\|render\|explain\) \)\?\([a-z-]*\).*/\3/p' docs/lecture.md | sort -u)
live=
for scene in $scenes; do
    "$twinlight" scenes "$scene" >/dev/null 2>&1 || continue
    if "$twinlight" export "$scene" --as html -o "$out/scenes/$scene.html" 2>"$out/error"; then
        live="$live $scene"
    else
        rm -f "$out/scenes/$scene.html"
        echo "slides: $scene stays a picture: $(head -1 "$out/error")" >&2
    fi
done
rm -f "$out/error"

write() { # LANGUAGE PAGE FILE OTHER-FILE OTHER-NAME
    for picture in $(grep -o 'lessons/pictures/[a-z-]*\.png' "$2"); do cp "docs/$picture" "$out/$picture"; done
    {
        sed -e "s/{{language}}/$1/g" -e "s/{{live}}/$live/g" -e "s/{{other}}/$4/g" -e "s/{{other_name}}/$5/g" \
            -e "s/{{title}}/$(sed -n '1s/^# //p' "$2")/g" -e "/{{style}}/{
r $here/slides.css
d
}" "$here/head.html"
        # The pictures of the Chinese page lie one folder up.
        sed 's#(\.\./l#(l#g' "$2" | cmark-gfm --unsafe -e table -t html
        echo '</main>'
        echo '<script>'
        cat "$here/slides.js"
        echo '</script>'
        echo '</body></html>'
    } >"$out/$3"
}
write en docs/lecture.md index.html zh.html 中文
write zh docs/zh-CN/lecture.md zh.html index.html English
echo "$out/index.html"
