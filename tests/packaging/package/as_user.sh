#!/usr/bin/env bash
# as_user.sh ID: a user's actions with the installed programs, without a display.
set -euo pipefail
id=$1
samples=/usr/share/alidade/samples
export HOME LC_ALL=C.UTF-8 QT_QPA_PLATFORM=offscreen
HOME=$(getent passwd "$(id -un)" | cut -d : -f 6)
cd -- "$HOME"

fail() {
  printf '%s\n' "$*"
  exit 1
}

fit=$(alidade-cli fit --json "$samples/paper-table-1.alidade")
[[ $fit == *'"value_mm": 1.3078'* ]] || fail "the fit of the paper's measurement does not give 1.3078 mm: $fit"
alidade-cli self-test >check || fail "the self-test fails: $(grep '^ *failed' check)"
[[ $(tail -n 1 check) == 'This installation passes: '* ]] || fail "the self-test ends with $(tail -n 1 check)"
grep -q '^ *passed  alidade/samples/two-faces.alidade ' check || fail "the self-test does not see what is installed"
alidade --self-test check.pdf >check || fail "the self-test of the window fails: $(cat check)"
[[ $(head -c 5 check.pdf) == %PDF- ]] || fail "the self-test writes no PDF"
man -w alidade alidade-cli >/dev/null || fail "man knows no page"
for language in en zh_CN; do
  alidade --language "$language" --report "$language.pdf" "$samples/clean-session.alidade"
  [[ $(head -c 5 "$language.pdf") == %PDF- ]] || fail "the report in $language is no PDF"
done

# A session is recognised by its name, and without one by its contents.
cp -- "$samples/two-faces.alidade" session.alidade
cp -- session.alidade nameless
for file in session.alidade nameless; do
  kind=$(gio info -a standard::content-type "$file" | sed -n 's/^ *standard::content-type: //p')
  [[ $kind == application/x-alidade-session ]] || fail "$file is taken for $kind"
done

kind=$(gio info -a standard::content-type "$samples/t-1.alidade-instrument" | sed -n 's/^ *standard::content-type: //p')
[[ $kind == application/x-alidade-instrument ]] || fail "an instrument record is taken for $kind"

# A double click: the desktop finds the program, which opens the file and lists it among the recent ones.
[[ $(gio mime application/x-alidade-session) == *"$id.desktop"* ]] || fail "no program opens a session"
gio open session.alidade 2>opened || fail "opening: $(cat opened)"
for ((i = 0; i < 300; ++i)); do
  ! grep -qs "recentFiles=$HOME/session.alidade" .config/Alidade/alidade.conf || break
  sleep 0.1
done
((i < 300)) || fail "the window has not opened the session within 30 s: $(cat opened)"
programs=()
for process in /proc/[0-9]*; do
  [[ $(readlink "$process/exe" || true) != /usr/bin/alidade ]] || programs+=("${process#/proc/}")
done
((${#programs[@]} == 1)) || fail "${#programs[@]} windows run after one click: $(cat opened)"
kill "${programs[0]}"

# The start page, without a file.
code=0
timeout 5 alidade >started 2>&1 || code=$?
((code == 124)) || fail "the window ends with $code: $(cat started)"
