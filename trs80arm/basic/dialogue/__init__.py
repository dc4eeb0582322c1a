"""The dialogue between machine and operator: prompts, line editor, EDIT, AUTO, LIST, INPUT, tape.

Every module is one thing the ROM does while the operator looks on; all of them are activities on
the interpreter's stack.
"""
