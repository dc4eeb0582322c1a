"""The MiniMover 5: stepper motors, cables, joints, hand, and the bench it works on."""
