#!/bin/sh
# Installs missing packages with apt; `make deps` runs it. On a system without apt it prints the names of the packages there.
# $DEPENDENCIES has a line for each package: its name in Debian, then a command that succeeds if the package is installed. Of
# "libosmesa6|libegl-mesa0" the first is taken that the system has.
set -eu

missing() {
    echo "$DEPENDENCIES" | while read -r package installed; do
        [ -z "$package" ] || sh -c "$installed" >/dev/null 2>&1 || printf ' %s' "$package"
    done
}
# The first of a line's packages that apt can install; the last one if it can install none.
choose() {
    for packages; do
        for package in $(echo "$packages" | tr '|' ' '); do
            if apt-cache policy "$package" 2>/dev/null | grep -q 'Candidate: [^(]'; then break; fi
        done
        printf ' %s' "$package"
    done
}

# ---- Other systems ----

# The system's column in tools/package-names, by its package manager.
column=
if command -v apt-get >/dev/null; then column=1
elif command -v dnf >/dev/null; then column=2 name=Fedora install="sudo dnf install"
elif command -v pacman >/dev/null; then column=3 name=Arch install="sudo pacman -S --needed"
elif command -v zypper >/dev/null; then column=4 name=openSUSE install="sudo zypper install"
fi
names() {
    for packages; do
        awk -v column="$column" -v packages="$packages" '
            BEGIN { count = split(packages, of_line, "|") }
            /^#/ { next }
            { there[$1] = $column }
            END {
                for (i = 1; i <= count; ++i) if (there[of_line[i]] != "-") break
                if (i > count) exit
                name = of_line[i] in there ? there[of_line[i]] : of_line[i]
                gsub(",", " ", name)
                printf " %s", name
            }' tools/package-names
    done
}
missing_there() {
    for packages; do
        [ -n "$(names "$packages")" ] || printf ' %s' "$packages"
    done
}

packages=$(missing)
[ -n "$packages" ] || exit 0
if [ -z "$column" ]; then
    echo "These packages are missing, and this system has no apt. Debian calls them:" >&2
    echo " $(echo "$packages" | sed 's/[^ ]*|//g')" >&2
    echo "Install them, then run make again." >&2
    exit 1
fi
if [ "$column" != 1 ]; then
    # shellcheck disable=SC2086  # a list
    there=$(names $packages) without=$(missing_there $packages)
    echo "Packages are missing, and make installs them only with apt. With $name's names (not tried; see tools/package-names):" >&2
    [ -z "$there" ] || echo "    $install$there" >&2
    [ -z "$without" ] || echo "$name has no package of these:$without" >&2
    echo "Nothing was installed. When they are there, run make again." >&2
    exit 1
fi

# ---- apt ----

sudo=
[ "$(id -u)" = 0 ] || sudo="sudo "
if [ -n "$sudo" ] && ! command -v sudo >/dev/null; then
    # shellcheck disable=SC2086
    echo "apt-get update -qq; DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends$(choose $packages)"
    echo "This command needs root, and sudo is not installed: run it as root, then run make again." >&2
    exit 1
fi
echo "${sudo}apt-get update -qq"
${sudo}apt-get update -qq || true
# shellcheck disable=SC2086
line="${sudo}env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends$(choose $packages)"
echo "$line"
eval "$line" || true

packages=$(missing)
[ -n "$packages" ] || exit 0
echo "Still missing:$packages" >&2
exit 1
