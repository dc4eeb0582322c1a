"""Twenty programs in the manner of the magazines of 1978 to 1981, and what they print.

Each is a listing `NAME.bas`, what the operator does in `NAME.script.json` (in the form of the
conformance cases' scripts), and what the original ROM displayed in `NAME.golden.txt`.
"""
