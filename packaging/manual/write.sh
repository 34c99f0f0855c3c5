#!/usr/bin/env bash
# write.sh PROGRAM PAGE.in VERSION DATE FOLDER: writes the man page and completions of a program into the folder. They
# are generated from its help, so that they contain exactly its options.
set -euo pipefail
here=$(dirname -- "${BASH_SOURCE[0]}")
program=$1 page=$2 version=$3 date=$4 folder=$5
name=$(basename -- "$program")
export LC_ALL=C.UTF-8 QT_QPA_PLATFORM=offscreen

facts() { # a command or "-", then the call
  { printf '@ %s\n' "$1" && shift && "$@" --help; } | awk -f "$here/facts.awk"
}

mkdir -p -- "$folder"
work=$(mktemp -d "$folder/XXXXXX")
trap 'rm -rf -- "$work"' EXIT
facts - "$program" >"$work/facts"
mapfile -t commands < <(awk -F '\t' '$1 == "command" { print $2 }' "$work/facts")
for command in "${commands[@]}"; do
  facts "$command" "$program" "$command" >>"$work/facts"
done

awk -v VERSION="$version" -v DATE="$date" -f "$here/page.awk" "$work/facts" "$page" | gzip -9n >"$work/$name.1.gz"
awk -v PROGRAM="$name" -f "$here/bash.awk" "$work/facts" >"$work/$name.bash"
awk -v PROGRAM="$name" -f "$here/zsh.awk" "$work/facts" >"$work/_$name"
mv -f -- "$work/$name.1.gz" "$work/$name.bash" "$work/_$name" "$folder"
