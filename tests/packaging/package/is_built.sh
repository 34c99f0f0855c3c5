#!/usr/bin/env bash
# is_built.sh BUILD FOLDER CPACK: CPack makes a Debian package of the build without a warning.
set -euo pipefail
# shellcheck source=tests/packaging/package/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
build=$1 folder=$2 cpack=$3
needs dpkg-deb dpkg-shlibdeps

mkdir -p -- "$folder"
rm -f -- "$folder"/alidade_*.deb
cd -- "$build"
"$cpack" -G DEB -B "$folder" 2>&1 | tee "$folder/log"
! grep -i warning "$folder/log" || fail "CPack warns"
package_in "$folder"
rm -rf -- "$folder/_CPack_Packages"
