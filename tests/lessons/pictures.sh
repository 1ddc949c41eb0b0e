#!/bin/sh
# Makes the pictures of docs/lessons again: the scene to start from, and the one with the change. Look at each before you commit it.
set -eu
cd "$(dirname "$0")/../.."
program=${TWINLIGHT_BUILD:-build}/twinlight
folder=docs/lessons/pictures
mkdir -p "$folder"
for page in docs/lessons/*.md; do
    name=$(basename "$page" .md)
    [ "$name" != README ] || continue
    "$program" lesson "$name" -o - | "$program" render - --with reference --size 400x300 -o "$folder/$name.png" 2>/dev/null
    "$program" lesson "$name" --changed -o - |
        "$program" render - --with reference --size 400x300 -o "$folder/$name-changed.png" 2>/dev/null
done
