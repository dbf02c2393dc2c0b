# SPDX-License-Identifier: Apache-2.0

# Draws up to seven charts from the tables stats.csv, sides.csv and stress.csv into the folder of the tables:
#
#     gnuplot charts.gp
#
# This script requires gnuplot 5.4 or newer. foamtex inserts a line at the top that sets `film_tension`.

set encoding utf8
set datafile separator ","
set datafile missing NaN  # rows that a chart leaves out do not break its lines
set terminal svg size 820,396 font "Helvetica,12" background "#ffffff"
set lmargin at screen 0.10
set rmargin at screen 0.66
set tmargin at screen 0.90
set bmargin at screen 0.14
set key at screen 0.67, screen 0.90 left top Left reverse samplen 2
set border 3 linecolor rgb "#777777"
set tics nomirror textcolor rgb "#222222"
set grid linecolor rgb "#e6e6e6" linetype 1 linewidth 1, linecolor rgb "#e6e6e6" linetype 1 linewidth 1
set format x "%h"
set format y "%h"

# The colors of Okabe and Ito, which color-blind readers can tell apart.
blue = 0x0072b2
vermilion = 0xd55e00
gray = 0x777777
black = 0x222222
# Entries of viridis from dark to bright, for 3 to 10 sides.
array viridis[8] = [0x440154, 0x482576, 0x404688, 0x35608d, 0x29788e, 0x20928c, 0x35b779, 0x9bd93c]

frames = "stats.csv"
sides_table = "sides.csv"  # a row per frame and number of sides
froth = 1.4                # second moment measured in soap froths in their scaling state
froth_error = 0.1          # error of this second moment
few_bubbles = 100          # means over fewer bubbles have little meaning
common_share = 0.01        # a pressure is shown only if at least this share of the bubbles has the number of sides

# The number of bubbles in the first frame, and arrays of the numbers of bubbles and of the mean areas by
# frame number.
rows = 0
first_bubbles = 0
last_frame = 0
stats frames every ::1 using (rows = rows + 1, first_bubbles = rows == 1 ? $3 : first_bubbles, \
    last_frame = $1 > last_frame ? $1 : last_frame, $1) nooutput
if (rows == 0) { exit status 0 }  # a run without frames
array bubbles[last_frame]
array area[last_frame]
remember(frame, count, mean) = (bubbles[frame] = count, area[frame] = mean, frame)
stats frames every ::1 using (remember(int($1), $3, $4)) nooutput

# Frames with enough bubbles to average over; all frames if the first frame has too few bubbles.
least = first_bubbles >= few_bubbles ? few_bubbles : 0
measurable(count) = count >= least
# The scaling state: of these frames, those in which at most a quarter of the bubbles of the first frame are left.
scaling(count) = measurable(count) && count <= 0.25 * first_bubbles

# Sums over the scaling state, and its first and last time; extremes over all measurable frames.
scaling_rows = 0
scaling_begin = scaling_end = 0
moment_sum = moment_weight = 0
lowest = froth - 2 * froth_error
highest = froth + 2 * froth_error
first_time = last_time = 0
add_time(time) = (first_time = first_time == 0 ? time : first_time, last_time = time)
add_scaling(time, count, moment) = (scaling_begin = scaling_rows == 0 ? time : scaling_begin, \
    scaling_rows = scaling_rows + 1, scaling_end = time, \
    moment_sum = moment_sum + count * moment, moment_weight = moment_weight + count)
add_moment(moment) = (lowest = moment < lowest ? moment : lowest, \
    highest = moment > highest ? moment : highest)
stats frames every ::1 using (scaling($3) ? add_scaling($2, $3, $6) : 0, \
    measurable($3) ? add_moment($6) : 0, measurable($3) ? add_time($2) : 0, $1) nooutput
has_line = scaling_rows >= 2 && scaling_end > scaling_begin

# Mean area ---------------------------------------------------------------------------------------
set output "mean_area.svg"
set title "Mean bubble area"
set xlabel "time (foam units)"
set ylabel "mean area (foam units)"
set xrange [0:*]
set yrange [0:*]
if (has_line) {
    stats frames every ::1 using (scaling($3) ? $2 : NaN):4 name "LINE" nooutput
    line_title = sprintf("%.3g + %.4g t, R² = %.4f", \
        LINE_intercept, LINE_slope, LINE_correlation ** 2)
    plot frames every ::1 using (measurable($3) ? $2 : NaN):4 title "measured" \
            with points pointtype 7 pointsize 0.4 linecolor rgb blue, \
        [scaling_begin:scaling_end] LINE_intercept + LINE_slope * x title line_title \
            with lines linewidth 2 linecolor rgb vermilion
} else {
    plot frames every ::1 using (measurable($3) ? $2 : NaN):4 title "measured" \
        with points pointtype 7 pointsize 0.4 linecolor rgb blue
}

