#!/usr/bin/env bash
# Runs a command on a bare Debian or Ubuntu, in a clean clone of the last commit. --help says how.
set -uo pipefail

usage() {
    cat <<END
Usage: tools/in-clean-root.sh [options] RELEASE 'COMMAND'
       tools/in-clean-root.sh [options] --times RELEASE
       tools/in-clean-root.sh [options] --try RELEASE
Runs a command on a bare Debian or Ubuntu: the packages that every installation has, make and git, nothing else.
It runs as root, in a clean clone of this repository's last commit. Uncommitted changes are not in it.

  tools/in-clean-root.sh trixie 'make demo && make test'

RELEASE      bookworm (Debian 12), trixie (Debian 13), forky (Debian testing), noble (Ubuntu 24.04)
             or resolute (Ubuntu 26.04)
--mirror URL take packages from this mirror, not from the release's own
--fresh      make the bare system again (do this from time to time: it is not upgraded)
--keep       keep the root after the run, to look at what the command left behind
--give FILE  copy this file into the root's /srv, beside the clone
--take FILES after the run, copy these files of the clone ('build/*.deb') here, into build/RELEASE
--row FILE   append a row about the run to this file, for the tables of docs/testing.md
--times      instead of a command: run README's two commands, and print the seconds that each takes
--try        run no command: only make the bare system, to see whether this machine can

The bare system, downloaded packages and the last run's log are kept in
$cache.
The script needs root, debootstrap and a network. It passes on http_proxy, https_proxy and apt's settings for them.

Exit status: 0 if the command succeeded, the command's own if it failed, 2 for wrong use,
77 if this machine cannot run it.
END
}

cache=${XDG_CACHE_HOME:-${HOME:-/root}/.cache}/twinlight/roots
say() { printf 'in-clean-root: %s\n' "$*" >&2; }
wrong_use() { say "$*"; say "See tools/in-clean-root.sh --help"; exit 2; }
cannot_run() { say "$*"; exit 77; }

mirror= fresh= keep= try= times= give= take= row=
while [[ ${1-} == -* ]]; do
    case $1 in
        --help | -h) usage; exit 0 ;;
        --mirror) [ $# -ge 2 ] || wrong_use "--mirror needs a URL"; mirror=$2; shift ;;
        --mirror=*) mirror=${1#*=} ;;
        --fresh) fresh=yes ;;
        --keep) keep=yes ;;
        --give) [ -f "${2-}" ] || wrong_use "--give needs a file"; give=$2; shift ;;
        --take) [ $# -ge 2 ] || wrong_use "--take needs a file's path in the clone"; take=$2; shift ;;
        --row) [ $# -ge 2 ] || wrong_use "--row needs a file"; row=$2; shift ;;
        --times) times=yes ;;
        --try) try=yes ;;
        *) wrong_use "there is no option $1" ;;
    esac
    shift
done
if [ -n "$try$times" ]; then
    [ $# -eq 1 ] || wrong_use "--try and --times need a release and no command"
else
    [ $# -eq 2 ] || wrong_use "a release and a command are needed (quote the command)"
fi
release=$1 command=${2-}
if [ -n "$times" ]; then
    # The packages come first, so that the network's speed is a number of its own.
    command='for goal in "deps (packages)" demo test; do begin=$SECONDS; make ${goal%% *}; echo "seconds: make $goal: $((SECONDS - begin))"; done'
fi

# The components that hold our packages, the distribution's keys, and how debootstrap makes it: a debootstrap that is older than
# the release makes it as an earlier one.
case $release in
    bookworm) name="Debian 12" components=main keys=debian-archive-keyring scripts="bookworm bullseye" ;;
    trixie) name="Debian 13" components=main keys=debian-archive-keyring scripts="trixie bookworm" ;;
    forky) name="Debian testing" components=main keys=debian-archive-keyring scripts="forky testing trixie bookworm" ;;
    noble) name="Ubuntu 24.04" components=main,universe keys=ubuntu-archive-keyring scripts="noble jammy focal" ;;
    resolute) name="Ubuntu 26.04" components=main,universe keys=ubuntu-archive-keyring scripts="resolute noble jammy focal" ;;
    *) wrong_use "the releases are bookworm, trixie, forky, noble and resolute, not '$release'" ;;
