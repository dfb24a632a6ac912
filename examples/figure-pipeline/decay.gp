# SPDX-License-Identifier: MIT
# A damped oscillation and its envelope. Plots decay.svg, 110 mm by 70 mm at 96 pixels an inch.
set terminal svg size 416,265 font "sans,11" linewidth 1 background rgb "white"
set output "decay.svg"
unset key
set border 3
set xrange [0:10]
set yrange [-1.1:1.1]
set xtics 0,2,10 nomirror
set ytics -1,1,1 nomirror
set zeroaxis linetype 1 linecolor rgb "black"
set samples 400
plot exp(-x/4)*cos(3*x) linecolor rgb "black", \
     exp(-x/4) linecolor rgb "black" dashtype 2, \
    -exp(-x/4) linecolor rgb "black" dashtype 2