# Charts over the logarithm of time omit frames at time 0. ------------------------------------------
if (last_time > first_time) {
    set logscale x
    set xrange [first_time:last_time]

    set output "second_moment.svg"
    set title "Second moment of the number of sides"
    set ylabel "second moment μ_2"
    set yrange [lowest - 0.02:highest + 0.02]
    set object 1 rectangle from graph 0, first froth - froth_error to graph 1, first froth + froth_error \
        behind fillcolor rgb "#d3ece2" fillstyle solid noborder
    moment = has_line ? moment_sum / moment_weight : NaN
    plot keyentry with boxes fillstyle solid noborder fillcolor rgb "#d3ece2" \
            title sprintf("soap froths, %.1f ± %.1f", froth, froth_error), \
        frames every ::1 using (measurable($3) && $2 > 0 ? $2 : NaN):6 title "measured" \
            with lines linewidth 1.5 linecolor rgb blue, \
        frames every ::1 using (has_line && scaling($3) ? $2 : NaN):(moment) \
            title (has_line ? sprintf("mean %.2f", moment) : "") \
            with lines linewidth 2 dashtype 2 linecolor rgb vermilion
    unset object 1

    # Count the rows of each number of sides that the next two charts show.
    array side_rows[10]
    array pressure_rows[10]
    do for [n = 1:10] { side_rows[n] = pressure_rows[n] = 0 }
    all_side_rows = all_pressure_rows = 0
    shown(frame, share) = measurable(bubbles[int(frame)]) && share >= common_share
    count_rows(n, sides, pressures) = n < 3 || n > 10 ? 0 : \
        (side_rows[n] = side_rows[n] + sides, pressure_rows[n] = pressure_rows[n] + pressures, \
        all_side_rows = all_side_rows + sides, all_pressure_rows = all_pressure_rows + pressures)
    stats sides_table every ::1 using (count_rows(int($3), $2 > 0 && measurable(bubbles[int($1)]), \
        $2 > 0 && shown($1, $5)), $3) nooutput
    name(n, rows) = rows > 0 ? sprintf("n = %d", n) : ""

    if (all_side_rows > 0) {
        set output "sides.svg"
        set title "Distribution of the number of sides"
        set ylabel "share of the bubbles"
        set yrange [0:*]
        plot for [n = 3:10] sides_table every ::1 \
            using ($3 == n && $2 > 0 && measurable(bubbles[int($1)]) ? $2 : NaN):5 \
            title name(n, side_rows[n]) with lines linewidth 1.5 linecolor rgb viridis[n - 2]
    }

    if (all_pressure_rows > 0) {
        set output "pressures.svg"
        set title "Mean pressure by the number of sides"
        set ylabel "mean pressure (T / √mean area)"
        set yrange [*:*]
        plot for [n = 3:10] sides_table every ::1 \
            using ($3 == n && $2 > 0 && shown($1, $5) ? $2 : NaN):($7 * sqrt(area[int($1)]) / film_tension) \
            title name(n, pressure_rows[n]) with lines linewidth 1.5 linecolor rgb viridis[n - 2]
    }
    unset logscale x
}

# Growth rates: means over all frames, weighted by the numbers of bubbles that were measured --------
last_sides = 0
stats sides_table every ::1 using (last_sides = $3 > last_sides ? $3 : last_sides, $3) nooutput
array area_sum[last_sides]
array area_weight[last_sides]
array film_sum[last_sides]
array film_weight[last_sides]
array law[last_sides]
do for [n = 1:last_sides] {
    area_sum[n] = area_weight[n] = film_sum[n] = film_weight[n] = 0
    law[n] = NaN
}
add_area(n, rate, weight) = (area_sum[n] = area_sum[n] + rate * weight, \
    area_weight[n] = area_weight[n] + weight)
add_film(n, rate, weight, law_rate) = (film_sum[n] = film_sum[n] + rate * weight, \
    film_weight[n] = film_weight[n] + weight, law[n] = law_rate)
