"""Behind the public door: a rig's devices, what lets them run, and who looks at them."""
