#!/usr/bin/env bash
set -euo pipefail
# shellcheck source=packaging/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/setup.sh"

if [[ ${1:-} == -h || ${1:-} == --help ]]; then
  cat <<'HELP'
Usage: package.sh

Installs what is missing (Debian 12; root or sudo), builds Alidade and makes its Debian package, whose path is
printed last. Install it with `sudo apt install PATH`, remove it with `sudo apt purge alidade`.
HELP
  exit 0
fi
(($# == 0)) || fail "there is nothing to be given; \`package.sh --help\` says what it does"

install_packages "$root/packaging/packages-build.txt" "$root/packaging/packages-package.txt"
# Looked at again: icons of fixed sizes need a program that may just have come.
configure release
cmake -S "$root" -B "$build" >&2
cmake --build "$build" --target alidade alidade-cli installed_files >&2

# The same sources give the same package.
if [[ -z ${SOURCE_DATE_EPOCH:-} ]] && last_change=$(git -C "$root" log -1 --format=%ct 2>/dev/null); then
  export SOURCE_DATE_EPOCH=$last_change
fi
folder=$build/package
rm -f -- "$folder"/alidade_*.deb
(cd -- "$build" && cpack -G DEB -B "$folder" >&2)
rm -rf -- "$folder/_CPack_Packages"
printf '%s\n' "$folder"/alidade_*.deb
