#!/usr/bin/env bash
# Who may include whom: app → ui → core, inside core only downwards, the console without Qt, every include from the
# repository root, a source's own header first, and no heavy library in a header.
set -euo pipefail
# shellcheck source=tests/packaging/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

mapfile -t files < <(sources app core ui -- '*.h' '*.cpp')
awk '
  BEGIN {
    split("base session exchange observation effects adjustment diagnosis simulation", order)
    for (i in order) level[order[i]] = i
    # Equations shared by the sources of one folder, and by nobody else.
    inner["core/adjustment/arc_jets.h"]
    inner["core/adjustment/auto_diff.h"]
    inner["core/adjustment/joint_problem.h"]
    split("advice afterwards answer causes cell_functions cells column_table component explanation " \
          "further_readings further_terms gain gap_model gap_size held_out inquiry known_components leftover " \
          "linear_move location look_alikes misread_circle pattern rivals search shape_components steps_in_time " \
          "tilted_plane unseen visible_terms", diagnosis)
    for (i in diagnosis) inner["core/diagnosis/" diagnosis[i] ".h"]
  }
  function complain(why) { print FILENAME ":" FNR ": " why ": " $0 }
  FNR == 1 {
    split(FILENAME, part, "/")
    room = part[1]
    folder = part[2]
    header = FILENAME ~ /\.h$/
    first = 1
    own = FILENAME
    sub(/\.cpp$/, ".h", own)
    has_own = !header && (getline line < own) >= 0
    close(own)
    if (room == "core" && !(folder in level)) print FILENAME ": no such room in core"
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
    if (header && !(FILENAME in inner) && target ~ /^(nlohmann\/json\.hpp|Eigen\/|CLI\/)/) complain("keep this out of headers")
  }
  quoted && target !~ /\.moc$/ {
    if ((getline line < target) < 0) complain("not from the repository root")
    close(target)
    if (room == "core" && to[1] != "core") complain("core includes core only")
    if (room == "core" && to[1] == "core" && level[to[2]] > level[folder]) complain("upwards")
    if (room == "ui" && to[1] == "app") complain("ui never includes app")
    if (folder == "console" && to[1] == "ui") complain("the console needs no window")
    if (target in inner && ((header && !(FILENAME in inner)) || to[2] != folder)) complain("only for sources of its own folder")
    if (room == "app" && to[1] == "app" && to[2] != folder) complain("programs do not share files")
  }
' "${files[@]:-/dev/null}" | report
