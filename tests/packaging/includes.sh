#!/usr/bin/env bash
# Allowed includes: app → ui → core, inside core and ui only downwards, the console without Qt, every include from
# the repository root, the header of a source first, and heavy libraries only in sources.
set -euo pipefail
# shellcheck source=tests/packaging/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

mapfile -t files < <(sources app core ui -- '*.h' '*.cpp')
awk '
  BEGIN {
    rooms = split("base signature terms session exchange connection observation effects " \
                  "adjustment/numerics adjustment/arc adjustment/joint adjustment/result adjustment/monte_carlo " \
                  "adjustment/gross_errors " \
                  "diagnosis/result diagnosis/gap diagnosis/evidence diagnosis/candidates diagnosis/search " \
                  "diagnosis/observability diagnosis/forms diagnosis/next_sighting diagnosis/conclusion diagnosis " \
                  "series/shared_causes guidance " \
                  "wording evaluation statement answers certificate simulation " \
                  "series/instrument_check series/history " \
                  "self_test", order)
    for (i = 1; i <= rooms; ++i) level["core/" order[i]] = i
    rooms = split("language document settings text " \
                  "charts/plotting charts/residuals charts/arc jobs charts/gap charts/history " \
                  "commands panels/parts " \
                  "panels/gap recovery import report models forms dialogs panels/result panels/readings " \
                  "connection entry help instrument panels/journal panels/model panels/order " \
                  "panels/uncertainty panels/window self_test series start window", order)
    for (i = 1; i <= rooms; ++i) level["ui/" order[i]] = i
    # Linear algebra headers, only for the sources of one floor.
    floor_of["core/adjustment/joint/arc_jets.h"] = "adjustment"
    floor_of["core/adjustment/joint/joint_problem.h"] = "adjustment"
    floor_of["core/adjustment/numerics/auto_diff.h"] = "adjustment"
    floor_of["core/series/shared_causes/effect_block.h"] = "series"
    floor_of["core/series/shared_causes/session_sums.h"] = "series"
    floor_of["core/series/shared_causes/shared_search.h"] = "series"
    floor_of["core/series/shared_causes/common_noise.h"] = "series"
    floor_of["core/series/shared_causes/series_conclusion.h"] = "series"
    floor_of["core/series/shared_causes/searched_series.h"] = "series"
    split("gap evidence candidates search observability forms next_sighting conclusion", behind)
    for (i in behind) inner["core/diagnosis/" behind[i]]
  }
  function folder_of(file) { sub(/\/[^\/]*$/, "", file); return file }
  # The only floor of core that may include the file; empty if any may.
  function owner(file) { return file in floor_of ? floor_of[file] : folder_of(file) in inner ? "diagnosis" : "" }
  function complain(why) { print FILENAME ":" FNR ": " why ": " $0 }
  FNR == 1 {
    split(FILENAME, part, "/")
    room = part[1]
    folder = part[2]
    place = folder_of(FILENAME)
    header = FILENAME ~ /\.h$/
    first = 1
    own = FILENAME
    sub(/\.cpp$/, ".h", own)
    has_own = !header && (getline line < own) >= 0
    close(own)
    if (room != "app" && place != "ui" && !(place in level)) print FILENAME ": no such room in " room
  }
  !/^#include / { next }
  {
    target = $2
    quoted = target ~ /^"/
    gsub(/["<>]/, "", target)
    split(target, to, "/")
    if (first && has_own && target != own) complain("own header first")
    first = 0
    if (!quoted && target ~ /^Q/ && (room == "core" || folder == "console")) complain("no Qt here")
    if (header && !owner(FILENAME) && target ~ /^(nlohmann\/json\.hpp|Eigen\/|CLI\/)/) complain("keep this out of headers")
  }
  quoted && target !~ /\.moc$/ {
    if ((getline line < target) < 0) complain("not from the repository root")
    close(target)
    if (room == "core" && to[1] != "core") complain("core includes core only")
    if (to[1] == room && place in level && level[folder_of(target)] > level[place]) complain("upwards")
    if (room == "ui" && place != "ui" && folder_of(target) == "ui") complain("upwards")
    if (room == "ui" && to[1] == "app") complain("ui never includes app")
    if (folder == "console" && to[1] == "ui") complain("the console needs no window")
    if (owner(target) && ((header && !owner(FILENAME)) || folder != owner(target))) complain("only for sources of core/" owner(target))
    if (room == "app" && to[1] == "app" && to[2] != folder) complain("programs do not share files")
  }
' "${files[@]:-/dev/null}" | report
