# Shared by the tests of the package. Sourced by them, not run.
# shellcheck shell=bash

export LC_ALL=C.UTF-8 QT_QPA_PLATFORM=offscreen
unset DISPLAY WAYLAND_DISPLAY

skip() {
  printf '%s: nothing was tried\n' "$*"
  exit 77
}

fail() {
  printf '%s\n' "$*"
  exit 1
}

needs() { # programs
  local program
  for program in "$@"; do
    command -v "$program" >/dev/null || PATH=$PATH:/usr/sbin:/sbin command -v "$program" >/dev/null || skip "$program is missing"
  done
}

# The only package in the folder.
package_in() {
  local found=("$1"/alidade_*.deb)
  [[ -f ${found[0]} ]] || skip "$1 holds no package"
  ((${#found[@]} == 1)) || fail "$1 holds more than one package: ${found[*]}"
  printf '%s\n' "${found[0]}"
}
