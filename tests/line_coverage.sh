#!/usr/bin/env bash
# line_coverage.sh [BUILD]: runs the tests of a build made with `cmake --preset coverage` and prints which share of the
# lines of core and ui they run, and the ten files with the most lines they do not. Fails below 95 % of the core or 85 % of
# the ui, or where a test fails. Tests that measure time, memory or a full disk are left out, since counting takes of all
# three, and so are the longest draws, which run no other lines than the short ones.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
build=${1:-$root/build/coverage}

command -v gcovr >/dev/null || { echo "gcovr is not here (Debian: gcovr)" >&2 && exit 4; }
cd -- "$root"
find "$build" -name '*.gcda' -delete
export QT_QPA_PLATFORM=offscreen GTEST_TOTAL_SHARDS
GTEST_TOTAL_SHARDS=$(nproc)
left_out='-Load.*:*TimeInProportion*:*DiskIsFull*:*EveryState*:*EveryGeometry*'
tests=0
for program in core console ui replay; do
  executable=$(find "$build/tests" -name "alidade_${program}_tests" -type f -perm -u+x)
  shards=()
  for ((shard = 0; shard < GTEST_TOTAL_SHARDS; ++shard)); do
    GTEST_SHARD_INDEX=$shard "$executable" --gtest_brief=1 --gtest_filter="$left_out" >&2 &
    shards+=("$!")
  done
  for shard in "${shards[@]}"; do wait "$shard" || tests=1; done
done
[[ $tests == 0 ]] || echo "Tests fail in this build: see above" >&2

# room FOLDER LEAST: a table of its files, the worst first, and their sum; fails where less than LEAST % is run.
room() {
  local table least=$2
  table=$(gcovr --root "$root" --object-directory "$build" --exclude-directories '.*CompilerIdCXX.*' \
    --filter "$root/$1/" --gcov-ignore-parse-errors --csv=- "$build")
  printf '%s: ' "$1"
  awk -F, -v least="$least" '
    NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
    { all += $column["line_total"]; run += $column["line_covered"] }
    END { share = 100 * run / all
          printf "%.1f %% of %d lines, %.0f %% wanted\n", share, all, least
          exit share < least }' <<<"$table" || tests=1
  awk -F, '
    NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
    { printf "%d\t%s\n", $column["line_total"] - $column["line_covered"], $column["filename"] }' <<<"$table" |
    sort -rn | head -n 10 | awk '$1 > 0 { printf "  %5d lines not run  %s\n", $1, $2 }'
}

room core 95
room ui 85
exit "$tests"
