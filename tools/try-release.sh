#!/usr/bin/env bash
# try-release.sh: tries the files of build/release, which `make release SYSTEMS=all` wrote: the checksums, the sources (built without a
# repository), the page, the manual pages, the notes, and each package on a bare system. `make nightly PART=release` runs both.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$PWD/build/release
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "try-release: $*" >&2; exit 1; }

(cd "$folder" && sha256sum --quiet -c SHA256SUMS)
listed=$(sed 's/^[^ ]* [ *]//' "$folder/SHA256SUMS" | sort)
[ "$listed" = "$(cd "$folder" && ls | grep -v '^SHA256SUMS$' | sort)" ] || fail "SHA256SUMS does not list every file"
sources=$(echo "$folder"/twinlight-*.tar.gz)
version=$(basename "$sources" .tar.gz | sed 's/^twinlight-//')
for file in twinlight.html twinlight-page.zip twinlight.1.html twinlight-demo.1.html NOTES.md; do
    [ -s "$folder/$file" ] || fail "$file is missing or empty"
done
for words in '<h1' '--with' "Twinlight $version"; do
    grep -qe "$words" "$folder/twinlight.1.html" || fail "twinlight.1.html lacks $words"
done
unzip -qd "$work" "$folder/twinlight-page.zip"
diff -r -x hosting.html "$work/twinlight" build/web/page || fail "the zip file does not hold build/web/page"

# The sources of the commit, which build and know their commit where there is no repository.
tar xzf "$sources" -C "$work"
(cd "$work/twinlight-$version" && make programs >"$work/log" 2>&1) || { tail -n 20 "$work/log"; fail "the sources do not build"; }
"$work/twinlight-$version/build/twinlight" --version | tee "$work/printed"
grep -qx "commit *$(gzip -dc "$sources" | git get-tar-commit-id | cut -c1-8)" "$work/printed" || fail "--version of the sources does not name the commit"

packages=0
for package in "$folder"/twinlight_*.deb; do
    system=$(basename "$package" | cut -d _ -f 3) status=0
    tools/in-clean-root.sh --give "$package" "$system" tools/install/try-deb.sh || status=$?
    case $status in
    0) packages=$((packages + 1)) ;;
    77) echo "try-release: skipped $(basename "$package") (see above)" ;;
    *) fail "$(basename "$package") does not work" ;;
    esac
done
echo "try-release: the files of $version are right; $packages packages were installed"
