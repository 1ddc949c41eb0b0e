#!/bin/sh
# publish-page.sh FOLDER: builds the page, and writes what a host serves into FOLDER, which must be new or empty: the page, the same as one
# file, and both as zip files. .github/workflows/page.yml runs this for GitHub Pages.
set -eu
if [ $# -ne 1 ]; then
    echo "usage: tools/publish-page.sh FOLDER" >&2
    exit 2
fi
folder=$1
if [ -e "$folder" ] && [ -n "$(ls -A "$folder")" ]; then
    echo "publish-page.sh: $folder is not empty; give a new folder" >&2
    exit 2
fi
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
cd "$(dirname "$0")/.."
make web
cp -R build/web/page/. build/web/twinlight.html build/web/hosting.html build/web/twinlight.zip build/web/twinlight-page.zip "$folder"
echo "$folder/index.html"
