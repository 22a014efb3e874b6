# Called with the folder of the tables and the picture to write.
folder = ARG1
set terminal svg size 900,360 font "sans-serif,13" background "white" dynamic
set output ARG2
set datafile separator ","
set multiplot layout 1,2
set grid lc rgb "#dddddd"
set border 3
set tics nomirror

set title "the spring's force over the pull"
set xlabel "time over 2π √(m/kt)"
set yrange [0:2.7]
set key top right horizontal maxcols 2
plot folder."/onset.csv" every ::1 using 1:3 with lines lw 5 lc rgb "#cccccc" title "exact", \
     "" every ::1 using 1:5 with lines lw 5 lc rgb "#cccccc" notitle, \
     "" every ::1 using 1:7 with lines lw 5 lc rgb "#cccccc" notitle, \
     "" every ::1 using 1:2 with lines lw 1.5 lc rgb "#c0392b" title "γt = 0", \
     "" every ::1 using 1:4 with lines lw 1.5 lc rgb "#2471a3" title "γt = 0.5", \
     "" every ::1 using 1:6 with lines lw 1.5 lc rgb "#1e8449" title "γt = 2"

set title "time until it carries the tile [s]"
set xlabel "kt [N/m]"
set logscale xy
set format "10^{%L}"
set yrange [*:*]
plot folder."/delay.csv" every ::1 using 1:3 with lines lw 5 lc rgb "#cccccc" title "(π/2) √(m/kt)", \
     "" every ::1 using 1:2 with points pt 7 ps 0.5 lc rgb "#c0392b" title "measured"
