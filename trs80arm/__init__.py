"""The TRS-80, ARMBASIC and the MiniMover 5, wired together: `Rig` is the public door."""
