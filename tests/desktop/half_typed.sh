#!/usr/bin/env bash
# Sixty words typed into the notes of the real window and not handed in. The window is ended by each signal that a
# desktop or a terminal sends, and by losing its display; the next start offers every word. Argument: the workstation.
set -euo pipefail

workstation=$1
# shellcheck source=tests/desktop/desk.sh
source "$(dirname "$0")/desk.sh"

words=$(printf 'word%02d ' {1..60})
words=${words% }

open_notes() {
  "$workstation" >>"$work/out" 2>&1 &
  program=$!
  started+=("$program")
  wait_for "the window" window_named "Alidade"
  wait_for "the keyboard" xdotool getactivewindow
}

kept_words() {
  cat "$XDG_DATA_HOME"/*/*/unsaved/*.unsaved.typed 2>/dev/null | grep -o 'word[0-9][0-9]' | sort -u | wc -l
}

for signal in TERM HUP INT KILL; do
  open_notes
  sleep 1
  keys ctrl+n
  keys alt+i      # the form with the title; the notes are the last entry of it
  xdotool type --delay 4 -- "$words"
  [[ $signal != KILL ]] || sleep 1
  kill -s "$signal" "$program"
  wait "$program" 2>/dev/null && fail "$signal: the program ended as if nobody had asked it to"
  count=$(kept_words)
  echo "$signal: $count of 60 words kept"
  [[ $count == 60 ]] || fail "$signal: $count of 60 words kept"
  rm -rf -- "$XDG_DATA_HOME"
done