esac

# ---- What this machine needs ----

[ "$(id -u)" = 0 ] || cannot_run "making a bare system needs root: run it with sudo"
command -v debootstrap >/dev/null || cannot_run "debootstrap is missing: apt-get install debootstrap"
unshare --mount --pid --fork true 2>/dev/null ||
    cannot_run "this machine does not allow mounts: in a container, start it with --privileged"
script=
for script in $scripts; do [ -e "/usr/share/debootstrap/scripts/$script" ] && break; done
[ -e "/usr/share/debootstrap/scripts/$script" ] ||
    cannot_run "this debootstrap does not know $release: install a newer one (apt-get install debootstrap)"

source=$(cd "$(dirname "$0")/.." && git rev-parse --show-toplevel) ||
    cannot_run "this is no git repository: clone it with git"

folder=$cache/$release
base=$folder/base root=$folder/root debs=$folder/debs log=$folder/last-run.log
clone=/srv/twinlight  # inside the root
mkdir -p "$debs/partial" || cannot_run "cannot write into $folder"
exec 9>"$folder/lock"
flock --nonblock 9 || { say "waiting for another run of $release"; flock 9; }

# ---- The bare system: made once ----

[ -z "$fresh" ] || rm -rf --one-file-system "$base"
if [ ! -d "$base" ]; then
    say "making a bare $name in $base"
    check_keys=(--force-check-gpg)
    if [ ! -e "/usr/share/keyrings/$keys.gpg" ]; then
        check_keys=(--no-check-gpg)
        say "the packages' signatures are not checked: /usr/share/keyrings/$keys.gpg is missing"
    fi
    rm -rf --one-file-system "$base.partial"
    # The empty mirror is debootstrap's own default for the release.
    if ! debootstrap --variant=minbase --include=make,git --components="$components" --cache-dir="$debs" "${check_keys[@]}" \
        "$release" "$base.partial" "$mirror" "/usr/share/debootstrap/scripts/$script" >"$log" 2>&1; then
        tail -n 5 "$log" >&2
        cannot_run "debootstrap failed ($log): is there a network? Set http_proxy for a proxy, or name a --mirror"
    fi
    # Installed systems also have the updates. Flushing every file to disk costs minutes and changes nothing here.
    sed -n "s/^deb \(.*\) $release /deb \1 $release-updates /p" "$base.partial/etc/apt/sources.list" >"$base.partial/updates"
    cat "$base.partial/updates" >>"$base.partial/etc/apt/sources.list"
    rm "$base.partial/updates"
    echo force-unsafe-io >"$base.partial/etc/dpkg/dpkg.cfg.d/quick"
    mv "$base.partial" "$base"
fi

[ -z "$try" ] || exit 0

# ---- A copy of it for this run ----

