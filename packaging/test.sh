#!/usr/bin/env bash
set -euo pipefail
# shellcheck source=packaging/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/setup.sh"

if [[ ${1:-} == -h || ${1:-} == --help ]]; then
  cat <<'HELP'
Usage: test.sh [--all] [CTEST OPTION]...

Installs what is missing (Debian 12; root or sudo), builds Alidade with its tests and runs them through ctest,
without a display. Ends with ctest's exit code.

By default it leaves out the tests labelled `long`, of which samples run: about ten minutes on two cores after
run.sh. --all runs every test, so it adds fuzzing, thousands of states of a session, clang-tidy, sources each by
itself and the package in a clean root; it also builds the benchmarks. That takes about 45 minutes on two cores from
nothing.

Options go to ctest: `test.sh -R Angle` runs the tests with Angle in their name, `test.sh --all -N` lists all.
HELP
  exit 0
fi

target=alidade_tests
choice=(--label-exclude '^long$')
if [[ ${1:-} == --all ]]; then
  target=all
  choice=()
  shift
fi

install_packages "$root"/packaging/packages-{build,package,test}.txt
configure test
cmake --build "$build" --target "$target" >&2

export QT_QPA_PLATFORM=offscreen
cd -- "$root"
# One more than there are processors: tests of the window often wait.
exec ctest --preset test -j "$(($(nproc) + 1))" "${choice[@]}" "$@"
