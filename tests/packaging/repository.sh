#!/usr/bin/env bash
# The repository is self-contained: no path of one machine, no reference outside, its licence included, no
# build products.
set -euo pipefail
# shellcheck source=tests/packaging/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

text_files() { sources . -- '*.h' '*.cpp' '*.sh' '*.md' '*.txt' '*.json' '*.alidade' '*.cmake' '*.qrc' '*.svg' '*.csv' run; }

foreign='(^|[^[:alnum:]_.])/(work|root|(home|tmp)/[a-z]+)/|[.][.]/shared'
text_files | { xargs -r -d '\n' grep -nE -e "$foreign" -- /dev/null || true; } | sed 's/$/   (a path of one machine)/' | report

[[ $(head -n 2 LICENSE) == *'GNU GENERAL PUBLIC LICENSE'*'Version 3, 29 June 2007'* ]] ||
  { echo "LICENSE is not the GPL, version 3" && exit 1; }

pages=(README.md)
[[ ! -d resources/docs ]] || pages+=(resources/docs)
sources . -- '*.o' '*.a' '*.so' '*.pdf' '*.png' '*.jpg' '*.gz' '*.orig' '*.rej' '*~' | while read -r file; do
  grep -rqF -- "$(basename -- "$file")" "${pages[@]}" || echo "$file: neither a source nor shown by README.md or a page"
done | report
