#!/usr/bin/env bash
# tidy.sh TREE BUILD quick|all FOLDER...: clang-tidy 14 for what the build compiles of the folders, one process per
# processor. Sources are looked at room by room, as they are compiled, so that what they all include is read once.
# `quick` leaves out the checks that cost most for their findings, and two rooms of three, the others at the next
# commits. A room that passed is checked again after a change
# of it, of an included header or of the rules.
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
checks=$quick
[[ $extent != all ]] || checks=-bugprone-suspicious-include  # a room includes its sources

passed=$build/tidy/$extent
mkdir -p -- "$passed"
# The commands without precompiled headers of g++, which clang cannot read.
rooms=$build/tidy/rooms
cmake -S . -B "$rooms" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DALIDADE_TESTS=ON \
  -DALIDADE_FUZZ_SECONDS=0 -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null

# The files of the tree from which the build made each object: lines of object, tab, file.
compiled_from() {
  ninja -C "$build" -t deps | awk -v root="$PWD/" '
    /#deps/ { object = $1; sub(/:$/, "", object); next }
    NF {
      file = $1
      if (index(file, root) == 1 && sub(root, "", file) || sub(/^(\.\.\/)+/, "", file)) print object "\t" file
    }'
}

declare -A needs=()
while IFS=$'\t' read -r object file; do needs[$object]+=$file$'\n'; done < <(compiled_from)

# True if what became the object passed after the last change of it, of an included header and of the rules.
still_passes() {
  local stamp=$passed/${1//\//_} files
  [[ -e $stamp && -n ${needs[$1]:-} ]] || return 1
  mapfile -t files <<<"${needs[$1]%$'\n'}"
  [[ -z $(find "${files[@]}" .clang-tidy "$self" -newer "$stamp" -print -quit) ]]
}

# A room compiles its sources as one. A local name in one source may equal a name in another without hiding it.
look_at() {
  clang-tidy-14 -p "$1" --quiet --extra-arg=-Wno-unknown-warning-option --extra-arg=-Wno-shadow "--checks=$2" "$4" \
    2> >(grep -v 'warnings\? generated' >&2) && touch -- "$3"
}
export -f look_at

# What the build compiles of the folders: lines of object, tab, room or single source. What Qt generates is not ours.
compiled() {
  python3 - "$rooms" "$PWD" "$@" <<'READ'
import json, re, sys
build, tree, *folders = sys.argv[1:]
for entry in json.load(open(f"{build}/compile_commands.json")):
    source = entry["file"]
    below = re.sub(f"^({re.escape(build)}|{re.escape(tree)})/", "", source)
    if below.split("/")[0] in folders and not re.search(r"_autogen/|/\.rcc/", below):
        print(re.search(r" -o (\S+)", entry["command"])[1], source, sep="\t")
READ
}

due() {
  if [[ $extent == all ]]; then cat; else awk -v commits="$(git rev-list --count HEAD 2>/dev/null)" '(NR + commits) % 3 == 0'; fi
}

compiled "$@" | due | while IFS=$'\t' read -r object source; do
  still_passes "$object" || printf '%s\n%s\n' "$passed/${object//\//_}" "$source"
done | xargs -r -d '\n' -n 2 -P "$(nproc)" bash -c 'look_at "$@"' - "$rooms" "$checks"
