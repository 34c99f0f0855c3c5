#!/usr/bin/env bash
# Core headers without a source file compile by themselves; a source file includes its header first
# (includes.sh).
set -euo pipefail
# shellcheck source=tests/packaging/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
compiler=${2:?the compiler}
eigen=${3:?the folder of Eigen}

failed=0
while read -r header; do
  [[ -e ${header%.h}.cpp ]] || "$compiler" -std=c++20 -I. -isystem "$eigen" -Wall -Wextra -Werror -fsyntax-only -x c++ - <<<"#include \"$header\"" ||
    { echo "$header does not compile by itself" && failed=1; }
done < <(sources core -- '*.h')
exit "$failed"
