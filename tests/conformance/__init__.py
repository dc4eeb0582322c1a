"""What the original Level II ROM did, and the machine held to it.

`python -m tests.conformance FOLDER` runs every case of a folder; `test_conformance.py` runs the
ones in `cases/`. The form of the cases is described in `cases/README.md`.
"""
