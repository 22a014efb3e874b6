# Called with the folder of the tables and the picture to write.
folder = ARG1
set terminal svg size 1200,360 font "sans-serif,13" background "white" dynamic
set output ARG2
set datafile separator ","
set multiplot layout 1,3
set grid lc rgb "#dddddd"
set border 3
set tics nomirror

set title "time to 95 % of the load [s]"
set xlabel "kt [N/m]"
set logscale xy
set format "10^{%L}"
set key top right
plot for [d in "0.5 1 2"] folder."/delay.csv" every ::1 using ($2 == d ? $1 : NaN):3 with points pt 7 ps 0.6 title "γt = ".d

set title "energy in the tangential springs [J]"
set xlabel "the floor's acceleration over g"
unset logscale x
set format x "%g"
set key bottom right
plot folder."/noise.csv" every ::1 using 1:5 with lines lw 5 lc rgb "#cccccc" title "(m a)^2/(4 kt)", \
     "" every ::1 using 1:2 with points pt 7 ps 0.6 lc rgb "#2471a3" title "sideways", \
     "" every ::1 using 1:3 with points pt 6 ps 0.8 lc rgb "#c0392b" title "sideways, undamped", \
     "" every ::1 using 1:4 with points pt 7 ps 0.6 lc rgb "#1e8449" title "aslant"

set title "share of time at the limit, on half the slope"
set xlabel "edge [m]"
set logscale x
unset logscale y
set format x "10^{%L}"
set format y "%g"
set yrange [-0.05:1.05]
set key top right
plot folder."/length.csv" every ::1 using 1:3 with linespoints pt 7 ps 0.6 lc rgb "#2471a3" title "with Lc", \
     "" every ::1 using 1:5 with linespoints pt 7 ps 0.6 lc rgb "#c0392b" title "without"
