#!/usr/bin/env bash
set -euo pipefail
# shellcheck source=packaging/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/setup.sh"

help() {
  cat <<'HELP'
Usage: run.sh [SESSION.alidade] [OPTION]...

Installs what is missing (Debian 12; root or sudo), builds Alidade and opens the session in its window; without
one, the measurement of the paper, samples/paper-table-1.alidade. Without a display it prints the fit of the
session and writes the acceptance report to build/acceptance-report.pdf instead. Options go to `alidade`:
`run.sh --report OUT.pdf SESSION.alidade` writes a report to a place of your own.
HELP
}

# Whether an X server or a Wayland compositor is likely to answer; a dead address must not hold up the start.
display_answers() {
  [[ -S ${XDG_RUNTIME_DIR:-/nowhere}/${WAYLAND_DISPLAY:-none} || -S ${WAYLAND_DISPLAY:-none} ]] && return 0
  local host=${DISPLAY:-} number
  [[ $host =~ ^(.*):([0-9]+)(\.[0-9]+)?$ ]] || return 1
  host=${BASH_REMATCH[1]} number=${BASH_REMATCH[2]}
  if [[ -z $host || $host == unix ]]; then
    grep -qE "/tmp/\.X11-unix/X$number\$" /proc/net/unix 2>/dev/null || [[ -S /tmp/.X11-unix/X$number ]]
  else
    # shellcheck disable=SC2016
    timeout 3 bash -c 'exec 3<>"/dev/tcp/$1/$2"' - "$host" "$((6000 + number))" 2>/dev/null
  fi
}

# Opens the window. Fails with 75 where Qt found no display after all; otherwise with the program's own code.
open_window() {
  local log code=0
  log=$(mktemp)
  "$build/bin/alidade" "$@" 2> >(tee "$log" >&2) || code=$?
  ((code == 0)) || ! grep -q 'could not connect to display\|no Qt platform plugin could be initialized' "$log" || code=75
  rm -f -- "$log"
  return "$code"
}

without_window() {
  local report="$root/build/acceptance-report.pdf"
  "$build/bin/alidade-cli" fit "$1"
  "$build/bin/alidade" --report "$report" "$1"
  printf '\nNo display here, so no window: the fit is printed above and the acceptance report is %s\n' "$report"
}

arguments=("$@")
session=
wants_window=yes
while (($#)); do
  case $1 in
    -h | --help) help && exit 0 ;;
    --report) wants_window=no && shift ;;
    --report=* | -v | --version) wants_window=no ;;
    -platform | -style | -geometry | -display) shift ;;
    -?*) ;;
    *) session=$1 ;;
  esac
  (($# == 0)) || shift
done
if [[ -z $session ]]; then
  session="$root/samples/paper-table-1.alidade"
  arguments+=("$session")
fi

install_packages "$root/packaging/packages-build.txt"
configure release
cmake --build "$build" --target alidade alidade-cli >&2

if [[ $wants_window == no ]]; then
  exec "$build/bin/alidade" "${arguments[@]}"
fi
if display_answers; then
  code=0
  open_window "${arguments[@]}" || code=$?
  ((code == 75)) || exit "$code"
fi
without_window "$session"
