#!/usr/bin/env bash
# version.sh TREE CMAKE: the version's source names the commit, changes beside it, or an archive, and stays as it is
# while these do.
set -euo pipefail
tree=${1:?the tree to check}
cmake=${2:?CMake}
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_NOSYSTEM=1
git() { command git -C "$work/outer/inner" -c user.name=n -c user.email=e "$@"; }
failed=0

# writes BUILD WHY: what the source says is the build.
writes() {
  "$cmake" "-DSOURCE=$work/outer/inner" -DVERSION=1.2.3 "-DOUT=$work/version.cpp" -P "$tree/core/base/version.cmake"
  if ! grep -qF 'programVersion = "1.2.3"' "$work/version.cpp" || ! grep -qF "programBuild = \"$1\";" "$work/version.cpp"; then
    echo "not $1 $2:" && cat "$work/version.cpp" && failed=1
  fi
}

mkdir -p "$work/outer/inner/core/base"
cp "$tree/core/base/version.cpp.in" "$work/outer/inner/core/base/"
command git -C "$work/outer" init -q
writes archive "unpacked inside the repository of something else"
git init -q && git add . && git commit -qm one
commit=$(git rev-parse --short=12 HEAD)
writes "$commit" "of a commit"
touch -d '2000-01-01' "$work/version.cpp"
writes "$commit" "of the same commit"
[[ $(date -r "$work/version.cpp" +%Y) == 2000 ]] || { echo "written anew without a change" && failed=1; }
echo >>"$work/outer/inner/core/base/version.cpp.in"
writes "$commit+changes" "with a change"
exit "$failed"
