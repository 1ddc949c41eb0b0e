#!/bin/sh
# try-deb.sh: on a bare Debian or Ubuntu, as root, installs the package that lies in /srv and tries what it installed.
#
#   tools/in-clean-root.sh --take 'build/*.deb' trixie 'make deb'
#   tools/in-clean-root.sh --give build/trixie/twinlight_*.deb trixie tools/install/try-deb.sh
set -eu
export DEBIAN_FRONTEND=noninteractive
apt-get update -qq
# Documentation is left out of many bare systems; here it is wanted.
rm -f /etc/dpkg/dpkg.cfg.d/docker /etc/dpkg/dpkg.cfg.d/excludes
apt-get install -qq -y --no-install-recommends /srv/twinlight_*.deb xvfb xauth >/dev/null
if ls /usr/include/GL/gl.h /usr/bin/g++ 2>/dev/null; then
    echo "try-deb: this system is not bare" >&2
    exit 1
fi

# Nothing of the clone is near.
folder=$(mktemp -d)
cd "$folder"
twinlight --version
twinlight scenes
twinlight compare report --size 320x240 -o report
twinlight check | tail -n 4
twinlight export lab --as html -o lab.html
twinlight render /usr/share/twinlight/scenes/lab.gl --with shaders -o lab.png
xvfb-run -a twinlight-demo --quit-after 3 --screenshot window.png
ls -l report/index.html lab.html lab.png window.png /usr/share/man/man1/twinlight.1.gz /usr/share/man/man1/twinlight-demo.1.gz \
    /usr/share/bash-completion/completions/twinlight /usr/share/applications/twinlight.desktop

apt-get purge -qq -y twinlight >/dev/null
if find / -xdev -iname '*twinlight*' -not -path '/srv/*' -not -path '/tmp/*' -not -path '/proc/*' -not -path '/var/cache/*' | grep .; then
    echo "try-deb: the package left these files behind" >&2
    exit 1
fi
echo "try-deb: the package was installed, tried and removed"
