#!/usr/bin/env bash
# try-recipes.sh [PATCH...]: whether recipes of CONTRIBUTING.md are true; `make nightly PART=recipes` runs it. Each patch in
# tests/recipes is a small change made by a recipe. In a copy of the last commit it is applied, built and tested, and each file that it
# changes must be named in the recipe, by its name or by a folder.
#
# The head of a patch: the recipe's heading, the tests to run, and what the recipe runs between building and testing.
set -euo pipefail
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- tests/recipes/*.patch

copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
git clone -q . "$copy"

of_head() { sed -n "/^diff /q; s/^$2: //p" "$1"; }
# The text below the heading "### NAME", as far as the next one.
recipe() { awk -v name="### $1" '/^##/ { here = $0 == name } here' CONTRIBUTING.md; }
is_named() {  # in the text, in backquotes: the file itself, the end of its path, or a folder above it
    local path=$1 text=$2 folder
    grep -qF -e "\`$path\`" -e "\`${path##*/}\`" <<<"$text" && return
    for ((folder = ${#path}; folder > 0; --folder)); do
        [ "${path:folder-1:1}" != / ] || ! grep -qF "\`${path:0:folder}\`" <<<"$text" || return 0
    done
    return 1
}

failed=0
for patch; do
    name=$(basename "$patch" .patch) heading=$(of_head "$patch" Recipe) status=0
    text=$(recipe "$heading")
    if [ -z "$text" ]; then
        echo "recipes: $patch: CONTRIBUTING.md has no recipe '$heading'" >&2
        failed=1
        continue
    fi
    echo "recipes: $name ($heading)"
    git -C "$copy" reset -q --hard
    git -C "$copy" clean -qfd
    git -C "$copy" apply "$PWD/$patch" || { echo "recipes: $patch does not apply: make the change again by the recipe" >&2; failed=1; continue; }
    for file in $(git -C "$copy" ls-files --modified --others --exclude-standard); do
        is_named "$file" "$text" || { echo "recipes: $name changes $file, which the recipe does not name" >&2; status=1; }
    done
    (cd "$copy" && make programs >/dev/null && bash -c "$(of_head "$patch" Then)" && make test TEST="$(of_head "$patch" Tests)") || status=1
    [ $status -eq 0 ] && echo "recipes: $name: as the recipe says, and its tests pass" || failed=1
done
exit $failed
