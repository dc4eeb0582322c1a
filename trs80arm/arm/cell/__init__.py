"""The work cell: what hangs on the auxiliary output and the free inputs, a module a device."""
