#!/usr/bin/env bash
# Throws what nobody would type at the core, for a while.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
root=$(cd -- "$here/../.." && pwd)
build=$root/build/fuzz
targets=(session typing gsi csv angles truth records values talk formula)
unavailable=4

if [[ ${1:-} == -h || ${1:-} == --help ]]; then
  cat <<HELP
Usage: run.sh [TARGET] [SECONDS] [LIBFUZZER OPTION]...
       run.sh --build | --shrink
       run.sh --built TARGET [SECONDS] [LIBFUZZER OPTION]...

Builds the fuzz targets with clang (build/fuzz) and runs one of ${targets[*]} for SECONDS
(60 where none are given), or all of them, one after the other. It starts from tests/fuzz/corpus and keeps what it learns in
build/fuzz/corpus, so a later run goes on from there. What ends a target is kept in build/fuzz/findings; to see it again:
\`build/fuzz/bin/fuzz_TARGET FILE\`.

--build builds only, --built takes what is built. --shrink writes the smallest corpus that still reaches everything to tests/fuzz/corpus.

Exit code: 0 nothing found, 1 something found, 2 wrong call, $unavailable no clang with libFuzzer here.
HELP
  exit 0
fi

say() { printf '%s\n' "$*" >&2; }

clang_is_here() {
  command -v clang++ >/dev/null &&
    [[ -e $(clang++ -print-file-name="libclang_rt.fuzzer-$(uname -m).a") ||
      -e $(clang++ -print-resource-dir)/lib/linux/libclang_rt.fuzzer-$(uname -m).a ]]
}

build_targets() {
  if ! clang_is_here; then
    say "Not fuzzed: clang++ with libFuzzer is not here (Debian: clang, libclang-rt-14-dev)."
    exit "$unavailable"
  fi
  (cd -- "$root" && cmake --preset fuzz && cmake --build "$build") >&2
}

built_before() {
  [[ -x $build/bin/fuzz_${targets[-1]} ]] && return
  say "Not fuzzed: no targets are built in build/fuzz."
  exit "$unavailable"
}

# fuzz TARGET SECONDS [OPTION]...
fuzz() {
  local name=$1 seconds=$2 dictionary=$here/dictionaries/$1
  shift 2
  mkdir -p "$build/corpus/$name" "$build/findings"
  local options=(-max_total_time="$seconds" -timeout=60 -rss_limit_mb=3000 -error_exitcode=1 -timeout_exitcode=1
    -print_final_stats=1 -verbosity=1 -max_len="$(longest "$name")" -artifact_prefix="$build/findings/$name-")
  [[ ! -e $dictionary ]] || options+=(-dict="$dictionary")
  say "Fuzzing $name for $seconds s"
  "$build/bin/fuzz_$name" "${options[@]}" "$@" "$build/corpus/$name" "$here/corpus/$name" || {
    say "Found in $name: see build/fuzz/findings"
    return 1
  }
}

# Bytes of the longest input: what holds a session worth diagnosing, and no more.
longest() {
  case $1 in
    session) echo 8192 ;;
    angles) echo 64 ;;
    typing) echo 256 ;;
    *) echo 2048 ;;
  esac
}

shrink() {
  local name
  for name in "${targets[@]}"; do
    mkdir -p "$build/corpus/$name" "$build/small/$name"
    "$build/bin/fuzz_$name" -merge=1 -max_len="$(longest "$name")" "$build/small/$name" "$here/corpus/$name" "$build/corpus/$name"
    rm -f -- "$here/corpus/$name"/*
    mv -- "$build/small/$name"/* "$here/corpus/$name/"
  done
}

case ${1:-} in
  --build) build_targets && exit ;;
  --shrink) build_targets && shrink && exit ;;
esac

built=
if [[ ${1:-} == --built ]]; then
  built=1
  shift
fi
chosen=("${targets[@]}")
if [[ ${1:-} =~ ^[a-z]+$ ]]; then
  [[ " ${targets[*]} " == *" $1 "* ]] || { say "run.sh: no target $1: choose one of ${targets[*]}" && exit 2; }
  chosen=("$1")
  shift
fi
seconds=60
if [[ ${1:-} =~ ^[0-9]+$ ]]; then
  seconds=$1
  shift
fi
[[ ${1:--} == -* ]] || { say "run.sh: $1 is neither a target nor a number of seconds nor an option" && exit 2; }

if [[ -n $built ]]; then built_before; else build_targets; fi
found=0
for name in "${chosen[@]}"; do fuzz "$name" "$seconds" "$@" || found=1; done
exit "$found"
