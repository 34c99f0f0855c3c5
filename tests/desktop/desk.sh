# A desktop of its own for a test: display, window manager, folders, the keyboard. Sourced; `work` is removed at the end.
# shellcheck shell=bash

for tool in Xvfb openbox xdotool; do
  command -v "$tool" >/dev/null || { echo "$tool is missing: nothing was tried" && exit 77; }
done

work=$(mktemp -d)
export XDG_CONFIG_HOME=$work/config XDG_DATA_HOME=$work/data XDG_RUNTIME_DIR=$work QT_QPA_PLATFORM=xcb LC_ALL=C.UTF-8
chmod 700 "$work"
started=()
clean() {
  ((${#started[@]} == 0)) || kill "${started[@]}" 2>/dev/null || true
  wait 2>/dev/null || true
  rm -rf -- "$work"
}
trap clean EXIT

fail() {
  echo "$*"
  [[ ! -s $work/out ]] || sed 's/^/the window said: /' "$work/out"
  exit 1
}

wait_for() { # what it is, then the command that tells whether it is there
  local what=$1 i
  shift
  for ((i = 0; i < 300; ++i)); do
    if "$@" >/dev/null 2>&1; then return; fi
    sleep 0.1
  done
  fail "$what: not within 30 seconds"
}

window_named() { xdotool search --onlyvisible --name "$1"; }
no_window_named() { ! window_named "$1"; }
keys() { xdotool key --delay 20 "$@"; }
typed() { # a text, ended by Enter
  [[ -z $1 ]] || xdotool type --delay 8 -- "$1"
  keys Return
}

Xvfb -displayfd 3 -screen 0 1280x800x24 3>"$work/display" >/dev/null 2>&1 &
started+=($!)
wait_for "a display" test -s "$work/display"
DISPLAY=:$(cat "$work/display")
export DISPLAY
openbox >/dev/null 2>&1 &
started+=($!)
wait_for "a window manager" xdotool get_desktop
