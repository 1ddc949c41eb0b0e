#!/bin/sh
# deb.sh ROOT VERSION FOLDER: makes a Debian package of what is installed below ROOT, for the system that this runs on. The package
# depends on the libraries that the programs were linked with, and on a GL to load. It is written into FOLDER, and its path is printed.
set -eu
root=$(cd "$1" && pwd) version=$2 folder=$3
maintainer="The Twinlight authors <authors@twinlight.invalid>"
architecture=$(dpkg --print-architecture)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Debian wants programs without symbols, packed manual pages, the licence as "copyright", and a changelog.
strip "$root"/usr/bin/*
gzip -9nf "$root"/usr/share/man/man1/*.1
mv "$root/usr/share/doc/twinlight/LICENSE" "$root/usr/share/doc/twinlight/copyright"

printf 'twinlight (%s) unstable; urgency=low\n\n  * This version.\n\n -- %s  %s\n' "$version" "$maintainer" \
    "$(date -R -u -d "@${SOURCE_DATE_EPOCH:-0}")" | gzip -9n >"$root/usr/share/doc/twinlight/changelog.gz"

# dpkg-shlibdeps looks for debian/control in the working folder.
mkdir "$work/debian"
printf 'Source: twinlight\n\nPackage: twinlight\nArchitecture: any\n' >"$work/debian/control"
libraries=$(cd "$work" && dpkg-shlibdeps -O "$root"/usr/bin/* 2>"$work/warnings" | sed -n 's/^shlibs:Depends=//p')

[ -n "$libraries" ] || { cat "$work/warnings" >&2; exit 1; }

mkdir -p "$root/DEBIAN"
cat >"$root/DEBIAN/control" <<END
Package: twinlight
Version: $version
Architecture: $architecture
Maintainer: $maintainer
Installed-Size: $(du -sk --exclude=DEBIAN "$root" | cut -f 1)
Depends: $libraries, libosmesa6 | libegl1
Recommends: fonts-dejavu-core, xclip
Suggests: apitrace, fonts-droid-fallback, xvfb
Section: graphics
Priority: optional
Description: OpenGL's lighting three ways, and where the pictures differ
 Twinlight runs OpenGL's lighting commands with the driver's fixed function,
 with generated shaders, and with a double-precision reference. It shows where
 the pictures differ, explains each pixel, and finds mistakes in a scene.
 .
 twinlight is the command; twinlight-demo opens a window.
END
(cd "$root" && find usr -type f -exec md5sum {} + | sort -k 2 >DEBIAN/md5sums)
package=$folder/twinlight_${version}_$architecture.deb
dpkg-deb --root-owner-group --build "$root" "$package" >/dev/null
echo "$package"
