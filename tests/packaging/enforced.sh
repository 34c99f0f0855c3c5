#!/usr/bin/env bash
# Each rule detects its violation: a small tree per rule, with a single fault.
set -euo pipefail
rules=$(cd -- "${1:?the folder of the rules}" && pwd)
compiler=${2:?the compiler}
eigen=${3:?the folder of Eigen}
trees=$(mktemp -d)
trap 'rm -rf -- "$trees"' EXIT
failed=0

sound_tree() {
  rm -rf -- "${trees:?}/tree"
  mkdir -p "$trees/tree/core/base" "$trees/tree/core/session" "$trees/tree/app/console" \
    "$trees/tree/ui/document" "$trees/tree/ui/jobs"
  cd "$trees/tree"
  cp "$rules/../../LICENSE" "$rules/../../.clang-format" .
  printf '# A tree\n\nA picture: shown.png\n' >README.md
  printf '#pragma once\n\nint one();\n' >core/base/one.h
  printf '#include "core/base/one.h"\n\nint one() {\n  return 1;\n}\n' >core/base/one.cpp
  printf '#pragma once\n\n#include "core/base/one.h"\n' >core/session/two.h
  printf '#pragma once\n\nint fit();\n' >ui/jobs/fit.h
  printf '#pragma once\n\nint held();\n' >ui/document/held.h
  printf '#include <cstdio>\n\n#include "core/session/two.h"\n\nint main() {\n  return one();\n}\n' >app/console/main.cpp
  printf '#!/usr/bin/env bash\necho sound\n' >sound.sh
}

# must pass|fail RULE: the expected result of the rule for the tree. The rule `sources` is another kind of `headers`.
must() {
  local expected=$1 outcome=pass
  bash "$rules/${2/sources/headers}.sh" "$trees/tree" "$compiler" "$eigen" "$2" >"$trees/log" 2>&1 || outcome=fail
  [[ $outcome == "$expected" ]] || { echo "$2.sh should $expected: $3" && cat "$trees/log" && failed=1; }
}

# offence RULE FILE TEXT: the rule refuses the sound tree with TEXT appended to FILE.
offence() {
  sound_tree
  mkdir -p "$(dirname -- "$2")"
  printf '%b' "$3" >>"$2"
  must fail "$1" "$2 with $3"
}

sound_tree
for rule in format includes names headers sources repository scripts; do must pass "$rule" "the sound tree"; done

offence format core/base/one.cpp 'int  two( ) {return 2;}\n'
offence format core/base/README.md '#Title\n\nText.\n'
offence format core/base/README.md '# Title\n\n            **is** torn\n'
offence format core/base/README.md 'Text without a heading.\n'
sound_tree
# shellcheck disable=SC2016
printf '# Title\n\n```sh\n#comment\n             indented\n```\n' >core/base/README.md
must pass format 'code in a Markdown file'
offence includes core/base/one.h '#include "core/session/two.h"\n'
offence includes core/base/one.h '#include <QString>\n'
offence includes core/base/one.h '#include "one.h"\n'
offence includes core/base/one.h '#include <Eigen/Core>\n'
offence includes core/session/two.h '#include "ui/window.h"\n'
offence includes app/console/main.cpp '#include <QString>\n'
offence includes ui/window.h '#include "app/console/main.cpp"\n'
offence includes ui/document/held.h '#include "ui/jobs/fit.h"\n'
offence includes ui/no_room/one.h '#pragma once\n'
offence headers core/session/two.h 'std::string text();\n'
offence sources core/base/one.cpp 'std::string text();\n'
sound_tree
printf '\nstruct Thing {\n  int size;\n};\n' | tee -a core/base/one.h >>ui/window.h
must pass names 'a type of the core and one of the window'
printf '\nclass Thing {\n};\n' >>core/session/two.h
must fail names 'two types of one name in the core'
offence repository README.md 'See /ho''me/someone/notes.\n'
offence repository core/base/one.o 'code'
offence repository hidden.png 'picture'
sound_tree
echo 'All rights reserved.' >LICENSE
must fail repository 'another licence'
sound_tree
printf '#include <cstdio>\n#include "core/base/one.h"\n' >core/base/one.cpp
must fail includes 'own header second'
offence scripts broken.sh 'if true\n'
# shellcheck disable=SC2016
offence scripts unquoted.sh '#!/usr/bin/env bash\nrm $1\n'

