"""Blocks of statements do what single statements do, at the same times, however time is sliced."""

from __future__ import annotations

from collections import Counter

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.basic.machine import Machine
from trs80arm.basic.activity import Waiting
from trs80arm.basic.compiler.statements import StatementCompiler

PROGRAMS = {
    "loops": ["10 FOR I=1 TO 30:FOR J%=3 TO 1 STEP -1:S=S+I*J%:NEXT J%,I", "20 PRINT S"],
    "branches": [
        "10 K=K+1:IF K/3=INT(K/3) THEN A=A+1 ELSE IF K/2=INT(K/2) THEN B=B+1:GOTO 30",
        "20 C=C+1",
        "30 IF K<100 THEN 10",
        "40 PRINT A;B;C",
    ],
    "subroutines": ["10 FOR I=1 TO 50:GOSUB 30:NEXT", "20 PRINT X:END", "30 X=X+I*2:RETURN"],
    "arrays": [
        "10 DIM F(130):FOR I=2 TO 60:IF F(I) THEN 30",
        "20 FOR J=I*2 TO 60 STEP I:F(J)=1:NEXT:C=C+1",
        "30 NEXT:PRINT C",
    ],
    "memory": [
        "10 FOR I=0 TO 99:POKE 30000+I,I:NEXT",
        "20 FOR I=0 TO 99:S=S+PEEK(30000+I):NEXT:PRINT S",
    ],
    "errors": [
        "10 ON ERROR GOTO 50",
        "20 FOR I=-3 TO 3:A=1:B=1/I:C=C+B:NEXT",
        "30 PRINT C:END",
        "50 D=D+1:RESUME NEXT",
    ],
    "loops within loops": [
        "10 FOR P=1 TO 2:FOR I=3 TO 1 STEP -1:FOR J=0 TO 2 STEP .5:S=S+I*J-P:NEXT J,I,P",
        "20 FOR P=1 TO 3:FOR I=5 TO 1:T=T+1:NEXT:NEXT",
        "30 PRINT S;T",
    ],
    "loops left": [
        "10 FOR P=1 TO 3:FOR I=1 TO 9:IF I=4 THEN 30",
        "20 S=S+I:NEXT I",
        "30 NEXT P:FOR I=1 TO 3:FOR J=1 TO 3:T=T+1:IF T/2=INT(T/2) THEN NEXT I:GOTO 50",
        "40 NEXT J,I",
        "50 FOR I=1 TO 4:FOR I=2 TO 3:U=U+I:NEXT:IF U<20 THEN 50",
        "60 PRINT S;T;U",
    ],
    "subroutines in blocks": [
        "10 FOR P=1 TO 20:GOSUB 50:GOSUB 50:GOTO 30",
        "20 PRINT S;T:END",
        "30 IF P/3=INT(P/3) THEN GOSUB 70:NEXT ELSE T=T-1:NEXT",
        "40 GOTO 20",
        "50 S=S+1:GOSUB 60:RETURN",
        "60 FOR J=1 TO 2:S=S+J:IF S/5=INT(S/5) THEN RETURN ELSE NEXT:RETURN",
        "70 T=T+2:IF T<40 THEN T=T+1:GOSUB 70",
        "80 RETURN",
    ],
    "errors in blocks": [
        "10 ON ERROR GOTO 60:FOR P=-2 TO 2:FOR I=-1 TO 1:GOSUB 50:NEXT I,P",
        "20 PRINT S;E:END",
        "50 S=S+1/(I+P):RETURN",
        "60 E=E+ERL/10:RESUME NEXT",
    ],
    "variables made late": [
        "10 FOR I=1 TO 5:IF I>3 THEN A=A+I:B=B+A",
        "20 C=C+A:D=C:NEXT:PRINT A;B;C;D",
    ],
    "strings": [
        "10 CLEAR 60:FOR I=1 TO 60",
        '20 A$=LEFT$("HELLO WORLD",5)+MID$("GOOD BYE",3,2)+STR$(I):B$=RIGHT$(A$,3)',
        '30 IF B$>" 30" THEN C$=C$+CHR$(64+I/3):IF LEN(C$)>9 THEN C$="":D=D+1',
        "40 READ E$:IF E$=MID$(B$,2,1) OR VAL(B$)=33 OR E$=CHR$(88) THEN E=E+ASC(E$):RESTORE",
        "50 NEXT:PRINT A$;B$;C$;D;E",
        "60 DATA 1,2,3,4,5,6,7,8,9,X",
    ],
    "strings put together": [
        '10 CLEAR 140:DIM S$(3):A$="MINIMOVER":X#=1.5:FOR I=0 TO 12',
        '20 B$=MID$(A$,I/2+1,3)+"-"+RIGHT$(A$,I)+STR$(I/4)+CHR$(65+I)',
        '30 S$(I AND 3)=LEFT$(STR$(I),2)+MID$(STR$(-I),2)+STR$(I*2):C$=MID$("ROBOT",2,I AND 3)',
        '40 D$=LEFT$(A$+B$,I)+LEFT$("ARM",0):E$=MID$(LEFT$(A$,3),4)+RIGHT$(CHR$(48+I),1)',
        "50 IF LEN(B$)>13 THEN PRINT B$;D$;FRE(A$) ELSE E$=E$+S$(I AND 3)+STR$(X#)",
        "60 T=T+LEN(B$)+LEN(C$)+LEN(D$)+ASC(E$):NEXT:PRINT S$(0);S$(1);S$(2);S$(3);C$;E$;T;FRE(A$)",
    ],
    "strings too long": [
        "10 CLEAR 999:ON ERROR GOTO 50:FOR I=1 TO 8",
        '20 A$=A$+"0123456789ABCDEF"+A$:NEXT:END',
        "30 B$=LEFT$(A$,40)+MID$(A$,0)",
        '40 PRINT LEN(A$);LEN(B$);FRE(A$);RIGHT$(A$,0);S:B$="":A$=CHR$(S-1):END',
        "50 S=S+ERR:T=T+FRE(A$):IF ERL=20 THEN RESUME 30 ELSE IF ERL=30 THEN RESUME 40",
        "60 PRINT T;S;ERL:END",
    ],
    "string space full": [
        "5 CLEAR 40:ON ERROR GOTO 90",
        '10 FOR I=1 TO 9:A$=A$+"ABCDE":B$=A$+"F":C$=B$:NEXT:PRINT A$',
        "90 PRINT LEN(A$);ERR;ERL;FRE(A$):END",
    ],
    "loops over integers": [
        "10 FOR P=1 TO 3:FOR I%=3 TO -3 STEP -2:FOR J%=1 TO 2:S=S+I%*J%:NEXT J%,I%,P:PRINT S",
        "20 ON ERROR GOTO 40:FOR I%=32760 TO 32767 STEP 3:T=T+1:NEXT:PRINT T",
        "30 END",
        "40 PRINT T;I%;ERR/2+1;ERL:END",
    ],
    "loops with other limits": [
        "10 FOR N=1 TO 4:FOR I=N TO 5-N:S=S+1:NEXT:FOR J=1 TO N*N:T=T+J:N%=N:NEXT:NEXT",
        "20 PRINT S;T:FOR I=1 TO 3:PRINT I:FOR J=I TO 3:U=U+J:NEXT:NEXT:PRINT U",
    ],
    "a long way to variables": [
        f"{number} {chr(65 + number // 26)}{chr(65 + number % 26)}={number}"
        for number in range(1, 260)
        if chr(65 + number // 26) + chr(65 + number % 26) not in ("IF", "FN", "TO", "ON", "GO")
    ]
    + ["900 Q=Q+1:FOR I=1 TO 2:R=R+I:NEXT:S$=S$+CHR$(64+Q):IF Q<9 THEN 900 ELSE PRINT R;S$"],
    "functions": [
        "10 ON ERROR GOTO 50:FOR P=1 TO 2:FOR I=-3 TO 3",
        "20 S=S+SIN(I)+COS(I)*ATN(I)+EXP(I):T=T+SQR(I*I):T=T+I[2",
        "30 T=T+LOG(I):U=U+2[I+I[.5",
        "40 NEXT:NEXT:PRINT S;T;U;E:END",
        "50 E=E+ERR+ERL:RESUME NEXT",
    ],
    "rounds passed over": [
        "10 FOR I=1 TO 40:IF I/3=INT(I/3) THEN 40 ELSE IF I=20 THEN I=I+.5:GOTO 40",
        "20 S=S+I:FOR J%=1 TO 5:IF J%=I-3 THEN 30",
        "25 T=T+J%:IF T/2=INT(T/2) THEN 30 ELSE U=U+1",
        "30 NEXT J%:IF S>300 THEN 40",
        "35 FOR K=3 TO 1 STEP -1:ON K GOTO 38,38:V=V+K",
        "38 NEXT:W=W+1",
        "40 NEXT:PRINT S;T;U;V;W;I",
    ],
    "strings known and poked": [
        "5 CLEAR 300",
        '10 A$="AB"+"CD":FOR I=1 TO 9:B$=A$+STR$(I):P=PEEK(VARPTR(B$)+1)+256*PEEK(VARPTR(B$)+2)',
        "20 C$=LEFT$(B$,3):POKE P+65536*(P>32767),64+I:D$=LEFT$(B$,3)+C$:A$=RIGHT$(D$,4)",
        '30 E$="LITERAL":E$=E$+D$:F$=E$:IF F$=E$ THEN T=T+ASC(F$)+LEN(D$)',
        "40 NEXT:PRINT A$;B$;C$;D$;E$;F$;T",
    ],
    "doubles": ["10 A#=1:FOR I=1 TO 20:A#=A#*1.5#-I/3:NEXT:PRINT A#"],
}


def finish(machine: Machine, lines: list[str], slices: list[int]) -> tuple[object, ...]:
    machine.load(*lines)
    machine.do("RUN", seconds=0)
    for length in slices * 400:
        if machine.basic.waiting is Waiting.COMMAND:
            break
        machine.clock.limit = machine.clock.now + length
        machine.basic.advance(until_waiting=True)
    return bytes(machine.screen.printed), machine.clock.now, machine.basic.state.control.error_line


@pytest.mark.parametrize("name", PROGRAMS)
def test_blocks_and_statements_agree_to_the_t_state(name: str) -> None:
    whole = [2_000_000_000]
    blocks = finish(Machine(blocks=True), PROGRAMS[name], whole)
    assert blocks == finish(Machine(blocks=False), PROGRAMS[name], whole)
    assert b"Error" not in blocks[0]


@settings(max_examples=15, deadline=None)
@given(st.sampled_from(sorted(PROGRAMS)), st.lists(st.integers(200_000, 3_000_000), min_size=1))
def test_slices_make_no_difference(name: str, slices: list[int]) -> None:
    whole = finish(Machine(), PROGRAMS[name], [2_000_000_000])
    assert finish(Machine(), PROGRAMS[name], slices) == whole


def test_a_return_without_gosub_costs_the_same_in_a_block() -> None:
    lines = ["5 REM", "10 RETURN"]
    blocks = finish(Machine(blocks=True), lines, [2_000_000_000])
    assert blocks == finish(Machine(blocks=False), lines, [2_000_000_000])
    assert b"?RG Error in 10" in blocks[0]


def test_subroutines_without_end_find_memory_full_at_the_same_time() -> None:
    lines = ["10 B=B+1:GOSUB 20", "20 C=C+(B+1):GOSUB 10"]
    blocks = finish(Machine(blocks=True), lines, [2_000_000_000])
    assert blocks == finish(Machine(blocks=False), lines, [2_000_000_000])
    assert b"?OM Error" in blocks[0]


def test_a_statement_is_written_at_most_twice(monkeypatch: pytest.MonkeyPatch) -> None:
    """Once at the end of a block or with something missing, and once more by itself or with it."""
    written: Counter[int] = Counter()
    compile_ = StatementCompiler.compile

    def count(self: StatementCompiler) -> bool:
        written[self._reader.address] += 1
        return compile_(self)

    monkeypatch.setattr(StatementCompiler, "compile", count)
    lines = [f"{10 * n} K=K+{n}:IF K<0 THEN PRINT K ELSE A(3)=K*2" for n in range(1, 100)]
    machine = Machine()
    machine.load(*lines)
    machine.do("RUN")
    assert len(written) > 190
    assert max(written.values()) <= 2
