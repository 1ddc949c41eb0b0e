#!/usr/bin/env bash
# release.sh VERSION [SYSTEM...]: writes the release into build/release/; `make release` runs it. The SYSTEMs get Debian packages, too;
# "all" means all five. `tools/release.sh --notes VERSION` prints only the notes.
set -euo pipefail
cd "$(dirname "$0")/.."
unset MAKEFLAGS MAKELEVEL  # or make would have only one job

notes() {  # what CHANGELOG.md has below the heading of this version
    awk -v version="$1" '/^## / { here = $2 == version; next } here' CHANGELOG.md | sed -e '/./,$!d'
}
if [ "$1" = --notes ]; then notes "$2"; exit; fi

version=$1
shift
[ "$*" != all ] || set -- bookworm trixie forky noble resolute
if ! git diff --quiet HEAD; then
    echo "release: there are uncommitted changes, and the sources are those of the last commit; commit the changes first" >&2
    exit 2
fi
folder=build/release
rm -rf $folder
mkdir -p $folder

make dist DIST=$folder
make web
cp build/web/twinlight.html build/web/twinlight-page.zip $folder

# A package is for one system, and its name says which.
take_package() { cp "$1/twinlight_${version}_"*.deb "$folder/$(basename "$1/twinlight_${version}_"*.deb | sed "s/_$version/&_$2/")"; }
rm -f build/twinlight_*.deb
make deb
here=$(. /etc/os-release && echo "${VERSION_CODENAME:-$ID}")
take_package build "$here"
for system; do
    [ "$system" != "$here" ] || continue
    status=0
    tools/in-clean-root.sh --take 'build/*.deb' "$system" 'make deb' || status=$?
    case $status in
    0) take_package "build/$system" "$system" ;;
    77) echo "release: skipped the package for $system (see above)" >&2 ;;
    *) exit "$status" ;;
    esac
done

make manuals-html
cp build/share/*.1.html $folder
notes "$version" >$folder/NOTES.md
(cd $folder && sha256sum -- * >SHA256SUMS.new && mv SHA256SUMS.new SHA256SUMS && ls -l)
