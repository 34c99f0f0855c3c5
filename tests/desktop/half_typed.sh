#!/usr/bin/env bash
# Sixty words typed into the notes of the real window and not handed in. Each signal that a desktop or a terminal sends
# ends the window; every word is kept, and the next start offers them. Argument: the workstation.
set -euo pipefail

workstation=$1
# shellcheck source=tests/desktop/desk.sh
source "$(dirname "$0")/desk.sh"

words=$(printf 'word%02d ' {1..60})
words=${words% }

open_notes() {
  env --default-signal=INT "$workstation" >>"$work/out" 2>&1 &  # the shell has it ignored in the background
  program=$!
  started+=("$program")
  wait_for "the window" window_named "Alidade"
  wait_for "the keyboard" xdotool getactivewindow
}

kept_words() {
  cat "$XDG_DATA_HOME"/*/*/unsaved/*.unsaved.typed 2>/dev/null | grep '"field":"notes"' | grep -o 'word[0-9][0-9]' |
    sort -u | wc -l
}

for signal in TERM HUP INT KILL; do
  open_notes
  sleep 1
  keys ctrl+n
  keys alt+s alt+i  # the form with the title
  keys Tab Tab Tab Tab Tab Tab Tab Tab  # its last entry
  xdotool type --delay 4 -- "$words"
  sleep 0.2  # until the last key has arrived
  [[ $signal != KILL ]] || sleep 1
  kill -s "$signal" "$program"
  wait "$program" 2>/dev/null && fail "$signal: the program ended as if nobody had asked it to"
  count=$(kept_words)
  echo "$signal: $count of 60 words kept"
  [[ $count == 60 ]] || fail "$signal: $count of 60 words kept"
  if [[ $signal == KILL ]]; then
    "$workstation" >>"$work/out" 2>&1 &
    started+=($!)
    wait_for "the offer" window_named "Unsaved changes were kept"
  fi
  rm -rf -- "$XDG_DATA_HOME"
done
