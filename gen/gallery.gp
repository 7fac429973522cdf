# gallery.gp -- what the pictures ex_gen_<family> have in common; each loads it. `data` is a folder
# with the sets that the lines "#   gen ..." of the plot make (Makefile), by the name of their --out.
set terminal svg size 480,270 font "DejaVu Sans,11" background rgb "white"
set output image
set datafile separator ","
set datafile columnheaders
set border 31
unset tics
table(set, name) = data."/".set."/".name."/train-00000-of-00001.csv"
# a column of sample s, and nothing of the others
only(s, name) = column("sample") == s ? column(name) : NaN
