#!/bin/sh
# Installs missing packages with apt; `make deps` runs it. $DEPENDENCIES has a line for each package: its name in Debian, then
# a command that succeeds if the package is installed.
set -eu

missing() {
    echo "$DEPENDENCIES" | while read -r package installed; do
        [ -z "$package" ] || sh -c "$installed" >/dev/null 2>&1 || printf ' %s' "$package"
    done
}

packages=$(missing)
[ -n "$packages" ] || exit 0
if ! command -v apt-get >/dev/null; then
    echo "These packages are missing (Debian names):$packages" >&2
    echo "Install them with your system's package manager, then run make again." >&2
    exit 1
fi
sudo=
[ "$(id -u)" = 0 ] || sudo="sudo "
line="${sudo}apt-get update -qq; ${sudo}env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends$packages"
echo "$line"
if [ -n "$sudo" ] && ! command -v sudo >/dev/null; then
    echo "This command needs root, and sudo is not installed: run it as root, then run make again." >&2
    exit 1
fi
eval "$line" || true

packages=$(missing)
[ -n "$packages" ] || exit 0
echo "Still missing:$packages" >&2
case $packages in
*osmesa*) echo "If apt cannot find libosmesa6-dev: Mesa 25.1 and later have no OSMesa; use 'make GL=egl' instead." >&2 ;;
esac
exit 1
