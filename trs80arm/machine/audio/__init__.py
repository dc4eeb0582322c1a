"""Cassettes as sound: what the line to the recorder carries, written and heard.

`wav.py` knows the files, `waveform.py` makes the sound that the ROM makes. Hearing goes the
other way in steps: `pulses.py` from sound to pulses, `cells.py` from pulses to bits, `bits.py`
from bits to recordings; `listening.py` does them and chooses the best hearing, `speeds.py` says
what was recorded for another machine.
"""
