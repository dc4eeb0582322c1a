"""Hot loops of numbers as WebAssembly, where the extra `fast` is installed.

A program computes for seconds in some loop of assignments, comparisons and jumps. `hot` notices it
by looking now and then where the program is, `loops` finds the statements that belong together,
`lowering` makes WebAssembly of the very Python text that the compiler has for them, with every
rounding and T-state, `module` puts them together, and `exchange` carries variables, arrays and open
loops in and out. What cannot be done there is left to Python at the statement's edge.
"""
