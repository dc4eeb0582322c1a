"""Native loops do what Python does: values, times, frames and errors."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.basic.core.test_blocks import PROGRAMS as BLOCKS
from tests.basic.native.machines import finish, left, taken

PROGRAMS = {
    "empty loop": ["10 FOR I=1 TO 500:NEXT"],
    "sums and quotients": [
        "10 K=K+1:A=K/2*3+4-5:B=A-K/7+B*.99:IF K<300 THEN 10",
        "20 PRINT A;B;K",
    ],
    "far apart and unlike": [
        "10 X=1000.3:FOR I=1 TO 300:X=X-.013:Y=X-I*1E-5:Z=Z+Y*1E-7-X:NEXT:PRINT X;Y;Z",
    ],
    "products of zero": [
        "10 FOR I=-5 TO 5:A=I*B+C:D=A*I-I*I:E=D*0+0*I:IF I<>0 THEN F=A/I+0/I",
        "20 NEXT:PRINT A;D;E;F",
    ],
    "steps": [
        "10 FOR I=10 TO -10 STEP -.75:FOR J%=5 TO I STEP -2:S=S+I*J%:NEXT J%,I",
        "20 FOR I=1 TO 0:T=T+1:NEXT:FOR I=0 TO 1 STEP .1:T=T+I:NEXT:PRINT S;T;I;J%",
        "30 K=7:FOR I=K TO K STEP 0:K=K+1:U=U+1:NEXT:PRINT U",
        "40 FOR I=1 TO 3:FOR J=I TO I+2:V=V+J:NEXT:NEXT:PRINT V",
    ],
    "loops left and begun again": [
        "10 FOR I=1 TO 40:FOR J=1 TO 9:IF J=I-INT(I/7)*7 THEN 30",
        "20 NEXT J",
        "30 S=S+J:FOR I=I TO 40:NEXT J,I",
    ],
    "integers": [
        "10 DEFINT A-D:FOR A=1 TO 90:B=A*A-3*A:C=B AND 255 OR 3:D=NOT C:E=E+D/A+(A>B)",
        "20 F=F-A:IF A>40 AND B>1000 OR C=7 THEN D=-D ELSE D=SGN(D-5)+FIX(E)",
        "30 NEXT:PRINT B;C;D;E;F",
    ],
    "arrays": [
        "10 DIM F(30,3),G%(40):FOR K=1 TO 20:FOR I=0 TO 3:F(K,I)=F(K-1,I)+K*I",
        "20 G%(K+I)=G%(K)+F(K,I)/3-INT(K/3):NEXT I,K:PRINT F(20,3);G%(23)",
    ],
    "subroutines": [
        "10 FOR I=1 TO 60:GOSUB 50:IF X>50 THEN GOSUB 60",
        "20 ON I-INT(I/4)*4 GOTO 40,30:X=X+1",
        "30 X=X+2:GOTO 40",
        "40 NEXT:PRINT X;Y:END",
        "50 X=X+1:GOSUB 60:RETURN",
        "60 Y=Y+ABS(X-Y)/2:RETURN",
    ],
    "printing now and then": [
        '10 FOR I=1 TO 200:S=S+I/3:IF I/50=INT(I/50) THEN PRINT S;:A$=A$+"X"',
        "20 NEXT:PRINT A$",
    ],
    "functions": ["10 FOR I=1 TO 30:A=SQR(I)+A:FOR J=1 TO 9:B=B+A*J:NEXT J,I:PRINT A;B"],
    "variables on the way": [
        "10 FOR I=1 TO 60:IF I>20 THEN Q=Q+I:IF I>40 THEN R(I-41)=Q:IF I>50 THEN S=5",
        "20 NEXT",
    ],
    "doubles and strings": ['10 FOR I=1 TO 40:A=A+I:IF I>20 THEN D#=D#+A:S$=S$+"A"', "20 NEXT"],
    "parentheses": ["10 FOR I=1 TO 20:A=(((((((((I+1)*I+2)*I+3)*I+4)-I)*I+5)/I+I)*I)-A):NEXT"],
    "line numbers": [
        "10 I=0",
        "20 I=I+1:IF I<200 THEN 20 ELSE PRINT I:GOTO 40",
        "30 GOTO 20",
        "40 END",
    ],
}
ERRORS = {
    "overflow": ["10 A=1:B=1", "20 B=B+1:A=A*9:GOTO 20"],
    "overflow of an integer": ["10 FOR I%=1 TO 32000 STEP 500:J%=J%+I%:NEXT"],
    "overflow of a step": ["10 FOR I%=1 TO 32767 STEP 1000:S=S+I%:NEXT"],
    "division by zero": ["10 FOR I=30 TO 0 STEP -1:A=A+1/I:NEXT"],
    "subscript": ["10 DIM A(50):FOR I=1 TO 60:A(I)=I*I:NEXT"],
    "negative subscript": ["10 FOR I=9 TO -5 STEP -1:A(I)=I*I:NEXT"],
    "next without for": ["10 GOSUB 20", "20 I=I+1:IF I<50 THEN 20 ELSE FOR J=1 TO 9:NEXT:NEXT"],
    "return without gosub": ["10 FOR I=1 TO 90:IF I>70 THEN RETURN", "20 NEXT"],
    "memory": ["10 B=B+1:GOSUB 20", "20 C=C+(B+1):GOSUB 10"],
    "a trap": [
        "10 ON ERROR GOTO 40:FOR I=-20 TO 20:A=A+1/I:B=B+1:NEXT:PRINT A;B;N:END",
        "40 N=N+1:RESUME NEXT",
    ],
    "underflow": ["10 A=1:FOR I=1 TO 60:A=A/9.3:B=B+A:NEXT:PRINT A;B"],
}


@pytest.mark.parametrize("name", {**PROGRAMS, **ERRORS, **BLOCKS})
def test_native_loops_and_python_agree_in_everything(name: str) -> None:
    lines = {**PROGRAMS, **ERRORS, **BLOCKS}[name]
    assert left(finish(lines, native=True)) == left(finish(lines, native=False))


# Functions are Python's; so are more than `room.FEW` subroutines, and NEXT of a loop further out.
PYTHONS = {"functions", "memory", "loops left and begun again"}


@pytest.mark.parametrize("name", sorted({**PROGRAMS, **ERRORS}.keys() - PYTHONS))
def test_most_of_a_loop_of_numbers_is_native(name: str) -> None:
    machine = finish({**PROGRAMS, **ERRORS}[name], native=True)
    assert taken(machine) > machine.clock.now / 4


@settings(max_examples=20, deadline=None)
@given(
    st.sampled_from(sorted(PROGRAMS)),
    st.lists(st.integers(200_000, 3_000_000), min_size=1, max_size=4),
    st.integers(0, 3),
)
def test_slices_and_copies_make_no_difference(name: str, slices: list[int], moves: int) -> None:
    whole = left(finish(PROGRAMS[name], native=False))
    assert left(finish(PROGRAMS[name], native=True, slices=slices, moves=moves)) == whole
