#!/usr/bin/env bash
# Makes docs/real-programs.png again, a picture of the page that `compare` writes: tests/docs/page_picture.sh, after make
# programs. Needs chromium.
set -euo pipefail
cd "$(dirname "$0")/../.."
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cp -r tests/traces/cage/. "$folder"
mv "$folder/dump.txt" "$folder/cage.txt"
"${TWINLIGHT_BUILD:-build}/twinlight" compare "$folder/cage.txt" -o "$folder/page"
chromium --headless --no-sandbox --hide-scrollbars --window-size=1100,1066 \
    --screenshot=docs/real-programs.png "file://$folder/page/index.html"