stats sides_table every ::1 using (int($3) < 1 ? 0 : add_film(int($3), $10, $4, $11), \
    int($3) > 0 && valid(9) ? add_area(int($3), $9, $8) : 0, $3) nooutput
mean(sum, weight) = weight > 0 ? sum / weight : NaN

set output "growth_rates.svg"
set title "von Neumann's law"
set xlabel "number of sides n"
set ylabel "dA/dt (foam units)"
set xrange [2.5:last_sides + 0.5]
set yrange [*:*]
set xtics 1
plot law using 1:(law[$1]) title "(2π/3) γ κ (n − 6)" with lines linewidth 1.5 linecolor rgb gray, \
    area_sum using 1:(mean(area_sum[$1], area_weight[$1])) title "areas between events" \
        with points pointtype 7 pointsize 0.8 linecolor rgb blue, \
    film_sum using 1:(mean(film_sum[$1], film_weight[$1])) title "κ Σ Δp l of the films" \
        with points pointtype 12 pointsize 1.2 linewidth 1.5 linecolor rgb vermilion
set xtics autofreq

# Stress over strain, if the foam is sheared. The line of the shear modulus begins at the first frame and ends
# at the largest stress. ------------------------------------------------------------------------------
stresses = "stress.csv"
stress_rows = 0
lowest_strain = highest_strain = 0
yield_stress = yield_strain = 0
modulus = NaN
unit(frame) = sqrt(area[int(frame)]) / film_tension
add_strain(strain, stress) = (lowest_strain = stress_rows == 0 || strain < lowest_strain ? strain : lowest_strain, \
    highest_strain = stress_rows == 0 || strain > highest_strain ? strain : highest_strain, \
    first_strain = stress_rows == 0 ? strain : first_strain, \
    first_stress = stress_rows == 0 ? stress : first_stress, \
    yield_strain = stress_rows == 0 || stress > yield_stress ? strain : yield_strain, \
    yield_stress = stress_rows == 0 || stress > yield_stress ? stress : yield_stress, \
    stress_rows = stress_rows + 1)
first_strain = first_stress = 0
stats stresses every ::1 using (modulus = stress_rows == 0 && valid(9) ? $9 * unit($1) : modulus, \
    add_strain($3, $6 * unit($1)), $1) nooutput
if (highest_strain > lowest_strain) {
    set output "stress.svg"
    set title "Stress over strain"
    set xlabel "strain"
    set ylabel "stress (T / √mean area)"
    set xrange [*:*]
    set yrange [*:*]
    has_modulus = modulus > 0 && yield_stress > first_stress
    elastic_end = has_modulus ? first_strain + (yield_stress - first_stress) / modulus : first_strain
    elastic(strain) = has_modulus ? first_stress + modulus * (strain - first_strain) : NaN
    plot stresses every ::1 using 3:($6 * unit($1)) title "σ_{xy}" \
            with linespoints linewidth 1.5 pointtype 7 pointsize 0.3 linecolor rgb blue, \
        stresses every ::1 using 3:($8 * unit($1)) title "σ_{xx} − σ_{yy}" \
            with lines linewidth 1 linecolor rgb gray, \
        [first_strain:elastic_end] elastic(x) title (has_modulus ? sprintf("shear modulus %.3g", modulus) : "") \
            with lines linewidth 2 dashtype 2 linecolor rgb vermilion, \
        [lowest_strain:highest_strain] yield_stress \
            title sprintf("largest σ_{xy}: %.3g at strain %.3g", yield_stress, yield_strain) \
            with lines linewidth 1 dashtype 3 linecolor rgb black
}

# Time per frame. The first row covers all steps that prepare the first frame, and each later row covers
# the frames since the preceding row.
previous = NaN
set output "seconds.svg"
set title "Time of a frame over the evolution"
set xlabel "bubbles"
set ylabel "time of a frame (s)"
set logscale xy
set xrange [*:*]
set format y "10^{%L}"
$paper << END
10000,39.5
11,0.084
END
plot $paper using 1:2 title "the paper, 2 GHz laptop" \
        with points pointtype 12 pointsize 1.2 linewidth 1.5 linecolor rgb vermilion, \
    frames every ::1 using ($3):(step = $1 - previous, previous = $1, $11 / step) title "foamtex" \
        with points pointtype 7 pointsize 0.4 linecolor rgb blue, \
    frames every ::1::1 using 3:11 title "foamtex, from the raw diagram" \
        with points pointtype 6 pointsize 0.8 linecolor rgb black
