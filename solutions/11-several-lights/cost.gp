# What a light costs: draws cost.svg from the table of the study. From the top folder:
#     build/chart --scene "wide lamp" --quick && gnuplot solutions/11-several-lights/cost.gp
table = "< grep '^wide lamp,11,ours' build/study/chart.csv | awk -F, '{ print $(NF - 6), $10, $12 }'" # taps, prepare, shade
set terminal svg size 620,320 font "sans-serif,14" background "#f4f2ec"
set output "solutions/11-several-lights/cost.svg"
set xlabel "maps (n x n small lamps)"
set ylabel "ms of a frame (320 x 240)"
set key top left
set grid
set xrange [0:66]
set yrange [0:*]
drawn(x) = a + b * x
asked(x) = c + d * x
fit drawn(x) table using 1:2 via a, b
fit asked(x) table using 1:3 via c, d
plot table using 1:3 with points pt 7 ps 0.8 lc rgb "#b5651d" title "the picture: lookups", \
     asked(x) lc rgb "#b5651d" title sprintf("%.2f ms + %.2f ms a map", c, d), \
     table using 1:2 with points pt 5 ps 0.8 lc rgb "#0072b2" title "the maps", \
     drawn(x) lc rgb "#0072b2" title sprintf("%.2f ms + %.2f ms a map", a, b)
