#!/usr/bin/env bash
# No two headers define types of equal name in one namespace: no compiler sees both, the linker merges them,
# and the program crashes far from here. `alidade::ui` may reuse names of the core.
set -euo pipefail
# shellcheck source=tests/packaging/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

for namespace in 'core app' 'ui'; do
  # shellcheck disable=SC2086  # one word a folder
  mapfile -t headers < <(sources $namespace -- '*.h')
  awk '
    /^(struct|class|enum class) [A-Za-z0-9]+( final)?( : [^{]*)? *\{/ {
      name = $1 == "enum" ? $3 : $2
      if (name in where && where[name] != FILENAME) print FILENAME ":" FNR ": " name " is a type of " where[name] ", too"
      where[name] = FILENAME
    }
  ' "${headers[@]:-/dev/null}"
done | report
