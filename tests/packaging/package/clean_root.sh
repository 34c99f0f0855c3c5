#!/usr/bin/env bash
# clean_root.sh FOLDER VERSION ID: apt installs the package in the folder into a minimal Debian with the usual
# desktop packages; an ordinary user runs it; its removal leaves no trace. The folder keeps the base system.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=tests/packaging/package/lib.sh
source "$here/lib.sh"
folder=$1 version=$2 id=$3
export PATH=$PATH:/usr/sbin:/sbin

# Separate mounts and processes, which end with the script.
if [[ ${ALIDADE_OWN_SPACE:-} != yes ]]; then
  [[ $(id -u) -eq 0 ]] || skip "not root"
  needs debootstrap chroot unshare dpkg-deb apt-get
  unshare --mount --pid --fork true 2>/dev/null || skip "mounts of its own are not allowed here"
  export ALIDADE_OWN_SPACE=yes
  exec unshare --mount --pid --fork --kill-child bash "$0" "$@"
fi

package=$(package_in "$folder")
# shellcheck source=/dev/null
suite=$(source /etc/os-release && [[ $ID == debian ]] && printf '%s' "${VERSION_CODENAME:-}") || skip "this is not Debian"
[[ -n $suite ]] || skip "this Debian has no name"
# debootstrap accepts no blank in a path, so the tree is mounted at a path without one.
tree=/mnt on_disk=$folder/clean-root base=$folder/base-$suite.tar

begun=$SECONDS
# An interrupted download is not a fault of the package.
broke_off() { ! grep -qE "Failed to fetch|Unable to fetch|Could not (resolve|connect)|Couldn't download|Failed getting" "$1" ||
  skip "the mirror of Debian stopped answering: $(tail -n 2 "$1")"; }
step() { printf '%3d s  %s\n' "$((SECONDS - begun))" "$*"; }

# Where this machine has its own packages from.
# shellcheck disable=SC2016
mapfile -t repositories < <(apt-get indextargets --format '$(REPO_URI) $(CODENAME) $(COMPONENT)' 'Created-By: Packages' \
  'Origin: Debian' 2>/dev/null | grep -E " $suite(-updates|-security)? main\$" | sort -u)
mirror=$(printf '%s\n' "${repositories[@]}" | sed -n "s/ $suite main\$//p" | head -n 1)
if [[ -z $mirror ]]; then
  mirror=$(cat /etc/apt/sources.list /etc/apt/sources.list.d/*.{list,sources} 2>/dev/null | sed 's/#.*//' |
    grep -oE 'https?://[^ ]+/debian/?( |$)' | head -n 1 | tr -d ' ') || skip "apt knows no mirror of Debian"
  repositories=("$mirror $suite main")
fi
proxy=
eval "$(apt-config shell proxy Acquire::http::Proxy)"
[[ -z $proxy ]] || export http_proxy=$proxy
rm -f -- "$folder/release"
timeout 60 /usr/lib/apt/apt-helper download-file "${mirror%/}/dists/$suite/InRelease" "$folder/release" >/dev/null 2>&1 ||
  skip "the mirror of Debian does not answer"

# The base system, into which packages are unpacked without waiting for the disk.
remove_tree() {
  local place
  for place in "$tree/proc" "$tree"; do
    ! mountpoint -q "$place" || umount -l "$place"
  done
  rm -rf --one-file-system -- "$on_disk"
}
trap remove_tree EXIT
rm -rf --one-file-system -- "$on_disk"
# In memory if there is plenty: it disappears with the mounts, and avoids a busy disk.
if (($(awk '$1 == "MemAvailable:" { print int($2 / 1024) }' /proc/meminfo) > 4000)); then
  mount -t tmpfs -o size=2G,mode=755 tmpfs "$tree"
else
  mkdir -- "$on_disk"
  mount --bind -- "$on_disk" "$tree"
fi
if [[ ! -f $base ]]; then
  {
    debootstrap --foreign --variant=minbase "$suite" "$tree" "$mirror" &&
      echo force-unsafe-io >"$tree/etc/dpkg/dpkg.cfg.d/test" &&
      chroot "$tree" /debootstrap/debootstrap --second-stage
  } >"$folder/debootstrap.log" 2>&1 || { broke_off "$folder/debootstrap.log" && fail "debootstrap failed: $(tail -n 5 "$folder/debootstrap.log")"; }
  ! mountpoint -q "$tree/proc" || umount "$tree/proc"
  tar -C "$tree" --numeric-owner --one-file-system -cf "$base.part" . && mv -- "$base.part" "$base"
else
  tar -C "$tree" --numeric-owner -xpf "$base"
fi
step "the base"
mount -t proc proc "$tree/proc"
cp -L -- /etc/resolv.conf "$tree/etc/resolv.conf"
printf 'deb %s\n' "${repositories[@]}" >"$tree/etc/apt/sources.list"
printf 'Acquire::Languages "none";\n%s\n' "${proxy:+Acquire::http::Proxy \"$proxy\";}" >"$tree/etc/apt/apt.conf.d/test"
cp -- "$package" "$tree/tmp/"
cp -- "$here/as_user.sh" "$tree/tmp/"

inside() { chroot "$tree" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
apt() {
  inside apt-get -qq -y --no-install-recommends "$@" </dev/null >"$folder/apt.log" 2>&1 ||
    { broke_off "$folder/apt.log" && fail "apt-get $*: $(tail -n 20 "$folder/apt.log")"; }
}

# With the tools of a desktop, and without Qt until the package requires it.
apt update
apt install "/tmp/$(basename -- "$package")" libglib2.0-bin desktop-file-utils shared-mime-info man-db
step "installed"
[[ $(inside alidade-cli --version) == "alidade-cli $version ("*")" ]] || fail "alidade-cli is not on PATH, or of another version"
[[ $(inside alidade --version) == "alidade $version ("*")" ]] || fail "alidade is not on PATH, or of another version"

# As a user without rights outside the home folder.
inside useradd --create-home guest
inside runuser -u guest -- bash /tmp/as_user.sh "$id" || fail "an ordinary user cannot use it"
step "used"

inside dpkg -L alidade >"$folder/files"
apt purge alidade
step "removed"
# shellcheck disable=SC2016
left=$(inside bash -c 'while read -r path; do [[ ! -e $path || ( -d $path && $path != *alidade* ) ]] || echo "$path"; done' \
  <"$folder/files")
left+=$(inside find / -xdev \( -path /home -o -path /tmp -o -path /proc -o -path /var/log \) -prune -o -iname '*alidade*' -print)
left+=$(inside grep -rliw alidade /etc /usr/share/mime /usr/share/applications /var/lib/dpkg/info /var/lib/dpkg/status || true)
[[ -z $left ]] || fail "removing leaves: $left"
step "looked for what is left"
