#!/usr/bin/env bash
# The 68 angles of the published table typed into the real window, a reading corrected, the session saved, the report
# written, the file opened again. Arguments: the workstation, the console program, the table, the session that is the same.
set -euo pipefail

workstation=$1 console=$2 table=$3 reference=$4
for tool in Xvfb openbox xdotool pdftotext; do
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

"$workstation" >"$work/out" 2>&1 &
started+=($!)
program=$!
wait_for "the window" window_named "Untitled.* — Alidade"
wait_for "the keyboard" xdotool getactivewindow
sleep 1
keys ctrl+n

# L, its σ, R0; then what is next: the pointing zero and the readings of either position.
typed 2405
typed 1
typed 400
angle() { sed "s/[°'\"]/ /g; s/ *$//" <<<"$1"; }
position() { # axis, α0, β0
  typed "$2"
  typed "$3"
  local axis horizontal vertical
  while IFS=, read -r axis _ horizontal vertical; do
    [[ $axis == "$1" ]] || continue
    typed "$(angle "${horizontal//\"/}")"
    typed "$(angle "${vertical//\"/}")"
  done < <(tail -n +2 "$table" | tr -d '\r')
}
keys F6
position 0 "332 32 54" "89 59 57"
keys alt+1
position 180 "332 32 50" "89 59 58"

# A reading is typed wrong, and right again.
correct() { # as it stands, as it shall
  keys ctrl+f
  typed "$1"
  keys Escape
  typed "$2"
}
correct "82 40 39" "82 40 49"
correct "82 40 49" "82 40 39"

session=$work/typed.alidade
keys ctrl+s
wait_for "the question where to save" window_named "Save session as"
typed "$session"
wait_for "the file" test -s "$session"
wait_for "the saved name" window_named "typed.alidade — Alidade"

keys ctrl+e
wait_for "the question what the report holds" window_named "Acceptance report"
keys Return
wait_for "the question where to write it" window_named "Export acceptance report"
typed "$work/report.pdf"
wait_for "the report" test -s "$work/report.pdf"
wait_for "the end of the dialog" no_window_named "Export acceptance report"

keys ctrl+q
for ((i = 0; i < 100; ++i)); do kill -0 "$program" 2>/dev/null && sleep 0.1; done
kill -0 "$program" 2>/dev/null && fail "the window did not close"

# The same numbers as from the session that is in the samples, and the correction in the journal.
intersection() {
  "$console" fit --no-diagnosis --json "$1" | python3 -c '
import json, sys
fit = json.load(sys.stdin)
print(len(fit["arcs"]), *(arc["readings"] for arc in fit["arcs"]), "%.9f" % fit["intersection"]["value_mm"])'
}
own=$(intersection "$session") other=$(intersection "$reference")
[[ $own == "$other" ]] || fail "typed: $own; in the samples: $other"
"$console" journal --json "$session" | python3 -c '
import json, sys
told = [(entry["from"], entry["to"]) for entry in json.load(sys.stdin)["entries"]]
expected = [("82 40 39", "82 40 49"), ("82 40 49", "82 40 39")]
sys.exit(0 if told == expected else "the journal tells " + str(told))'
pdftotext -layout "$work/report.pdf" "$work/report.txt"
grep -q "Journal of changes" "$work/report.txt" || fail "the report does not tell of the correction"

"$workstation" "$session" >>"$work/out" 2>&1 &
started+=($!)
wait_for "the session opened again" window_named "typed.alidade — Alidade"
[[ $(intersection "$session") == "$other" ]] || fail "opening it changed the file"
echo "typed, corrected, saved, reported and opened again: Δd = ${own##* } mm"
