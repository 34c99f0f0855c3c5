#!/usr/bin/env bash
# Makes the simulated samples anew: samples/make.sh ALIDADE-CLI FOLDER. Every reading follows from the seed, so the files
# are the same each time; a test compares them with those kept here.
set -euo pipefail

cli=$1
folder=$2
here=$(dirname -- "${BASH_SOURCE[0]}")
truth=$(mktemp)
trap 'rm -f -- "$truth"' EXIT

sample() {
  local name=$1
  shift
  "$cli" simulate --out "$folder/$name.alidade" --truth "$truth" --typing-step 1 --tolerance 0.5 "$@"
}

# The effect, without its format and version, at the end of the session.
takes_up() {
  local session=$folder/$1.alidade effect=$2
  sed -i -e '$d' "$session"
  sed -i -e '$s/$/,/' "$session"
  {
    printf '  "own_effects": [\n    {\n'
    tail -n +4 -- "$effect" | sed 's/^/    /'
    printf '  ]\n}\n'
  } >>"$session"
}

sample trunnion-tilt --seed 1 --protocol two-face --points 9 --rounds 1 --intersection 0.4 \
  --effect trunnion_tilt=25 --title "A tilted trunnion axis" \
  --notes "Simulated: the trunnion axis is tilted by 25 arcseconds. Both faces were read, so nothing else looks like it."
sample look-alikes --seed 2 --protocol paper --points 17 --intersection 0.4 \
  --effect trunnion_tilt=60 --title "The same fault, one face" \
  --notes "Simulated: the trunnion axis is tilted by 60 arcseconds, but only one face was read. A tilted or warped arc plane would leave the same trace."
sample two-causes --seed 3 --protocol full --points 9 --rounds 2 --intersection 0.4 \
  --effect trunnion_tilt=40 --effect vertical_drift=25 --title "Two causes at once" \
  --notes "Simulated: a trunnion axis tilted by 40 arcseconds, and a vertical circle that drifts by 25 arcseconds over the session."
sample unknown-form --seed 4 --protocol paper --points 17 --intersection 0.4 \
  --effect form_harmonic=5,0.3,0.2 --title "A guideway out of shape" \
  --notes "Simulated: the radius changes by 0.36 mm, five times in a full turn. No effect of the catalogue does that."
sample dented-guideway --seed 9 --protocol full --points 17 --intersection 0.4 \
  --effect local_dent=-0.3,40,8 --title "A dented guideway" \
  --notes "Simulated: the guideway is dented by 0.3 mm at 40 degrees, 8 degrees wide. No effect of the catalogue does that."
sample own-effect --seed 10 --protocol full --points 17 --intersection 0.4 \
  --effects "$here/rail-joint.alidade-effect" --effect own:rail_joint=0.12 --title "An effect of one's own" \
  --notes "Simulated: the two halves of the rail do not meet, by 0.12 mm at 105 degrees. No effect of the catalogue does that, but an effect of the user's own."
takes_up own-effect "$here/rail-joint.alidade-effect"
sample knocked-tripod --seed 5 --protocol there-and-back --points 9 --intersection 0.4 \
  --effect orientation_jump=0.7,60,-40 --title "A knocked tripod" \
  --notes "Simulated: after seven tenths of the readings somebody hit the tripod; both circles read differently from then on."
sample noisy-readings --seed 6 --protocol two-face --points 9 --rounds 1 --intersection 0.4 \
  --effect underestimated_noise=3 --title "Noise larger than stated" \
  --notes "Simulated: the readings scatter by 6 arcseconds where 2 are stated, and nothing else is wrong."
sample known-instrument --seed 7 --protocol two-face --points 9 --rounds 1 --intersection 0.4 \
  --effect collimation=3 --effect trunnion_tilt=25 --effect vertical_index=-4 --instrument "$here/t-1.alidade-instrument" \
  --title "A known trunnion tilt" \
  --notes "Simulated: the trunnion axis is tilted by 25 arcseconds, which the instrument's record says. With what is known nothing is left to explain."
sample stale-record --seed 8 --protocol two-face --points 9 --rounds 1 --intersection 0.4 \
  --effect collimation=3 --effect trunnion_tilt=-30 --effect vertical_index=-4 --instrument "$here/t-1.alidade-instrument" \
  --title "An outdated record" \
  --notes "Simulated: the record says that the trunnion axis is tilted by 25 arcseconds; the instrument was knocked since, and it is -30 arcseconds."

# A device over a year, read with one instrument; between July and August its guideway was knocked.
mkdir -p -- "$folder/history"
month=0
for intersection in 0.20 0.20 0.20 0.20 0.20 0.20 0.20 0.45 0.45 0.45 0.45 0.45; do
  month=$((month + 1))
  date=$(printf '2025-%02d-%02d' "$month" "$((3 + month))")
  sample "history/$date" --seed "$((100 + month))" --protocol two-face --points 9 --rounds 1 \
    --intersection "$intersection" --radius 400.05 --measured-on "$date" --device-serial G-07 --instrument-serial T-1138 \
    --title "Guideway 7, $date" --notes "Simulated: the same device each month; its intersection is $intersection mm on this day."
done

# One theodolite on four guideways, each read twice.
mkdir -p -- "$folder/series"
for n in 1 2 3 4 5 6 7 8; do
  sample "series/session-$n" --seed $((40 + n)) --protocol paper --points 17 \
    --effect trunnion_tilt=14 --instrument-serial T-7 --device-serial "G-$(((n - 1) % 4 + 1))" --measured-on "2026-0$n-15" \
    --title "Guideway G-$(((n - 1) % 4 + 1)) in month $n" \
    --notes "Simulated: the trunnion axis of theodolite T-7 is tilted by 14 arcseconds, too little to show in one session of one face."
done
