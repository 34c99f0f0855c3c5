#!/usr/bin/env bash
# Every C++ file is as clang-format 14 writes it.
set -euo pipefail
# shellcheck source=tests/packaging/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

sources app core examples ui tests -- '*.h' '*.cpp' | xargs -r -d '\n' clang-format-14 --dry-run -Werror
