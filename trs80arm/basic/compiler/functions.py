"""The functions of Level II as operands: what stands in their parentheses and what they compute."""

from __future__ import annotations

from trs80arm.basic import costs, room, tokens
from trs80arm.basic.compiler.expressions import ExpressionCompiler
from trs80arm.basic.compiler.values import ANY, NUMBER, Expression
from trs80arm.basic.errors import Code
from trs80arm.basic.variables import DOUBLE, INTEGER, SINGLE, STRING

_SINGLE_FUNCTIONS = ("SQR", "LOG", "EXP", "COS", "SIN", "TAN", "ATN")
_DYNAMIC = ("FRE", "USR", "VAL", "CHR$", "STR$")
"""Functions whose time depends on what there is at run time; they end a block."""
_DISK_FUNCTIONS = ("CVI", "CVS", "CVD", "EOF", "LOC", "LOF", "MKI$", "MKS$", "MKD$")


class FunctionCompiler(ExpressionCompiler):
    """Expressions with the ROM's functions."""

    def function(self, code: int) -> Expression:
        """An operand that begins with a word."""
        name = tokens.WORDS[code - tokens.FIRST].decode("ascii")
        self.out.cost += costs.FUNCTION_WORK.get(name, 0)
        if code in (tokens.INSTR, tokens.TIME, tokens.FN):
            raise self.mistake(Code.L3)
        if code in (tokens.ERL, tokens.ERR, tokens.MEM, tokens.INKEY):
            self.reader.advance()
            return self._system_value(code)
        if code == tokens.VARPTR:
            return self._varptr()
        if code == tokens.STRING:
            return self._string_of_characters()
        if code == tokens.POINT:
            self.reader.advance()
            x, y = self.coordinates()
            self.observes = True
            return Expression(f"point({x}, {y})", INTEGER)
        if name in ("LEFT$", "RIGHT$", "MID$"):
            self.plain = False
            return self._part(name)
        self.reader.advance()
        if self.reader.code != 0x28:
            raise self.mistake(Code.SN)
        self.out.cost += costs.PARENTHESES
        self.reader.advance()
        self.deepen(room.FUNCTION)
        value = self.expression()
        self.deepen(-room.FUNCTION)
        self.close_parenthesis(value.text)
        self.out.cost += costs.FUNCTION
        if name in _DISK_FUNCTIONS:
            self.pending.append(value.text)
            raise self.mistake(Code.L3)
        return self._apply(name, value)

    def _system_value(self, code: int) -> Expression:
        if code == tokens.INKEY:
            self.plain = False
            self.observes = True
            return Expression("inkey()", STRING)
        if code == tokens.MEM:
            return Expression(f"free_memory({self.stack_bytes})", SINGLE)
        if code == tokens.ERL:
            return Expression("error_line()", SINGLE)
        return Expression("error_code()", NUMBER)

    def _varptr(self) -> Expression:
        self.reader.advance()
        self.expect(0x28)
        key = self.name()
        if self.reader.code == 0x28:
            _, subscripts = self.subscripts(key)
            text = f"element_address({key!r}, {', '.join(subscripts)})"
        else:
            scalar = self.scope.scalar(key)
            self.out.cost += costs.VARIABLE + self.scope.search(scalar)
            text = f"scalar_address({key!r})"
        self.close_parenthesis()
        return Expression(text, INTEGER)

    def _string_of_characters(self) -> Expression:
        self.plain = False
        self.reader.advance()
        self.expect(0x28)
        count = self.byte()
        self.pending.append(count)
        self.expect(0x2C)
        value = self.expression()
        self.close_parenthesis(value.text)
        self.pending.pop()
        if value.kind == STRING:
            return Expression(f"string_of({count}, first_code({value.text}))", STRING)
        return Expression(f"string_of({count}, {self.to_byte(value)})", STRING)

    def _part(self, name: str) -> Expression:
        """LEFT$, RIGHT$ and MID$: the string, then one or two numbers."""
        self.reader.advance()
        self.expect(0x28)
        string = self.expression()
        self.pending.append(string.text)
        self.expect(0x2C)
        if string.kind != STRING:
            raise self.mistake(Code.TM)
        first = self.byte()
        second = None
        if name == "MID$":
            self.pending.append(first)
            if self.reader.code == 0x2C:
                self.reader.advance()
                second = self.byte()
            elif self.reader.code != 0x29:
                raise self.mistake(Code.SN)
            self.pending.pop()
        self.pending.append(first)
        self.close_parenthesis()
        self.pending.pop()
        self.pending.pop()
        if name == "LEFT$":
            return Expression(f"left({string.text}, {first})", STRING)
        if name == "RIGHT$":
            return Expression(f"right({string.text}, {first})", STRING)
        arguments = f"{first}, {second}" if second is not None else first
        return Expression(f"middle({string.text}, {arguments})", STRING)

    def coordinates(self) -> tuple[str, str]:
        """`(x,y)` of SET, RESET and POINT; FC outside 128 by 48."""
        self.expect(0x28)
        x = f"below({self.byte()}, 128)"
        self.pending.append(x)
        self.expect(0x2C)
        y = f"below({self.byte()}, 48)"
        self.pending.append(y)
        self.close_parenthesis()
        del self.pending[-2:]
        return x, y

    def _apply(self, name: str, value: Expression) -> Expression:
        """A function of one argument in parentheses."""
        if name in _DYNAMIC:
            self.plain = False
        if name == "FRE":
            if value.kind == STRING:
                return Expression(f"free_strings({value.text})", SINGLE)
            return Expression(f"free_after({value.text}, {self.stack_bytes})", SINGLE)
        if name == "POS":
            return Expression(f"position({value.text})", INTEGER)
        if name == "USR":
            self.observes = True
            return Expression(f"user_routine({value.text})", ANY)
        if name in ("LEN", "ASC", "VAL"):
            if value.kind != STRING:
                self.pending.append(value.text)
                raise self.mistake(Code.TM)
            kind = ANY if name == "VAL" else INTEGER
            return Expression(f"{name.lower()}_({value.text})", kind)
        if value.kind == STRING:
            self.pending.append(value.text)
            raise self.mistake(Code.TM)
        if name in _SINGLE_FUNCTIONS:
            self.out.allow(costs.MOST_OF_CALL)
            return Expression(f"{name.lower()}({self.to_single(value)})", SINGLE)
        return self._numeric(name, value)

    def _numeric(self, name: str, value: Expression) -> Expression:
        if name == "PEEK":
            self.observes = True
            return Expression(f"peek({self.to_integer(value)})", INTEGER)
        if name == "INP":
            self.observes = True
            return Expression(f"read_port({self.to_byte(value)})", INTEGER)
        if name == "RND":
            if value.constant != 0:
                self.out.cost += costs.RND_OF_NUMBER
            return Expression(f"rnd({self.to_integer(value)})", SINGLE)
        if name == "CHR$":
            return Expression(f"chr_({self.to_byte(value)})", STRING)
        if name == "STR$":
            return Expression(f"str_({value.shown})", STRING)
        if name == "SGN":
            return Expression(f"sign({value.text})", INTEGER)
        if name == "CINT":
            return Expression(self.to_integer(value), INTEGER)
        if name == "CSNG":
            return Expression(self.to_single(value), SINGLE)
        if name == "CDBL":
            return Expression(self.to_double(value), DOUBLE)
        if name in ("INT", "FIX"):
            self.out.cost += costs.FLOOR[value.kind]
        if value.kind == INTEGER and name in ("INT", "FIX"):
            return value
        if value.kind == SINGLE and name == "INT":
            return Expression(f"({value.text} // 1.0)", SINGLE, whole=True)
        if value.kind == SINGLE:
            function = {"INT": "single_floor", "FIX": "fix", "ABS": "abs"}[name]
            return Expression(f"{function}({value.text})", SINGLE, whole=name != "ABS")
        function = {"INT": "any_floor", "FIX": "fix", "ABS": "absolute"}[name]
        kind = value.kind
        if kind == INTEGER:
            kind = NUMBER  # ABS(-32768) is a single.
        elif kind == DOUBLE and name != "ABS":
            kind = ANY  # INT of a double that has come to fit into an integer is one.
        return Expression(f"{function}({value.text})", kind)
