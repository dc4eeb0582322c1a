"""The numbers of Level II: integers of 16 bits, single precision of 24, double precision of 56.

An integer is a Python `int`, a single a Python `float` that always holds a value the machine could
hold, a double a `Double`. The interpreter calls the modules here for everything it does with a
number: arithmetic, functions, reading, printing. They know nothing of programs or memory.
"""
