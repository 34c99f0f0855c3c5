#!/usr/bin/env bash
# The 68 angles of the published table typed into the real window, a reading corrected, the session saved, the report
# written and printed into a file, the session opened again. Arguments: the workstation, the console program, the table, the session that is the same.
set -euo pipefail

workstation=$1 console=$2 table=$3 reference=$4
command -v pdftotext >/dev/null || { echo "pdftotext is missing: nothing was tried" && exit 77; }
# shellcheck source=tests/desktop/desk.sh
source "$(dirname "$0")/desk.sh"

"$workstation" >"$work/out" 2>&1 &
started+=($!)
program=$!
wait_for "the window" window_named "Untitled.* — .*Alidade"
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
wait_for "the saved name" window_named "^typed.alidade — .*Alidade"

keys ctrl+e
wait_for "the question what the report holds" window_named "Acceptance report"
keys Return
wait_for "the question where to write it" window_named "Export acceptance report"
typed "$work/report.pdf"
wait_for "the report" test -s "$work/report.pdf"
wait_for "the end of the dialog" no_window_named "Export acceptance report"

keys ctrl+p
wait_for "the question what is printed" window_named "Acceptance report"
keys Return
wait_for "the question where it is printed" window_named "Print acceptance report"
sleep 0.5
keys alt+f ctrl+a
typed "$work/printed.pdf"
wait_for "the printed pages" test -s "$work/printed.pdf"
wait_for "the end of the printing" no_window_named "Print acceptance report"

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
pdftotext -layout "$work/printed.pdf" "$work/printed.txt"
diff <(sed 's/ [0-9][0-9]:[0-9][0-9]//' "$work/report.txt") <(sed 's/ [0-9][0-9]:[0-9][0-9]//' "$work/printed.txt") >"$work/differs" ||
  fail "what is printed differs from the report: $(head -4 "$work/differs")"

"$workstation" "$session" >>"$work/out" 2>&1 &
started+=($!)
wait_for "the session opened again" window_named "^typed.alidade — .*Alidade"
[[ $(intersection "$session") == "$other" ]] || fail "opening it changed the file"
echo "typed, corrected, saved, reported, printed and opened again: Δd = ${own##* } mm"
