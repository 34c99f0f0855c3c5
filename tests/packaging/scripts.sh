#!/usr/bin/env bash
# Every shell script parses and gives shellcheck nothing to say.
set -euo pipefail
# shellcheck source=tests/packaging/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

mapfile -t scripts < <(sources . -- '*.sh')
[[ ! -e .ci/run ]] || scripts+=(.ci/run)
for script in "${scripts[@]}"; do bash -n "$script"; done
shellcheck -x "${scripts[@]}"
