#!/usr/bin/env bash
set -euo pipefail
# shellcheck source=packaging/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/setup.sh"

if [[ ${1:-} == -h || ${1:-} == --help ]]; then
  cat <<'HELP'
Usage: test.sh [CTEST OPTION]...

Installs what is missing (Debian 12; root or sudo), builds Alidade with its tests and runs all of them through
ctest, without a display. Options go to ctest: `test.sh -R Angle` runs the tests with Angle in their name,
`test.sh -N` lists them. Ends with ctest's exit code.
HELP
  exit 0
fi

install_packages "$root"/packaging/packages-{build,package,test}.txt
configure test
cmake --build "$build" >&2

export QT_QPA_PLATFORM=offscreen
cd -- "$root"
exec ctest --preset test -j "$(nproc)" "$@"
