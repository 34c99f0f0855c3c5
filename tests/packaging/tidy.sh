#!/usr/bin/env bash
# tidy.sh TREE BUILD quick|all FOLDER...: clang-tidy 14 for the sources of the folders that the build
# compiles, one process per processor. `quick` leaves out the checks that cost most for their findings. A
# source that passed is checked again after a change of it, of an included header or of the rules.
set -euo pipefail
self=$(realpath -- "${BASH_SOURCE[0]}")
# shellcheck source=tests/packaging/lib.sh
source "$(dirname -- "$self")/lib.sh"
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
# The commands that compile each source by itself, without precompiled headers of g++, which clang cannot
# read.
alone=$build/tidy/alone
cmake -S . -B "$alone" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DALIDADE_TESTS=ON \
  -DALIDADE_FUZZ_SECONDS=0 -DALIDADE_BY_ROOM=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null

# The files of the tree from which each source was compiled, with its folder, as the build knows them: lines
# of source, tab, file.
compiled_from() {
  ninja -C "$build" -t deps | awk -v root="$PWD/" '
    /#deps/ || !NF {
      for (s in sources) for (f in files) print s "\t" f
      delete sources
      delete files
      next
    }
    {
      file = substr($0, 5)
      if (index(file, root) == 1) file = substr(file, length(root) + 1)
      else if (!sub(/^(\.\.\/)+/, "", file)) next
      files[file]
      if (file ~ /\.cpp$/) sources[file]
    }'
}

declare -A needs=()
while IFS=$'\t' read -r source file; do needs[$source]+=$file$'\n'; done < <(compiled_from)

# True if a file passed after the last change of it, of an included header and of the rules.
still_passes() {
  local stamp=$passed/${1//\//_} files
  [[ -e $stamp && -n ${needs[$1]:-} ]] || return 1
  mapfile -t files <<<"${needs[$1]%$'\n'}"
  [[ -z $(find "${files[@]}" .clang-tidy "$self" -newer "$stamp" -print -quit) ]]
}

look_at() {
  clang-tidy-14 -p "$1" --quiet --extra-arg=-Wno-unknown-warning-option "${@:4}" "$3" 2> >(grep -v 'warnings\? generated' >&2) &&
    touch -- "$2/${3//\//_}"
}
export -f look_at

sources "$@" -- '*.cpp' | while read -r file; do
  grep -qF "\"file\": \"$PWD/$file\"" "$alone/compile_commands.json" || continue
  still_passes "$file" || printf '%s\n' "$file"
done | xargs -r -d '\n' -I '{}' -P "$(nproc)" bash -c 'look_at "$@"' - "$alone" "$passed" '{}' "${checks[@]}"
