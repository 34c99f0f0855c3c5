# Shared by the rule checks. Sourced by them, not run.
# shellcheck shell=bash

cd -- "${1:?the tree to check}" || exit 2

# Files of the repository below the given folders that match the given patterns, without builds.
sources() {
  local folders=() patterns=()
  while [[ $1 != -- ]]; do folders+=("$1") && shift; done
  shift
  for pattern in "$@"; do patterns+=(-o -name "$pattern"); done
  local folder
  for folder in "${folders[@]}"; do
    [[ ! -e $folder ]] || find "$folder" \( -path ./.git -o -path ./build \) -prune -o -type f \( "${patterns[@]:1}" \) -print
  done | sort
}

# Fails with the given complaints, one per line on stdin; passes without any.
report() {
  local complaints
  complaints=$(cat)
  [[ -z $complaints ]] || { printf '%s\n' "$complaints" && exit 1; }
}
