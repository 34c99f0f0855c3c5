#!/usr/bin/env bash
set -euo pipefail
# shellcheck source=packaging/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../../packaging/setup.sh"

install_packages "$root/packaging/packages-build.txt" "$root/packaging/packages-test.txt" "$root/tests/mutants/packages.txt"
# Debian's, whatever comes first in the path; no bytecode among the sources.
exec /usr/bin/python3 -B "$root/tests/mutants/small_faults.py" "$@"
