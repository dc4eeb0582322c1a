"""Programs read without running them: `trs80arm check`."""
