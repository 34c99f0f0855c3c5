#!/usr/bin/env bash
# tidy.sh TREE BUILD quick|all FOLDER...: clang-tidy 14 over the sources of the folders that the build compiles, a process
# per processor. `quick` leaves out what costs most for what it finds. A source that passed is looked at again when it, a
# header or the rules changed.
set -euo pipefail
# shellcheck source=tests/packaging/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
build=${2:?the build directory}
extent=${3:?quick or all}
shift 3

quick='-*,bugprone-dangling-handle,bugprone-infinite-loop,bugprone-integer-division,bugprone-use-after-move'
quick+=',performance-for-range-copy,performance-unnecessary-copy-initialization,performance-unnecessary-value-param'
quick+=',readability-container-size-empty,readability-identifier-naming'
checks=()
[[ $extent == all ]] || checks=("--checks=$quick")

passed=$build/tidy/$extent
mkdir -p -- "$passed"
mapfile -t shared < <(sources app core ui tests -- '*.h' tidy.sh && echo .clang-tidy)

# Whether a file passed since it, every header and the rules last changed.
still_passes() {
  local stamp=$passed/${1//\//_} changed
  [[ -e $stamp ]] || return 1
  changed=$(find "$1" "${shared[@]}" -newer "$stamp" -print -quit)
  [[ -z $changed ]]
}

look_at() {
  clang-tidy-14 -p "$1" --quiet --extra-arg=-Wno-unknown-warning-option "${@:4}" "$3" 2> >(grep -v 'warnings\? generated' >&2) &&
    touch -- "$2/${3//\//_}"
}
export -f look_at

sources "$@" -- '*.cpp' | while read -r file; do
  grep -qF "\"file\": \"$PWD/$file\"" "$build/compile_commands.json" || continue
  still_passes "$file" || printf '%s\n' "$file"
done | xargs -r -d '\n' -I '{}' -P "$(nproc)" bash -c 'look_at "$@"' - "$build" "$passed" '{}' "${checks[@]}"
