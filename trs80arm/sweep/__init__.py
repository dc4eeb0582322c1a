"""A program run over and over with something varied: what open loop means, in numbers.

`axes` says what is varied and over which values, `constants` changes the program, `placing` the
bench, `running` does the runs on all cores, `telling` makes file, table and chart of them. What
chance there is, errors in placing the parts, is drawn here from a seed and given to the bench as
places; the machine knows nothing of it.
"""
