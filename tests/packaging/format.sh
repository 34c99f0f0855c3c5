#!/usr/bin/env bash
# Every C++ file is as clang-format 14 writes it, and no Markdown file is. It takes headings for preprocessor lines (`#Title`)
# and indents paragraphs as expressions. Each Markdown file begins with a heading, so that a torn one is always seen.
set -euo pipefail
# shellcheck source=tests/packaging/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

sources app core samples ui tests -- '*.h' '*.cpp' | xargs -r -d '\n' clang-format-14 --dry-run -Werror

mapfile -t texts < <(sources . -- '*.md')
[[ ${#texts[@]} == 0 ]] || awk '
  FNR == 1 { isCode = 0 }
  FNR == 1 && !/^# [^ ]/ { print FILENAME ":1: no heading (# Title): was clang-format run over it?" }
  /^ *```/ { isCode = !isCode }
  isCode { next }
  /^ *#+[^# ]/ { print FILENAME ":" FNR ": a heading without a blank behind #: was clang-format run over it?" }
  /^            / { print FILENAME ":" FNR ": text indented by 12 blanks or more: was clang-format run over it?" }
' "${texts[@]}" | report
