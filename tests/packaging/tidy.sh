#!/usr/bin/env bash
# tidy.sh TREE BUILD FOLDER...: clang-tidy 14 over the sources of the folders that the build compiles, a process per core.
set -euo pipefail
# shellcheck source=tests/packaging/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
build=${2:?the build directory}
shift 2

sources "$@" -- '*.cpp' | while read -r file; do
  ! grep -qF "\"file\": \"$PWD/$file\"" "$build/compile_commands.json" || printf '%s\n' "$file"
done | xargs -r -d '\n' -n 1 -P "$(nproc)" clang-tidy-14 -p "$build" --quiet --extra-arg=-Wno-unknown-warning-option
