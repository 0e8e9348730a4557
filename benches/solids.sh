#!/bin/sh
# Measures solids beside POV-Ray: benches/solids.sh [POVISTA] [RUNS]
# Of each scene of benches/scenes/solid, a height_field of 10^6 samples and a mesh2 of 10^6 triangles: processor
# seconds of a run at 8 x 6 pixels (reading and building), what 640 x 480 pixels take beyond that (tracing), the
# least of so many interleaved runs, and the most memory.
set -eu
povista=${1:-target/release/povista} runs=${2:-3}
case $povista in */*) povista=$(realpath "$povista") ;; esac
scenes=$(dirname "$(realpath "$0")")/scenes/solid
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
cp "$scenes"/*.pov .
stage='#version 3.7; global_settings { assumed_gamma 1 } camera { location <0, 1.2, -4> look_at 0 angle 42 }
light_source { <10, 20, -10> rgb 1 }'
# Neither byte of a sample is 0.
LC_ALL=C awk 'BEGIN {
    printf "P5\n1000 1000\n65535\n"
    for (i = 0; i < 1000; i++) for (j = 0; j < 1000; j++) {
        h = 128 + 40*sin(j/23)*cos(i/29) + 12*sin(j/7 + i/11) + 4*sin(j/3 - i/5)
        printf "%c%c", int(h), 1 + int(254*(h - int(h)))
    }
}' > hills.pgm
echo "$stage height_field { pgm \"hills.pgm\" gamma 1 translate -0.5 scale <4, 1.5, 4> pigment { rgb <0.5, 0.8, 0.4> } }" \
    > height_field.pov
awk -v n=707 -v stage="$stage" 'BEGIN {
    print stage " mesh2 { vertex_vectors { " (n+1)^2
    for (i = 0; i <= n; i++) for (j = 0; j <= n; j++)
        printf ",<%.6f, %.6f, %.6f>\n", 4*i/n-2, sin(23*i/n)*cos(17*j/n)/6 + sin(91*i/n + 57*j/n)/12, 4*j/n-2
    print "} face_indices { " 2*n*n
    for (i = 0; i < n; i++) for (j = 0; j < n; j++) {
        a = i*(n+1)+j; b = a+n+1
        printf ",<%d,%d,%d>,<%d,%d,%d>\n", a, a+1, b+1, a, b+1, b
    }
    print "} pigment { rgb <0.8, 0.6, 0.4> } }"
}' > mesh2.pov

# Processor seconds and memory in MB of a run.
run() {
    /usr/bin/time -o time -f "%U %S %M" "$@" -D -A +WT1 +O/dev/null +FN > log 2>&1 || { cat log >&2; exit 1; }
    awk '{ print $1+$2, int($3/1024) }' time
}
printf '%-14s %9s %9s %6s %9s %9s %6s %8s %8s\n' \
    scene 'build P' 'build p' ratio 'trace P' 'trace p' ratio 'MB P' 'MB p'
for scene in *.pov; do
    for _ in $(seq "$runs"); do
        for program in povray "$povista"; do
            echo "$(run "$program" "+I$scene" +W8 +H6) $(run "$program" "+I$scene" +W640 +H480)"
        done | paste -s -d ' '
    done | awk -v scene="${scene%.pov}" '
        function less(a, b) { return a == "" || b < a ? b : a }
        { pb = less(pb, $1); pt = less(pt, $3); ob = less(ob, $5); ot = less(ot, $7); pm = $4; om = $8 }
        END {
            pt -= pb; ot -= ob; if (ob < 0.01) ob = 0.01; if (ot < 0.01) ot = 0.01
            printf "%-14s %9.2f %9.2f %6.1f %9.2f %9.2f %6.1f %8d %8d\n", scene, pb, ob, pb/ob, pt, ot, pt/ot, pm, om
        }'
done
