#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Builds the Debian packages, checks them with lintian, installs them into a fresh Debian 12, uses them there as users
# would, removes them, and checks that nothing is left. Needs root, and the archive of Debian.
#
#     tests/packages/debian.sh
set -euo pipefail

top=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null && pwd)
cd -- "$top"
# shellcheck source=samples/setup/packages.sh
source samples/setup/packages.sh
((EUID == 0)) || die "making a fresh Debian takes root"

ensure_packages lintian debootstrap
samples/setup/debian_packages.sh
packages=$PWD/build/package

say "lintian"
# There is no bug of Debian that an initial upload would close.
lintian --fail-on error --suppress-tags initial-upload-closes-no-bugs "$packages"/*.deb

root=$(mktemp -d)
# The archive from which this machine installs packages; by default that of Debian.
mirror=$({ cat /etc/apt/sources.list /etc/apt/sources.list.d/*.list /etc/apt/sources.list.d/*.sources 2>/dev/null || true; } |
    awk '/^deb .* bookworm / { for (k = 2; k <= NF; ++k) if ($k ~ /^http/) { print $k; exit } }
         /^URIs:/ { print $2; exit }')
mirror=${mirror:-http://deb.debian.org/debian}
remove_root() {
    umount "$root/proc" 2>/dev/null || true
    rm -rf --one-file-system "$root"
}
trap remove_root EXIT

say "a fresh Debian 12 from $mirror"
debootstrap --variant=minbase bookworm "$root" "$mirror" >"$packages/debootstrap.txt"
mount -t proc proc "$root/proc"
for file in /etc/hosts /etc/apt/apt.conf.d/* /etc/apt/sources.list /etc/apt/sources.list.d/*; do
    [[ ! -f $file ]] || install -D -m 644 "$file" "$root$file"
done
cp /etc/resolv.conf "$root/etc/resolv.conf"
mkdir "$root/packages"
cp "$packages"/*.deb "$root/packages"
cp -r samples/library "$root/packages"
inside() {
    env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 HOME=/tmp \
        chroot "$root" "$@"
}

say "installing"
inside apt-get -q update
inside apt-get -q install -y --no-install-recommends g++ cmake make pkg-config python3 >/dev/null
inside find /usr/bin /usr/lib /usr/share /usr/include /etc -print | sort >"$packages/before.txt"
inside sh -c 'apt-get -q install -y --no-install-recommends /packages/*.deb'

say "using the program"
inside foamtex --version --verbose
inside sh -c 'cd /tmp && foamtex bake sea_foam --size 128 --frames 1-2 && ls out && foamtex verify out'
inside sh -c 'man -w foamtex 2>/dev/null || test -e /usr/share/man/man1/foamtex.1.gz'

say "using the Python module"
inside python3 -c '
import foamtex
frame = next(foamtex.Preset("lava", {"image.size": [64, 64]}).simulate("1"))
assert frame.map("albedo", "uint8").shape == (64, 64, 3)
print(foamtex.__version__, len(frame.bubbles), "bubbles")'

say "using the libraries"
inside sh -c 'cmake -S /packages/library -B /tmp/samples >/dev/null && cmake --build /tmp/samples >/dev/null &&
    /tmp/samples/bubbles && /tmp/samples/picture /tmp && g++ -std=c++20 /packages/library/picture.cpp -o /tmp/picture \
    $(pkg-config --cflags --libs foam_texgen) && /tmp/picture /tmp'

say "removing"
inside sh -c 'apt-get -q purge -y foamtex foamtex-dev python3-foamtex >/dev/null'
inside find /usr/bin /usr/lib /usr/share /usr/include /etc -print | sort >"$packages/after.txt"
# The packages on which they depend stay, as always; files of their own must be gone.
if comm -13 "$packages/before.txt" "$packages/after.txt" | grep -i foam; then
    die "the files above are left"
fi
say "the packages install, work, and leave nothing"
