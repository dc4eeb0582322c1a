; CATCH for the TRS-80 Model I, Level II
; ======================================
;
; A ball falls, a bat catches it. The left and right arrows move the bat,
; and the base of a Mini Mover 5 on ports 152 and on turns along with it.
; BREAK leads back to READY; so does the fifth ball that is missed.
;
; Assemble it with pyz80 (docs/make_catch.py makes the tape).

CLS:    EQU  0x01C9             ; clear the screen
DELAY:  EQU  0x0060             ; BC times 26 T-states
KEYIN:  EQU  0x0049             ; wait for a key
READY:  EQU  0x06CC

ROW6:   EQU  0x3840             ; BREAK is bit 2, LEFT bit 5, RIGHT bit 6
SCREEN: EQU  0x3C00
WIDTH:  EQU  64
BASE:   EQU  0x98               ; the latch of the base's motor

BLANK:  EQU  128                ; graphic characters
BLOCK:  EQU  191
ROUND:  EQU  158

SIZE:   EQU  5                  ; of the bat
LINES:  EQU  14                 ; that a ball falls
FRAMES: EQU  5                  ; for each of them
FRAME:  EQU  1000               ; length of one, 26 T-states each
STEPS:  EQU  4                  ; half-steps of the base for each move
PACE:   EQU  100                ; time of one
LOST:   EQU  5                  ; balls missed that end the game

        ORG  0x7000

START:  CALL CLS
        LD   HL,TITLE
        LD   DE,SCREEN
        LD   BC,TEXTS-TITLE
        LDIR
        LD   HL,CAUGHT          ; counts to zero
        LD   (HL),0
        INC  HL
        LD   (HL),0
        LD   A,29
        LD   (BAT),A
        CALL SCORE
        CALL DRAW

; ---- A ball ------------------------------------------------------------

BALL:   LD   A,(SEED)           ; its column, by chance
        LD   B,A
        ADD  A,A
        ADD  A,A
        ADD  A,B
        ADD  A,17
        LD   (SEED),A
        AND  WIDTH-1
        LD   (COLUMN),A
        LD   L,A
        LD   H,0
        LD   DE,SCREEN+WIDTH
        ADD  HL,DE
        LD   B,LINES
FALL:   LD   (HL),ROUND
        LD   C,FRAMES
WAIT:   PUSH BC
        PUSH HL
        CALL KEYS
        LD   BC,FRAME
        CALL DELAY
        POP  HL
        POP  BC
        DEC  C
        JR   NZ,WAIT
        LD   (HL),BLANK
        LD   DE,WIDTH
        ADD  HL,DE
        DJNZ FALL

        LD   A,(BAT)            ; is the bat there
        LD   B,A
        LD   A,(COLUMN)
        SUB  B
        CP   SIZE
        LD   HL,CAUGHT
        JR   C,COUNT
        INC  HL                 ; MISSED
COUNT:  INC  (HL)
        CALL SCORE
        LD   A,(MISSED)
        CP   LOST
        JR   NZ,BALL

        LD   HL,TEXTS
        LD   DE,SCREEN+7*WIDTH+20
        LD   BC,CAUGHT-TEXTS
        LDIR
        CALL KEYIN
LEAVE:  XOR  A
        OUT  (BASE),A
        JP   READY

; ---- The keyboard ------------------------------------------------------

KEYS:   LD   A,(ROW6)
        BIT  2,A
        JR   NZ,LEAVE
        LD   HL,BAT
        BIT  5,A
        JR   NZ,LEFT
        BIT  6,A
        RET  Z
        LD   A,(HL)             ; RIGHT
        CP   WIDTH-SIZE-1
        RET  Z
        INC  (HL)
        LD   E,1
        JR   MOVED
LEFT:   LD   A,(HL)
        CP   1
        RET  Z
        DEC  (HL)
        LD   E,-1
MOVED:  CALL TURN

DRAW:   LD   A,(BAT)            ; the bat, a blank on either side
        LD   L,A
        LD   H,0
        LD   DE,SCREEN+15*WIDTH-1
        ADD  HL,DE
        LD   (HL),BLANK
        LD   B,SIZE
DRAW1:  INC  HL
        LD   (HL),BLOCK
        DJNZ DRAW1
        INC  HL
        LD   (HL),BLANK
        RET

; ---- The base ----------------------------------------------------------
;
; E is 1 or -1, the way through the table of half-steps.

TURN:   LD   D,STEPS
TURN1:  LD   A,(PHASE)
        ADD  A,E
        AND  7
        LD   (PHASE),A
        LD   C,A
        LD   B,0
        LD   HL,COILS
        ADD  HL,BC
        LD   A,(HL)
        OUT  (BASE),A
        LD   BC,PACE
        CALL DELAY
        DEC  D
        JR   NZ,TURN1
        RET

; ---- The counts --------------------------------------------------------

SCORE:  LD   A,(CAUGHT)
        LD   HL,SCREEN+14
        CALL DIGITS
        LD   A,(MISSED)
        LD   HL,SCREEN+25
DIGITS: LD   B,47               ; two digits of A
TENS:   INC  B
        SUB  10
        JR   NC,TENS
        ADD  A,58
        LD   (HL),B
        INC  HL
        LD   (HL),A
        RET

; ---- What it keeps -----------------------------------------------------

TITLE:  DEFM "CATCH  CAUGHT 00  MISSED 00   ARROWS MOVE, BREAK ENDS"
TEXTS:  DEFM "GAME OVER: PRESS A KEY"
CAUGHT: DEFB 0
MISSED: DEFB 0
BAT:    DEFB 29
COLUMN: DEFB 0
SEED:   DEFB 5
PHASE:  DEFB 0
COILS:  DEFB 9,1,5,4,6,2,10,8
