"""How fast the machine, its arm and its terminal are, as ratios within one run.

`python -m benchmarks` runs every part, `python -m benchmarks language start` two of them. Each part
is a module with `rows(seconds)`.
"""
