"""Arm, bench and runs for other programs: MJCF, URDF, glTF, tables in joint space.

All of it is made of one description of the arm as a chain of links (`chain`), computed from its
`ArmModel`, and of what stands on the bench (`stage`).
"""
