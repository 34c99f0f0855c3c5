#!/usr/bin/env bash
# valgrind.sh PROGRAM SAMPLES: the console over each sample under valgrind, which must have nothing to say of memory.
set -euo pipefail
program=${1:?the console program}
samples=${2:?the folder of samples}
unavailable=4

command -v valgrind >/dev/null || { echo "Not checked: valgrind is not here (Debian: valgrind)." >&2 && exit "$unavailable"; }

under_valgrind() {
  valgrind --quiet --error-exitcode=9 --leak-check=full --errors-for-leak-kinds=definite "$program" "$@" >/dev/null
}

failed=0
for sample in "$samples"/*.alidade; do
  for call in fit diagnose plan; do
    under_valgrind "$call" "$sample" --json || { echo "$call of $(basename -- "$sample") is not clean" >&2 && failed=1; }
  done
done
exit "$failed"
