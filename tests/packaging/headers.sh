#!/usr/bin/env bash
# headers.sh TREE COMPILER EIGEN headers|sources|sample: core headers without a source file compile by themselves, or
# sources of the core and the console do, which the build compiles room by room: all, or a twelfth, another one at the
# next commit. A source includes its header first (includes.sh).
set -euo pipefail
# shellcheck source=tests/packaging/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
compiler=${2:?the compiler}
eigen=${3:?the folder of Eigen}

files() {
  case ${1:?headers, sources or sample} in
    headers) sources core -- '*.h' | while read -r header; do [[ -e ${header%.h}.cpp ]] || printf '%s\n' "$header"; done ;;
    sources) sources core app/console -- '*.cpp' ;;
    sample) files sources | awk -v commits="$(git rev-list --count HEAD 2>/dev/null)" '(NR + commits) % 12 == 0' ;;
  esac
}

compile() {
  "$1" -std=c++20 -I. -isystem "$2" -Wall -Wextra -Werror -fsyntax-only -x c++ - <<<"#include \"$3\"" ||
    { echo "$3 does not compile by itself" && exit 1; }
}
export -f compile

files "${4:-}" | xargs -r -d '\n' -n 1 -P "$(nproc)" bash -c 'compile "$@"' - "$compiler" "$eigen"
