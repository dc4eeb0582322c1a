"""Noise for every door of the program, and what must hold whatever comes through.

`python -m tests.fuzz --minutes N --target T --seed S` works until its time is over; a bounded part
runs with the other tests. A case is plain JSON. What it finds is made as small as it can and kept
in `found/`, where every file is a case that the tests play again.
"""