# Whoever looked into a root that was kept may have left something mounted in it: /proc, for one. That goes first, the deepest
# before what it lies in. (mountinfo writes a space as \040.)
remove_root() {
    local mounted real
    real=$(realpath --canonicalize-missing "$root")
    awk '{ print $5 }' /proc/self/mountinfo | sort -r | while read -r mounted; do
        mounted=$(printf '%b' "${mounted//\\/\\0}")
        [[ $mounted != "$real"/* ]] || umount "$mounted" 2>/dev/null || umount --lazy "$mounted"
    done
    rm -rf --one-file-system "$root"
    [ ! -e "$root" ]
}
remove_root || cannot_run "cannot remove the last run's root: $root"
trap '[ -n "$keep" ] || remove_root' EXIT
cp -a --reflink=auto "$base" "$root"
apt-config dump 2>/dev/null | grep -E '^Acquire::(https?::Proxy|Check-)' >"$root/etc/apt/apt.conf.d/host"
cp -L /etc/resolv.conf "$root/etc/resolv.conf" 2>/dev/null
[ -z "$(git -C "$source" status --porcelain)" ] || say "uncommitted changes are not part of the run"
git clone --quiet --no-hardlinks "$source" "$root$clone" || cannot_run "cannot clone $source"
[ -z "$give" ] || cp "$give" "$root/srv/" || cannot_run "cannot copy $give into the root"

proxies=()
for variable in http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY; do
    [ -z "${!variable-}" ] || proxies+=("$variable=${!variable}")
done

# Mounts are seen only by these processes, and go when the last of them ends, however it ends.
enter='
    root=$1 debs=$2; shift 2
    mount -t proc proc "$root/proc" && mount -t tmpfs -o mode=1777 shm "$root/dev/shm" &&
    mount -t devpts -o newinstance,ptmxmode=666 devpts "$root/dev/pts" &&
    mount --bind "$debs" "$root/var/cache/apt/archives" && exec chroot "$root" "$@"
    exit 77'
# Names the command that ended the run, where it failed.
inside='
    trap "exit 130" INT TERM
    trap "status=\$?; [ \$status = 0 ] || printf %s \"\$BASH_COMMAND\" >/failed-command" EXIT
'
unshare --mount --pid --fork --kill-child --propagation private bash -c "$enter" enter "$root" "$debs" \
    env -i --chdir="$clone" HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "TERM=${TERM:-dumb}" "${proxies[@]}" \
    bash -c "$inside$command" 2>&1 | tee -i "$log"
status=${PIPESTATUS[0]}
if [ -n "$take" ] && [ "$status" -eq 0 ]; then
    taken=$source/build/$release
    rm -rf "$taken" && mkdir -p "$taken"
    # shellcheck disable=SC2086  # a pattern
    (cd "$root$clone" && cp --target-directory="$taken" $take) || { say "the command made no $take"; status=1; }
fi

# ---- One line about the run ----

gcc=$(chroot "$root" g++ -dumpfullversion 2>/dev/null)
mesa=$(chroot "$root" dpkg-query -W -f '${Version}' libgl1-mesa-dri 2>/dev/null | sed 's/[-~].*//')
osmesa=$(chroot "$root" dpkg-query -W -f '${Version}' libosmesa6 2>/dev/null | sed 's/[-~].*//')
[ -z "$osmesa" ] || [ "$osmesa" = "$mesa" ] || mesa="$mesa, OSMesa $osmesa"
system="$name${gcc:+, g++ $gcc}${mesa:+, Mesa $mesa}"
[ -z "$keep" ] || say "the root is kept, with the clone in $clone: chroot $root"
if [ -n "$row" ]; then
    result=succeeded
    [ "$status" -eq 0 ] || result="failed (status $status)"
    # The last count of tests, if the command ran some: '[  PASSED  ] 1850 tests.'
    count=$(sed -nE 's/^\[  PASSED  \] ([0-9]+ tests?)\.$/\1/p' "$log" | tail -n 1)
    echo "| $name | $release | g++ ${gcc:-?} | ${mesa:-?} | $(date -u +%F) | $(git -C "$source" rev-parse --short=8 HEAD) | \`$command\` | $result${count:+, $count passed} |" >>"$row"
fi
if [ "$status" -eq 0 ] && [ -n "$times" ]; then
    say "$system, on $(nproc) processors ($(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -n 1)):"
    sed -n 's/^seconds: //p' "$log" >&2
elif [ "$status" -eq 0 ]; then
    say "$system: '$command' succeeded"
else
    failed=$(cat "$root/failed-command" 2>/dev/null)
    # GoogleTest lists what failed at its end: '[  FAILED  ] Suite.Name'.
    tests=$(sed -nE 's/^\[  FAILED  \] ([A-Za-z0-9_]+\.[A-Za-z0-9_/]+)( .*)?$/\1/p' "$log" | sort -u | paste -sd ' ')
    say "$system: '${failed:-$command}' failed with exit status $status${tests:+; failed tests: $tests} (log: $log)"
fi
exit "$status"