# docs pass|fail WHY [PROGRAM]: the expected result of the rule of the Markdown files for the tree.
docs() {
  local outcome=pass
  python3 "$rules/docs.py" "$trees/tree" "${@:3}" >"$trees/log" 2>&1 || outcome=fail
  [[ $outcome == "$1" ]] || { echo "docs.py should $1: $2" && cat "$trees/log" && failed=1; }
}
# Pages that keep their promises and pages that do not, with a program that knows `fit --json` and prints 1.3.
# shellcheck disable=SC2016
of_documents() {
  local fence='```'
  documented() {
    sound_tree
    printf '%b' '# A page\n\n## What it `is`, in 2 words\n\n'"$1" >page.md
    printf '#!/bin/sh\n[ "$*" != "--help" ] || exec echo "fit"\n[ "$*" != "fit --help" ] || exec echo "  --json"\n' >cli
    printf '[ "$1" = fit ] && echo "d = 1.3  mm"\n' >>cli
    chmod +x cli
  }
  documented '[one](core/base/one.h) [two](#what-it-is-in-2-words) [three](page.md#a-page)\n'
  docs pass 'links that lead somewhere'
  documented '[one](core/base/none.h)\n'
  docs fail 'a link to no file'
  documented '[one](#what-it-was)\n'
  docs fail 'a link to no heading'
  documented '[one](../log)\n'
  docs fail 'a link out of the tree'
  documented "${fence}sh\nalidade-cli fit --json\n$fence\n\n${fence}text\nd = 1.3 mm\n$fence\n"
  docs pass 'a command and what it prints' "$trees/tree/cli"
  documented "${fence}sh\nalidade-cli fit\n$fence\n\n${fence}text\nd = 1.4 mm\n$fence\n"
  docs fail 'another figure than the command prints' "$trees/tree/cli"
  documented 'Say `alidade-cli fit --yaml`.\n'
  docs fail 'an option that the command has not' "$trees/tree/cli"
  documented "${fence}sh\nalidade-cli fit-all\n$fence\n"
  docs fail 'a command that there is not' "$trees/tree/cli"
}
of_documents

# Short pages: `lines COUNT FILE` writes a page of so many lines.
of_lengths() {
  lines() {
    mkdir -p "$(dirname "$2")"
    seq "$1" >"$2"
  }
  local decisions=resources/docs/decisions
  sound_tree
  lines 70 README.md && lines 40 core/base/README.md && lines 40 $decisions/001-one.md
  printf '# Index\n\n[One](001-one.md)\n' >$decisions/README.md
  docs pass 'pages as long as they may be'
  lines 71 README.md
  docs fail 'a README of 71 lines'
  sound_tree
  lines 41 core/base/README.md
  docs fail 'a room README of 41 lines'
  sound_tree
  lines 41 $decisions/001-one.md
  printf '# Index\n\n[One](001-one.md)\n' >$decisions/README.md
  docs fail 'a decision of 41 lines'
  sound_tree
  lines 4 $decisions/001-one.md
  docs fail 'a decision that the index does not list'
  lines 4 $decisions/001-two.md
  printf '# Index\n\n[One](001-one.md) [Two](001-two.md)\n' >$decisions/README.md
  docs fail 'two decisions of one number'
}
of_lengths

# The page of the effects, held to the catalogue.
# shellcheck disable=SC2016
of_effects() {
  listed() {
    sound_tree
    mkdir -p core/effects resources/docs
    printf 'makeCatalogue() {\n      {"tilt",\n       PHRASE_LATER("Phrase", "a tilt"),\n' >core/effects/catalogue.cpp
    printf '       {{PHRASE_LATER("Phrase", "x"), TiltX, "arcsec", 30},\n' >>core/effects/catalogue.cpp
    printf '        {PHRASE_LATER("Phrase", "y"), TiltY, "mm", 5e-4}}},\n}\n/// Each error term\n' >>core/effects/catalogue.cpp
    printf '# Effects\n\n| effect | formula | size |\n|---|---|---|\n%s\n' "$1" >resources/docs/effects.md
  }
  listed '| a tilt t `tilt` | t | x 30″, y 0.0005 mm |'
  docs pass 'an effect as the catalogue has it'
  listed '| a tilt t `tilt` | t | x 20″, y 0.0005 mm |'
  docs fail 'another plausible size'
  listed '| a slope `tilt` | t | x 30″, y 0.0005 mm |'
  docs fail 'another name'
  listed '| a tilt `slope` | t | x 30″, y 0.0005 mm |'
  docs fail 'an effect that is not in the catalogue'
  listed ''
  docs fail 'an effect that is missing'
}
of_effects
exit "$failed"
