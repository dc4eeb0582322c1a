"""String space: the bytes of computed strings at the top of memory, and the ten temporaries.

Strings are allocated downward from the top of memory. What is no longer used stays as garbage until
the space is full; then the live strings are pushed together. String values are descriptors (length
and address), so POKEs into a string, FRE and OS come out as on the ROM (Level II facts,
Statements, Strings).
"""

from __future__ import annotations

from operator import itemgetter

from trs80arm.basic import addresses, costs
from trs80arm.basic.characters import LONGEST_STRING
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.host import Clock, Memory
from trs80arm.basic.kinds import STRING
from trs80arm.basic.variables import Descriptor, Variables

TEMPORARIES = 10
"""More strings than this pending in one expression are ?ST."""
LONGEST = LONGEST_STRING


class StringSpace:
    """The space between `bottom` and `top`, and the temporaries of the expression at work.

    Attributes:
        top: the last address of string space (40B1H).
        bottom: one below its first address (40A0H).
        next: the last free address (40D6H).
        temporaries: descriptors of the strings that are under way in an expression.
    """

    # Also in machines that are made as copies attributes are then found at once.
    __slots__ = (
        *("_memory", "_ram", "_end", "_clock", "_variables"),
        *("top", "bottom", "next", "temporaries"),
    )

    def __init__(self, memory: Memory, clock: Clock, variables: Variables) -> None:
        self._memory = memory
        self._ram = memory.ram
        self._end = memory.top
        self._clock = clock
        self._variables = variables
        self.top = memory.top - 1
        self.bottom = self.top - 50
        self.next = self.top
        self.temporaries: list[Descriptor] = []

    def reset(self, size: int | None = None) -> None:
        """Empty the space; `size` is its new size in bytes (CLEAR n)."""
        if size is not None:
            self.bottom = self.top - size
        self.next = self.top
        self.temporaries.clear()

    def bytes_of(self, string: Descriptor) -> bytes:
        """The characters of a string, wherever its descriptor points."""
        length, address = string
        end = address + length
        # From the program on bytes are plain RAM unless they lie among the variables.
        if address >= addresses.PROGRAM and (
            address > self.bottom or end <= self._variables.start or address >= self._variables.end
        ):
            # `Memory.read` is asked only where memory ends: nearly all strings come this way.
            return (
                self._memory.view[address:end].tobytes()
                if end <= self._end
                else self._memory.read(address, length)
            )
        peek = self._memory.peek
        return bytes([peek(place & 0xFFFF) for place in range(address, end)])

    def characters_of(self, string: Descriptor) -> bytes | bytearray:
        """The same to be cut and joined: as they come, where they are in string space."""
        length, address = string
        end = address + length
        if addresses.PROGRAM <= self.bottom < address and end <= self._end:
            return self._ram[address:end]
        return self.bytes_of(string)

    def free_bytes(self) -> int:
        """Collect the garbage and count what is free (FRE of a string)."""
        self.collect()
        return self.next - self.bottom

    # -- temporaries --------------------------------------------------------------------------

    def push(self, string: Descriptor) -> Descriptor:
        """Make a string a temporary; ST when there are ten already."""
        if len(self.temporaries) >= TEMPORARIES:
            raise BasicError(Code.ST)
        self.temporaries.append(string)
        return string

    def literal(self, length: int, address: int) -> Descriptor:
        """A temporary for characters that stand in memory already."""
        if len(self.temporaries) >= TEMPORARIES:
            raise BasicError(Code.ST)
        # The descriptor has one byte for the length.
        string = [length & 0xFF, address]
        self.temporaries.append(string)
        return string

    def free(self, string: Descriptor) -> None:
        """Drop a temporary if it is the last one; its bytes too if they were allocated last."""
        temporaries = self.temporaries
        if temporaries and temporaries[-1] is string:
            temporaries.pop()
            if string[1] == self.next + 1:
                self.next += string[0]

    def take(self, string: Descriptor) -> bytes:
        """The characters of a string whose temporary is no longer needed."""
        text = self.bytes_of(string)
        self.free(string)
        return text

    # -- allocation ---------------------------------------------------------------------------

    def allocate(self, length: int) -> int:
        """The address of `length` new bytes; OS when not even collecting makes room."""
        end = self.next - length
        if end < self.bottom:
            self.collect()
            end = self.next - length
            if end < self.bottom:
                raise BasicError(Code.OS)
        self.next = end
        return end + 1

    def _fill(self, address: int, text: bytes) -> None:
        """Write newly allocated bytes."""
        end = address + len(text)
        if address >= addresses.PROGRAM and end <= self._end:
            self._memory.view[address:end] = text
        else:
            self._memory.write(address, text)

    def new(self, text: bytes) -> Descriptor:
        """A temporary in string space with these characters; OS, ST."""
        length = len(text)
        address = self.allocate(length)
        self._fill(address, text)
        return self.push([length, address])

    def concatenate(self, left: Descriptor, right: Descriptor) -> Descriptor:
        """The two strings one after the other; LS above 255 characters, OS.

        The room is found before the two temporaries are dropped, as the ROM does, so their bytes
        become garbage (case `memory-mem-strings-literal`).
        """
        size, more = left[0], right[0]
        length = size + more
        if length > LONGEST:
            raise BasicError(Code.LS)
        next_ = self.next - length
        if next_ < self.bottom:
            next_ = self.allocate(length) - 1
        else:
            self.next = next_
        first, second, bottom, end = left[1], right[1], self.bottom, self._end
        address = next_ + 1
        if (
            bottom >= addresses.PROGRAM
            and bottom < first <= end - size
            and bottom < second <= end - more
            and bottom < address <= end - length
        ):
            # From string space to string space.
            ram = self._ram
            ram[address : address + length] = (
                ram[first : first + size] + ram[second : second + more]
            )
        else:
            self._fill(address, self.bytes_of(left) + self.bytes_of(right))
        self.free(right)
        self._clock.now += length * costs.STRING_BYTE
        return self._exchange(left, [length, address])

    def part(self, string: Descriptor, start: int, length: int) -> Descriptor:
        """`length` characters from `start` (0 for the first) as a new string (LEFT$ and so on)."""
        left = string[0] - start
        if length > left:
            length = left if left > 0 else 0
        next_ = self.next - length
        if next_ < self.bottom:
            next_ = self.allocate(length) - 1
        else:
            self.next = next_
        source, bottom, end = string[1], self.bottom, self._end
        address = next_ + 1
        if addresses.PROGRAM <= bottom < address <= end - length and (
            bottom < source <= end - string[0]
            or addresses.PROGRAM <= source <= self._variables.start - string[0]
        ):
            # From string space or the program to string space.
            source += start
            self._ram[address : address + length] = self._ram[source : source + length]
        else:
            self._fill(address, self.bytes_of(string)[start : start + length])
        self._clock.now += length * costs.STRING_BYTE
        return self._exchange(string, [length, address])

    def _exchange(self, old: Descriptor, new: Descriptor) -> Descriptor:
        """Drop a string that may be the last temporary, and make another a temporary; ST."""
        temporaries = self.temporaries
        if temporaries and temporaries[-1] is old:
            temporaries[-1] = new
            if old[1] == self.next + 1:
                self.next += old[0]
        elif len(temporaries) < TEMPORARIES:
            temporaries.append(new)
        else:
            raise BasicError(Code.ST)
        return new

    def assign(self, target: Descriptor, string: Descriptor, text_start: int) -> None:
        """Make `target` the string, as LET, READ and INPUT do.

        A temporary is taken over. Characters in the program text stay there. A string of the line
        that was typed, or of another variable in string space, is copied.
        """
        temporaries = self.temporaries
        temporary = bool(temporaries) and temporaries[-1] is string
        address = string[1]
        in_text = text_start < address <= self.bottom
        if not in_text and not (temporary and address > self.bottom):
            length = string[0]
            address = self.allocate(length)
            text = self.bytes_of(string)
            self._memory.write(address, text)
            self._clock.now += length * costs.STRING_BYTE
        if temporary:
            temporaries.pop()
        target[0] = string[0]
        target[1] = address

    # -- garbage ------------------------------------------------------------------------------

    def collect(self) -> None:
        """Push the live strings together at the top, highest first, as the ROM's collector does.

        The ROM looks through every descriptor for the highest string that is left, moves it, and
        starts again: the time grows with the square of the number of strings.
        """
        bottom, top = self.bottom, self.top
        variables = self._variables
        found: list[Descriptor] = [*self.temporaries]
        found += [s.cell.cell_contents for s in variables.order if s.kind == STRING]
        for array in variables.arrays.values():
            if array.kind == STRING:
                found += array.data
        live = [string for string in found if string[0] and bottom < string[1] <= top]
        live.sort(key=itemgetter(1), reverse=True)
        next_ = top
        view, lowest, end = self._memory.view, addresses.PROGRAM, self._end
        for string in live:
            length, address = string
            next_ -= length
            to = next_ + 1
            if to == address:
                continue
            if lowest <= to and lowest <= address and to + length <= end >= address + length:
                # Within RAM the bytes are moved as they are, also onto themselves.
                view[to : to + length] = view[address : address + length]
            else:
                self._memory.write(to, self._memory.read(address, length))
            string[1] = to
        self._clock.now += self._collecting(len(live)) + (top - next_) * costs.COLLECT_BYTE
        self.next = next_

    def _collecting(self, live: int) -> int:
        """T-states of a collection of so many live strings, beside moving their bytes."""
        strings = self._variables.count(STRING)
        look = costs.COLLECT_PASS + costs.COLLECT_STRING * (strings + len(self.temporaries))
        look += costs.COLLECT_NUMBER * (len(self._variables.order) - strings)
        for array in self._variables.arrays.values():
            look += costs.COLLECT_ARRAY
            if array.kind == STRING:
                look += costs.COLLECT_STRING_ARRAY + costs.COLLECT_ELEMENT * len(array.data)
        return (live + 1) * look + live * (costs.COLLECT_LIVE + costs.COLLECT_COMPARED * live)
