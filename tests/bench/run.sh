#!/usr/bin/env bash
set -euo pipefail
# shellcheck source=packaging/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../../packaging/setup.sh"

if [[ ${1:-} == -h || ${1:-} == --help ]]; then
  cat <<'HELP'
Usage: run.sh [GOOGLE BENCHMARK OPTION]...

Installs what is missing (Debian 12; root or sudo), builds Alidade and its benchmarks, times them and their peers
(Ceres, Ceres TinySolver, scipy.odr) on the same readings, and prints the table of speeds with ratios. Takes some
two minutes. Options go to alidade_speed: `run.sh --benchmark_filter='W6|W7'` times the general fit and the
diagnosis alone.
HELP
  exit 0
fi

install_packages "$root/packaging/packages-build.txt" "$root/tests/bench/packages.txt"
cmake --preset release -DALIDADE_BENCHMARKS=ON -S "$root" >&2
cmake --build "$build" --target alidade_speed alidade-cli >&2

results=$(mktemp -d)
trap 'rm -rf -- "$results"' EXIT
speed="$root/tests/bench/speed"
"$build/bin/alidade_speed" --benchmark_repetitions=5 --benchmark_min_time=0.2 --benchmark_enable_random_interleaving=true \
  --benchmark_report_aggregates_only=true --benchmark_out="$results/speed.json" --benchmark_out_format=json "$@" >&2
"$build/bin/alidade_speed" --readings "$results"
python=/usr/bin/python3  # the one that Debian's scipy belongs to, whatever comes first in the path
"$python" "$speed/peer_scipy.py" "$results" >"$results/scipy.json"
"$python" "$speed/table.py" "$results/speed.json" "$results/scipy.json" "$build/bin/alidade-cli" \
  "$root/samples/paper-table-1.alidade" "$speed/peer_scipy.py"
