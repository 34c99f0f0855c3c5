#!/usr/bin/env bash
# any_prefix.sh BUILD CMAKE: both programs run after `cmake --install` under a prefix that is then moved.
set -euo pipefail
# shellcheck source=tests/packaging/package/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
build=$1 cmake=$2
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
export HOME=$work/home XDG_CONFIG_HOME=$work/home/config XDG_DATA_HOME=$work/home/data
mkdir -p "$HOME"

runs_from() {
  local prefix=$1 sample=$1/share/alidade/samples/paper-table-1.alidade
  (
    cd /
    fit=$("$prefix/bin/alidade-cli" fit "$sample" --no-diagnosis) || fail "alidade-cli fit from $prefix"
    [[ $fit == *'Δd'* ]] || fail "alidade-cli fit from $prefix says: $fit"
    "$prefix/bin/alidade" --report "$work/report.pdf" "$sample" || fail "alidade --report from $prefix"
  )
  [[ $(head -c 5 "$work/report.pdf") == %PDF- ]] || fail "the report written from $prefix is no PDF"
  rm -- "$work/report.pdf"
}

"$cmake" --install "$build" --prefix "$work/first place" >"$work/log" || fail "$(cat "$work/log")"
runs_from "$work/first place"
mv -- "$work/first place" "$work/second"
runs_from "$work/second"

# Where shells look under such a prefix.
for file in bash-completion/completions/alidade-cli zsh/site-functions/_alidade-cli man/man1/alidade-cli.1.gz; do
  [[ -s $work/second/share/$file ]] || fail "share/$file is missing"
done

# No path refers to the build.
for program in alidade alidade-cli; do
  ! grep -E 'RPATH|RUNPATH' < <(readelf -d "$work/second/bin/$program") || fail "$program looks for libraries where it was built"
done
! grep -rlF -e "$build" "$work/second/share" || fail "these files name the build"
