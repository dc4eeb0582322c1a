"""`python -m trs80arm` is the command `trs80arm`."""

from trs80arm.cli import main

if __name__ == "__main__":
    main()
