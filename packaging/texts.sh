#!/usr/bin/env bash
# texts.sh LUPDATE LIST.ts [INTO.ts]: brings a list of translations in line with the texts in the sources. What is new stands in
# it as unfinished.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
lupdate=$1
list=$2
into=${3:-$list}
[[ $into == "$list" ]] || cp -- "$list" "$into"
cd -- "$root"
"$lupdate" -silent -I . -no-obsolete -locations none -tr-function-alias tr+=of -tr-function-alias QT_TRANSLATE_NOOP+=PHRASE_LATER \
  -tr-function-alias Q_DECLARE_TR_FUNCTIONS+=PHRASE_CONTEXT -source-language en -target-language zh_CN core ui app/workstation -ts "$into"
