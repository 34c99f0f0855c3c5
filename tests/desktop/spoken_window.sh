#!/usr/bin/env bash
# What a screen reader finds on the bus of the desktop: names and roles of all controls, and the points of the charts.
# Arguments: the workstation, a session, the folder with listener.py.
set -euo pipefail

workstation=$1 session=$2 here=$3
if [[ -z ${DBUS_SESSION_BUS_ADDRESS:-} || ${SPOKEN_IN_BUS:-} != yes ]]; then
  command -v dbus-run-session >/dev/null || { echo "dbus-run-session is missing: nothing was tried" && exit 77; }
  SPOKEN_IN_BUS=yes exec dbus-run-session -- bash "$0" "$@"
fi
/usr/bin/python3 -c 'import dbus' 2>/dev/null || { echo "python3-dbus is missing: nothing was tried" && exit 77; }
[[ -e /usr/share/dbus-1/services/org.a11y.Bus.service ]] || { echo "at-spi2-core is missing: nothing was tried" && exit 77; }
# shellcheck source=tests/desktop/desk.sh
source "$here/desk.sh"

QT_LINUX_ACCESSIBILITY_ALWAYS_ON=1 "$workstation" "$session" >"$work/out" 2>&1 &
started+=($!)
wait_for "the window" window_named "$(basename "$session") — .*Alidade"
wait_for "the window on the bus" /usr/bin/python3 "$here/listener.py" there
/usr/bin/python3 "$here/listener.py" controls || fail "controls without a name or a role"
/usr/bin/python3 "$here/listener.py" points Residuals 68 || fail "points of the residuals"
/usr/bin/python3 "$here/listener.py" points "Arcs and sighted points" 34 || fail "points of the arcs"
keys ctrl+4
step_to_a_point() { keys Right && /usr/bin/python3 "$here/listener.py" focused "list item" "point "; }
wait_for "the point that the keyboard is on" step_to_a_point
echo "controls and points are told to screen readers"
