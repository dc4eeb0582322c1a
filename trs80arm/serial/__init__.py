"""The arm behind a serial line: the TeachMover's own computer, and who can talk to it.

`docs/serial.md` tells the protocol, each command with where it is known from.
"""
