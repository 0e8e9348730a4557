#!/bin/sh
# Times the reading of scenes, beside POV-Ray: benches/language.sh [POVISTA] [TURNS]
# Processor seconds of whole runs at 8 x 6 pixels, less those of a scene with one sphere; the least of three.
set -eu
povista=${1:-target/release/povista} turns=${2:-1000000}
case $povista in */*) povista=$(realpath "$povista") ;; esac
scenes=$(dirname "$(realpath "$0")")/scenes/language
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

head='#version 3.7; global_settings { assumed_gamma 1 } camera { location -30*z look_at 0 }
light_source { <10, 10, -10> 1 } sphere { 0, 1 }'
echo "$head" > nothing.pov
for scene in "$scenes"/*.pov; do
    { echo "$head #declare Turns = $turns;"; cat "$scene"; } > "$(basename "$scene")"
done
# A grid of 2 N^2 triangles, as many literal numbers, and objects a tenth as many.
awk -v head="$head" -v n="$(awk -v t="$turns" 'BEGIN { print int(sqrt(t / 2)) }')" 'BEGIN {
    print head " mesh2 { vertex_vectors { " (n+1)^2
    for (i = 0; i <= n; i++) for (j = 0; j <= n; j++)
        printf ",<%.6f, %.6f, %.6f>\n", i/n, sin(9*i/n)*cos(9*j/n)/5, j/n
    print "} normal_vectors { " (n+1)^2
    for (i = 0; i <= n; i++) for (j = 0; j <= n; j++)
        printf ",<%.6f, 1, %.6f>\n", -cos(9*i/n), sin(9*j/n)
    print "} face_indices { " 2*n*n
    for (i = 0; i < n; i++) for (j = 0; j < n; j++) {
        a = i*(n+1)+j; b = a+n+1
        printf ",<%d,%d,%d>,<%d,%d,%d>\n", a, a+1, b+1, a, b+1, b
    }
    print "} pigment { rgb 1 } }"
}' > mesh2.pov
awk -v head="$head" -v n="$turns" 'BEGIN {
    print head " #declare A = array[" n "] {"
    for (i = 0; i < n; i++) printf "%.6f%s\n", rand(), i < n-1 ? "," : "}"
    print "#declare B = array[" n "] {"
    for (i = 0; i < n; i++) printf "<%.4f, %.4f, %.4f>%s\n", rand(), rand(), rand(), i < n-1 ? "," : "}"
}' > numbers.pov
awk -v head="$head" -v n="$turns" 'BEGIN {
    print head
    for (i = 0; i < n/10; i++)
        printf "sphere { <%.4f, %.4f, %.4f>, %.4f pigment { rgb <%.3f, %.3f, %.3f> } }\n",
            20*rand()-10, 20*rand()-10, 20*rand(), rand()/5, rand(), rand(), rand()
}' > objects.pov

# The least processor seconds of three runs, and the most memory in MB.
least() {
    for _ in 1 2 3; do
        /usr/bin/time -o time -f "%U %S %M" "$@" +W8 +H6 -D +WT1 +O/dev/null +FN > log 2>&1 || { cat log >&2; exit 1; }
        cat time
    done | awk '{ t = $1+$2; if (NR == 1 || t < least) least = t; m = $3 } END { print least, int(m/1024) }'
}
printf '%-12s %10s %10s %6s %10s %10s\n' scene POV-Ray povista ratio 'POV-Ray MB' 'povista MB'
for scene in nothing *.pov; do
    scene=${scene%.pov}
    [ "$scene" = nothing ] && [ -n "${base:-}" ] && continue
    theirs=$(least povray "+I$scene.pov") ours=$(least "$povista" "+I$scene.pov")
    base=${base:-"$theirs $ours"}
    echo "$scene $theirs $ours $base" | awk '{
        t = $2 - $6; o = $4 - $8
        if ($1 == "nothing") printf "%-12s %10.2f %10.2f %6s %10d %10d\n", $1, $2, $4, "", $3, $5
        else printf "%-12s %10.2f %10.2f %6.1f %10d %10d\n", $1, t, o, (o > 0 ? t/o : 0), $3, $5
    }'
done
