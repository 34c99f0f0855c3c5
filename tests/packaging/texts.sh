#!/usr/bin/env bash
# The list of translations contains exactly the texts of the sources.
set -euo pipefail
root=${1:?the tree to check}
lupdate=${2:?the tool of Qt that collects texts}
list=resources/languages/alidade_zh_CN.ts
fresh=$(mktemp --suffix=.ts)
trap 'rm -f -- "$fresh"' EXIT
bash "$root/packaging/texts.sh" "$lupdate" "$root/$list" "$fresh" 2>/dev/null
diff -u "$root/$list" "$fresh" ||
  { echo "$list is not in line with the sources: cmake --build build/release --target texts, then translate what is unfinished" && exit 1; }
