#!/bin/sh
# Prints the commit of these sources, with a "+" if src/ has other changes; nothing if it is unknown. `git archive` writes the commit into
# this file, because an archive has no repository.
set -eu
commit='$Format:%H$' changed=
case $commit in
'$'*)
    cd "$(dirname "$0")/.."
    [ -z "$(git rev-parse --show-prefix)" ] || exit 0 # a copy inside of another repository
    commit=$(git rev-parse HEAD)
    git diff --quiet HEAD -- src || changed=+
    ;;
esac
printf '%.8s%s\n' "$commit" "$changed"
