"""What compiled statements call: the work of the ROM's routines, bound to one interpreter."""
