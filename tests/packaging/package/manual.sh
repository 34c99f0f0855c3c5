#!/usr/bin/env bash
# manual.sh PROGRAM FOLDER: the man page and both shells include every command and option of the help, command
# by command.
set -euo pipefail
# shellcheck source=tests/packaging/package/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
program=$(realpath -- "$1") folder=$(realpath -- "$2")
name=$(basename -- "$program")
needs man zsh
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
checked=0

page=$(MANWIDTH=100 man -E UTF-8 -l "$folder/$name.1.gz" | sed 's/.\x08//g')

# The section of a command, from its usage to the next one; without a command, the part before those.
section() {
  if [[ -z $1 ]]; then
    sed -n '/^OPTIONS/,/^[A-Z]/{/^ /p}' <<<"$page"
  else
    awk -v head="   $name $1 " 'index($0 " ", head) == 1 { inside = 1; next } /^ ? ? ?[A-Za-z]/ { inside = 0 } inside' <<<"$page"
  fi
}

# The completions of bash for the words typed; the last is the one at the cursor.
by_bash() {
  bash -c 'source "$1" && name=$2 && shift 2 && COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) && "_${name//-/_}" &&
    printf "%s\n" "${COMPREPLY[@]}"' - "$folder/$name.bash" "$name" "$@"
}

# The completions of zsh: the arguments of _arguments, and the list passed to _describe.
by_zsh() {
  # shellcheck disable=SC2016
  zsh -f -c 'file=$1; shift; words=("$@"); CURRENT=$#
    _arguments() { print -rl -- "$@" }
    eval "$(sed "s/^_[a-z_]* \"\$@\"\$//" $file)"
    '"_${name//-/_}" - "$folder/_$name" "$@" | sed -E 's/^\*//; s/[=[].*//'
}

# The lines of an option in the help begin with two blanks and a hyphen.
options_of() { sed -nE 's/^  (-[^ ,]*(, ?--[^ ]+)?).*/\1/p' | sed 's/{.*//' | tr -s ', ' '\n'; }

check() { # the command, or nothing
  local words=("$name") option offered_by_bash offered_by_zsh text
  [[ -z $1 ]] || words+=("$1")
  "$program" ${1:+"$1"} --help | options_of >"$work/options"
  text=$(section "$1")
  offered_by_bash=$(by_bash "${words[@]}" -)
  offered_by_zsh=$(by_zsh "${words[@]}" -)
  while read -r option; do
    grep -qE -- "^ *(-[a-z], )?$option( |,|\$)" <<<"$text" || fail "$name.1 has no $option of ${words[*]}"
    grep -qxF -- "$option" <<<"$offered_by_bash" || fail "bash offers no $option after ${words[*]}"
    grep -qxF -- "$option" <<<"$offered_by_zsh" || fail "zsh offers no $option after ${words[*]}"
    ((++checked))
  done <"$work/options"
  [[ $(wc -l <<<"$offered_by_bash") == "$(wc -l <"$work/options")" ]] || fail "bash offers what ${words[*]} does not have"
}

check ''
"$program" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p' >"$work/commands"
while read -r command; do
  grep -qE "^   $name $command " <<<"$page" || fail "$name.1 has no $command"
  grep -qx "$command" < <(by_bash "$name" '') || fail "bash offers no $command"
  grep -q "^    '$command:" "$folder/_$name" || fail "zsh offers no $command"
  check "$command"
  ((++checked))
done <"$work/commands"
((checked >= 7)) || fail "only $checked commands and options in the help"

# Completions after an option: its choices, sessions, the effects by name.
mkdir "$work/here" && cd "$work/here" && touch one.alidade other.txt && mkdir folder
if [[ $name == alidade-cli ]]; then
  [[ $(by_bash "$name" fit --method '' | xargs) == 'rigorous published' ]] || fail "bash does not offer the methods"
  [[ $(by_bash "$name" fit --method = p | xargs) == published ]] || fail "bash does not offer the methods after ="
  [[ $(by_bash "$name" fit o | xargs) == one.alidade ]] || fail "bash does not offer sessions alone"
  [[ $(by_bash "$name" fit f | xargs) == folder ]] || fail "bash does not offer folders on the way to sessions"
  [[ $(by_bash "$name" import o | xargs) == 'one.alidade other.txt' ]] || fail "bash does not offer every file to import"
  grep -qx 'trunnion_tilt=' < <(by_bash "$name" simulate --effect trun) || fail "bash does not offer effects"
  grep -q 'compadd .* trunnion_tilt=' "$folder/_$name" || fail "zsh does not offer effects"
else
  [[ $(by_bash "$name" --language '' | xargs) == 'en zh_CN' ]] || fail "bash does not offer the languages"
fi
echo "$checked commands and options"
