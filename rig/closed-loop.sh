#!/usr/bin/env bash
# An hour of the rig's time and the whole way of a measurement: the automated test on the simulated rig, its raw logs
# reduced by `sheave dyno`, its operating points compared with the model by `sheave compare`. The model is the one that
# the simulated CVT was made with, so that what remains is the error of the way itself; it must stay below 0.5 points of
# efficiency, root mean square. Usage: closed-loop.sh [SHEAVE], SHEAVE being the program (target/debug/sheave
# otherwise).
set -euo pipefail
here="$(cd "$(dirname "$0")" && pwd)"
sheave="${1:-$here/../target/debug/sheave}"
[ -x "$sheave" ] || { echo "$sheave is missing: cargo build -p sheave, or name the program" >&2; exit 1; }
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

(cd "$here" && cargo build --locked --quiet -p rig-logger)
"${CARGO_TARGET_DIR:-$here/target}/debug/sheave-rig" simulate --passes 5 --read 10 --brake-step 40 --out "$work/runs"
"$sheave" dyno "$work/runs/run-0001" --engine "$here/logger/data/engine-power.csv" --out "$work/points" >/dev/null
# The first window of every sixth operating point of the first pass; to the torque comes what the simulated secondary's
# bearings take, 0.002 N·m·s, as a run-down of the free shaft shows it on a real rig.
awk -F, -v OFS=, '
  NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; print; next }
  $1 !~ /^step / { next }
  { split($1, name, " "); if (name[2] % 6 || name[2] > 54 || seen[name[2]]++) next
    $(at["secondary_torque_Nm"]) += 0.002 * $(at["secondary_rpm"]) * 0.10471975512; print }
' "$work/points/operating-points.csv" >"$work/some.csv"
"$sheave" compare --data "$work/some.csv" --engine "$here/logger/data/engine-power.csv" \
  --set operating_point.slack_tension="150 N" --tol 1e-4 | tee "$work/compared"
awk '/^root mean square  / && !/with it/ { error = $4; found = 1 }
     END {
       if (!found || error > 0.5) { print "the way from run to model has an error of " error " points"; exit 1 }
     }' "$work/compared"
