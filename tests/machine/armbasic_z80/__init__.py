"""The ARMBASIC driver in Z-80 code: its source, its tapes, its routines."""
