; ARMBASIC for the TRS-80 Model I, Level II, and the Mini Mover 5
; ================================================================
;
; Five statements beside those of Level II BASIC,
;
;       @STEP D,J1,J2,J3,J4,J5,J6       @CLOSE D        @SET D
;       @READ V1,V2,V3,V4,V5,V6         @RESET
;
; and the routines behind them, for USR and for machine programs.
; The interface card is on eight ports from 152 (98 hex) on: motors
; J1 to J6, the auxiliary output, and one that is not connected; the
; four inputs are read at all of them, the grip switch on bit 0.
;
; Assemble it with pyz80, with the place in memory as ORIGIN: 31200 for
; 16K, 47584 for 32K and 63968 for 48K of memory, whose end it fills.


; ---- What it uses of the Level II ROM and of its memory ----------------

KEYIN:  EQU  0x002B             ; scan the keyboard: a code in A, or 0
REENT:  EQU  0x06CC             ; back to READY
CINT:   EQU  0x0A7F             ; the number at hand as an integer in HL
PUTINT: EQU  0x0A9A             ; an integer in HL as the number at hand
SNERR:  EQU  0x1997             ; ?SN Error
NEW:    EQU  0x1B4D
NEWSTT: EQU  0x1D1E             ; the next statement
BEGINS: EQU  0x1D5B             ; who asks for a statement's first character
INSIDE: EQU  0x2050             ; the same behind THEN and ELSE
GETCH:  EQU  0x1D78             ; the next character that is not a blank
STOP:   EQU  0x1DA9
GETPOS: EQU  0x1E46             ; an expression of 0 to 32767 in DE, or ?FC
PTRGET: EQU  0x260D             ; a variable: its address in DE
CONVRT: EQU  0x2819             ; the number at hand to the type in A
GETINT: EQU  0x2B02             ; an expression of -32768 to 32767 in DE

FETCH:  EQU  0x4003             ; vector of RST 10H, which fetches characters
STRTOP: EQU  0x40A0             ; end of string space
TYPE:   EQU  0x40AF             ; type of the number at hand: 2, 4 or 8 bytes
MEMTOP: EQU  0x40B1             ; end of memory for BASIC
BEGUN:  EQU  0x40E6             ; where the statement begins that is done
NUMBER: EQU  0x4121             ; the number at hand; a double one begins
DOUBLE: EQU  0x411D             ; four bytes before it

ROW0:   EQU  0x3801             ; keyboard: E is bit 5
ROW2:   EQU  0x3804             ; Q, R, T, W are bits 1, 2, 4, 7
ROW3:   EQU  0x3808             ; Y is bit 1
ROW4:   EQU  0x3810             ; 0 to 6 are bits 0 to 6
ROW6:   EQU  0x3840             ; BREAK is bit 2

TSET:   EQU  0x83               ; the words behind the @, as BASIC keeps them
TRESET: EQU  0x82
TREAD:  EQU  0x8B
TCLOSE: EQU  0xA6
TSTEP:  EQU  0xCC

NORMAL: EQU  50                 ; D of an @CLOSE or @SET that gives none


; ---- Entries -----------------------------------------------------------
;
; For the tape (/) and for machine programs. They use all of the
; registers but the second set.

        ORG  ORIGIN             ; a multiple of 32

START:  JP   INIT               ; + 0 hook the statements in, READY
        JP   MOVE               ; + 3 @STEP. HL: address of D, J1 to J6
        JP   CLOSE              ; + 6 @CLOSE. DE: D
        JP   MANUAL             ; + 9 @SET. DE: D
        JP   OFF                ; +12 @RESET; for USR as well: USR(0)
        JP   READ               ; +15 @READ. HL: where six words go
        JP   PACE               ; +18 how long a tick is. DE: D
        JP   PULSE              ; +21 a half step of some motors, by WAYS
        JP   WAIT               ; +24 the rest of a tick

; For USR, with what stands in the parentheses.

        JP   UMOVE              ; +27 USR(VARPTR(A%(0))), A%(0..6): D, J1..J6
        JP   UCLOSE             ; +30 USR(D), which is -1 after BREAK, else 0
        JP   UMANUA             ; +33 USR(D), the same
        JP   UREAD              ; +36 USR(VARPTR(A%(0))): J1..J6 to A%(0..5)

; What may be changed.

BASE:   DEFB 0x98               ; +39 the port of J1; then START again
GRIP:   DEFB 1                  ; +40 the bit of the grip switch, 1 2 4 or 8
SHUT:   DEFB 0                  ; +41 what that bit is when closed: it, or 0

; Where each motor is to go in the next half step: 1, 255 for -1, or 0.

WAYS:   DEFB 0,0,0,0,0,0        ; +42


; ---- What it keeps -----------------------------------------------------

SWITCH: DEFB 0                  ; the inputs after the last half step
LETGO:  DEFB 0                  ; bit 0: key 0 has been seen up
TURN:   DEFB 0                  ; 255 in even ticks of @SET, 0 in odd ones
ODD:    DEFB 0                  ; what WAIT waits: T-states, 0 to 31,
LONG:   DEFW 0                  ; times 32 of them,
FRAC:   DEFW 0                  ; 65536ths of one,
PART:   DEFW 0                  ; and how many of those have come together
MOST:   DEFW 0                  ; steps of the motor that has most to do
LEFT:   DEFW 0                  ; ticks that are left of a move
        DEFW 0                  ; (free)

; Figure 8: the coils of the eight half steps, phi1 as 8 and phi4 as 1.
; It begins at a multiple of 32, and the two tables behind it are in the
; same page of 256.

RING:   DEFB 5,4,6,2,10,8,9,1

; Elbow and hand keys together can ask the hand motor for two half steps
; in a tick: its own and the one against the elbow's. It makes one. By
; hand less elbow, 0 1 2 . . . -2 -1: where the hand motor goes, and
; whether the elbow may always move (255) or in every second tick (0).

HANDS:  DEFB 0,1,1,0,0,0,-1,-1
ELBOWS: DEFB 255,255,0,255,255,255,0,255

; The half steps that each motor has made. The last three bits are its
; place in RING, so @RESET does not touch them: it keeps in ZEROS what
; they were.

COUNTS: DEFW 0,0,0,0,0,0
ZEROS:  DEFW 0,0,0,0,0,0

ARGS:   DEFW 0,0,0,0,0,0,0      ; D, J1 to J6 of a move
COILS:  DEFB 0,0,0,0,0,0        ; what the six latches get


; ---- From the tape -----------------------------------------------------
;
; Where MEMORY SIZE? was answered with ENTER, the end of BASIC's memory
; is put below this; what was in it is lost. Otherwise nothing is.

INIT:   LD   HL,HOOK
        LD   (FETCH+1),HL
        LD   A,(BASE)           ; the motors' ports, one behind the other
        LD   HL,SLOT0+2
        LD   DE,3
        LD   B,6
INPORT: LD   (HL),A
        ADD  HL,DE
        INC  A
        DJNZ INPORT
        LD   DE,ORIGIN
        LD   HL,(MEMTOP)
        OR   A
        SBC  HL,DE
        JP   C,REENT
        LD   HL,ORIGIN-2
        LD   (MEMTOP),HL
        LD   DE,-50             ; as much for strings as after power-on
        ADD  HL,DE
        LD   (STRTOP),HL
        CALL NEW
        JP   REENT


; ---- The hook ----------------------------------------------------------
;
; BASIC fetches every character by RST 10H, whose vector is in memory. An
; @ that is fetched as the first character of a statement is ours.
;
; Letters and words of BASIC, which are nearly all, come back from here
; at once, with the flags as the ROM has them: no carry, not zero.

HOOK:   INC  HL
        LD   A,(HL)
        CP   "@"
        JR   C,LOWER
        RET  NZ
        JR   AT
LOWER:  CP   ":"
        RET  NC                 ; the colon: zero; ; < = > and ?: not zero
        DEC  HL
        CP   0x21
        JP   NC,GETCH           ; figures and signs
        CALL GETCH              ; behind blanks an @ can come
        PUSH AF
        CP   "@"
        JR   Z,BLANKS
        POP  AF
        RET
BLANKS: POP  AF

AT:     EX   (SP),HL            ; who asks?
        LD   A,L
        CP   BEGINS\256
        JR   NZ,ATTHEN
        LD   A,H
        CP   BEGINS>>8
        JR   Z,FIRST
ATTHEN: LD   A,L
        CP   INSIDE\256
        JR   NZ,ATNO
        LD   A,H
        CP   INSIDE>>8
        JR   Z,WORD
ATNO:   EX   (SP),HL
        LD   A,"@"              ; somebody else: PRINT @
        CP   ":"
        RET

FIRST:  LD   DE,NEWSTT          ; where statements return to; behind THEN
        POP  HL                 ; the IF has left that on the stack
        PUSH DE
        PUSH HL
WORD:   POP  HL
        RST  0x10
        CP   TSTEP
        JR   Z,ATSTEP
        CP   TSET
        JR   Z,ATSET
        CP   TCLOSE
        JR   Z,ATCLOS
        CP   TREAD
        JP   Z,ATREAD
        CP   TRESET
NOGOOD: JP   NZ,SNERR


; ---- @RESET ------------------------------------------------------------

        RST  0x10
        JR   NZ,NOGOOD
        PUSH HL
        CALL OFF
        POP  HL
        RET


; ---- @STEP D,J1,J2,J3,J4,J5,J6 -----------------------------------------

ATSTEP: PUSH HL
        LD   HL,ARGS            ; what is not given is 0
        LD   DE,ARGS+1
        LD   BC,13
        LD   (HL),B
        LDIR
        POP  HL
        RST  0x10
        CALL GETPOS
        LD   (ARGS),DE
        LD   DE,ARGS+2
        LD   B,6
STNEXT: DEC  HL
        RST  0x10
        JR   Z,STGO
        PUSH DE
        PUSH BC
        RST  8                  ; a comma, or ?SN
        DEFB ","
        CALL GETINT
        POP  BC
        EX   (SP),HL
        LD   (HL),E
        INC  HL
        LD   (HL),D
        INC  HL
        EX   DE,HL
        POP  HL
        DJNZ STNEXT
        DEC  HL
        RST  0x10
        JR   NZ,NOGOOD
STGO:   PUSH HL
        LD   HL,ARGS
        CALL MOVE
        POP  HL
        RET


; ---- @SET D and @CLOSE D -----------------------------------------------

ATSET:  CALL DELAY
        PUSH HL
        CALL START+9            ; MANUAL, by its entry
        PUSH AF                 ; the key that ended it is still down,
        CALL NOKEYS             ; and must not be typed into what comes next
        POP  AF
        JR   ENDED
ATCLOS: CALL DELAY
        PUSH HL
        CALL CLOSE
        CALL C,NOKEYS
ENDED:  POP  HL
        RET  NC
        LD   HL,(BEGUN)
        XOR  A
        JP   STOP               ; as if a STOP stood here: Break in; CONT
                                ; begins the statement again

DELAY:  RST  0x10               ; D, or what it is when it is not there
        LD   DE,NORMAL
        RET  Z
        CALL GETPOS
        DEC  HL
        RST  0x10
        RET  Z
        JR   NOGOOD

NOKEYS: CALL KEYIN              ; what is down is taken as typed
        OR   A
        JR   NZ,NOKEYS
        SCF
        RET


; ---- @READ V1,V2,V3,V4,V5,V6 -------------------------------------------

ATREAD: PUSH HL
        LD   HL,ARGS
        CALL READ
        POP  HL
        RST  0x10
        LD   DE,ARGS
        LD   B,6
RDNEXT: PUSH BC
        PUSH DE
        CALL PTRGET             ; any numeric variable
        EX   (SP),HL
        LD   C,(HL)
        INC  HL
        LD   B,(HL)             ; the register, in BC
        INC  HL
        PUSH HL
        PUSH DE
        LD   A,(TYPE)
        PUSH AF
        LD   H,B
        LD   L,C
        CALL PUTINT
        POP  AF
        PUSH AF
        CALL CONVRT             ; a string is ?TM
        POP  AF
        POP  DE
        LD   HL,NUMBER
        CP   8
        JR   NZ,RDCOPY
        LD   HL,DOUBLE
RDCOPY: LD   C,A
        LD   B,0
        LDIR
        POP  DE
        POP  HL
        POP  BC
        DEC  HL
        RST  0x10
        RET  Z
        RST  8
        DEFB ","
        DJNZ RDNEXT
        JP   SNERR


; ---- For USR -----------------------------------------------------------

UCLOSE: CALL CINT
        EX   DE,HL
        CALL CLOSE
        JR   UENDS
UMANUA: CALL CINT
        EX   DE,HL
        CALL MANUAL
UENDS:  SBC  HL,HL              ; carry: -1
        JP   PUTINT
UMOVE:  CALL CINT               ; and goes on with MOVE


; ---- A coordinated move (Figure 10) ------------------------------------
;
; In:   HL      the address of seven words, D and J1 to J6
;
; The motor with the most steps, N of them, makes one in every tick. One
; with n makes step i, counted from 0, in tick i(N-1)/(n-1), rounded
; down: its first in the first tick and its last in the last. One with a
; single step makes it in the last.
;
; The hand motor makes J6-J3, because the elbow opens the hand by a half
; step with each of its own.
;
; Each motor has a remainder r, which begins as 0. In each tick n-1 is
; taken from it; if it would be less than 0 there is a step, and N-1 is
; added. A single step begins with r = N-1 and takes 1 each time. r, N-1
; and n-1 are 0 to 65535 (J6-J3 can be as much).

MOVE:   LD   DE,ARGS
        LD   BC,14
        LDIR
        LD   HL,0
        LD   (MOST),HL
        LD   IX,R0              ; the motor's piece of TICK
        LD   DE,ARGS+2
        LD   B,5
MVSIZE: EX   DE,HL
        LD   E,(HL)
        INC  HL
        LD   D,(HL)
        INC  HL
        EX   DE,HL
        PUSH DE
        LD   A,H
        RLA                     ; its sign
        CALL SIZE
        POP  DE
        DJNZ MVSIZE
        LD   HL,(ARGS+12)
        LD   DE,(ARGS+6)
        OR   A
        SBC  HL,DE              ; 17 bits with the sign, which is S,
        LD   A,H                ; or not S where there was an overflow
        JP   PO,MVSIGN
        CPL
MVSIGN: RLA
        CALL SIZE
        LD   HL,(MOST)
        LD   A,H
        OR   L
        RET  Z                  ; nobody has anything to do
        LD   (LEFT),HL
        DEC  HL
        LD   (LAST+1),HL
        LD   IX,R0
        LD   B,6
MVMOTO: LD   L,(IX+STEPS)
        LD   H,(IX+STEPS+1)
        LD   DE,0               ; r
        LD   A,H
        OR   L
        JR   Z,MVKEEP           ; no steps: 0 is taken, there is never one
        DEC  HL                 ; n-1
        LD   A,H
        OR   L
        JR   NZ,MVKEEP
        INC  HL                 ; a single step
        LD   DE,(LAST+1)
MVKEEP: LD   (IX+STEPS),L
        LD   (IX+STEPS+1),H
        LD   (IX+REST),E
        LD   (IX+REST+1),D
        LD   DE,PIECE
        ADD  IX,DE
        DJNZ MVMOTO
        LD   DE,(ARGS)
        LD   HL,TTICK
        CALL PACE

; A tick. The numbers stand in the instructions that use them, which is
; quicker. Both ways through a motor's piece take 109 T-states.

TICK:
LAST:   LD   BC,0               ; N-1
M:      EQU  FOR 6              ; for the six motors; listed once
R{M}:   LD   HL,0               ; r
S{M}:   LD   DE,0               ; n-1, or 0 or 1
        OR   A
        SBC  HL,DE
        SBC  A,A                ; 255 if there is a step
W{M}:   AND  0                  ; which way it would be
        LD   (WAYS+M),A
        JR   Z,NONE{M}
        ADD  HL,BC
        JR   DONE{M}
NONE{M}:INC  DE                 ; 18 T-states, as many as ADD and JR
        NOP                     ; less what JR Z has taken more
        NOP
        NOP
DONE{M}:LD   (R{M}+1),HL
        NEXT M
        CALL PULSE
        CALL WAIT
        LD   HL,(LEFT)
        DEC  HL
        LD   (LEFT),HL
        LD   A,H
        OR   L
        JP   NZ,TICK
        RET

REST:   EQU  1                  ; places in a piece
STEPS:  EQU  S0+1-R0
WAY:    EQU  W0+1-R0
PIECE:  EQU  R1-R0

; A motor's steps and direction into its piece at IX, and IX to the next.
; HL: the count; carry: it is below 0.

SIZE:   LD   A,1
        JR   NC,SZUP
        XOR  A
        SUB  L
        LD   L,A
        SBC  A,A
        SUB  H
        LD   H,A
        LD   A,255
SZUP:   LD   (IX+WAY),A
        LD   (IX+STEPS),L
        LD   (IX+STEPS+1),H
        LD   DE,(MOST)
        OR   A
        SBC  HL,DE
        JR   C,SZLESS
        ADD  HL,DE
        LD   (MOST),HL
SZLESS: LD   DE,PIECE
        ADD  IX,DE
        RET


; ---- The hand closes until it grips ------------------------------------
;
; In:   DE      D, 0 to 32767
; Out:  carry   BREAK ended it

CLOSE:  LD   HL,TCLOS
        CALL PACE
        LD   HL,WAYS
        LD   B,5
CLREST: LD   (HL),0
        INC  HL
        DJNZ CLREST
        LD   (HL),255           ; J6 down
        CALL LOOK
CLTICK: LD   A,(ROW6)
        AND  4
        SCF
        RET  NZ                 ; BREAK
        LD   HL,(GRIP)          ; and SHUT
        LD   A,(SWITCH)
        XOR  H
        AND  L
        RET  Z                  ; closed
        CALL PULSE
        CALL LOOK
        CALL WAIT
        JP   CLTICK

LOOK:   LD   A,(BASE)
        LD   C,A
        IN   A,(C)
        LD   (SWITCH),A
        RET


; ---- Manual mode (Figure 11) -------------------------------------------
;
; In:   DE      D, 0 to 32767
; Out:  carry   BREAK ended it, and not the key 0
;
;       J1 J2 J3 J4 J5 J6
;  up   1  2  3  4  5  6
; down  Q  W  E  R  T  Y
;
; The keys are read in every tick, and all act at once. A 0 that is down
; at the beginning must be let go first. All ways through a tick take the
; same time.

JOINT:  MACRO                   ; where a joint is to go: the next figure
        RR   E                  ; against a letter, given by row and mask
        SBC  A,A
        LD   C,A                ; -1 if the figure is down
        LD   A,\0
        AND  \1
        ADD  A,255
        SBC  A,A                ; -1 if the letter is down
        SUB  C
        LD   (WAYS+\2),A
        ENDM

MANUAL: LD   HL,TSETT
        CALL PACE
        XOR  A
        LD   (LETGO),A
        LD   (TURN),A
MNTICK: LD   A,(ROW6)
        AND  4
        JP   NZ,MNBREA
        LD   HL,LETGO
        LD   A,(ROW4)
        LD   E,A
        CPL
        OR   (HL)
        LD   (HL),A
        AND  E
        RRA                     ; carry: 0 is down, and has been up
        CCF
        RET  NC
        LD   A,(ROW2)
        LD   D,A
        RR   E                  ; not the 0
        JOINT D,2,0             ; Q
        JOINT D,128,1           ; W
        JOINT (ROW0),32,2       ; E
        JOINT D,4,3             ; R
        JOINT D,16,4            ; T
        JOINT (ROW3),2,5        ; Y
        LD   HL,WAYS+2
        SUB  (HL)               ; the hand with the elbow, -2 to 2
        AND  7
        ADD  A,HANDS\256
        LD   E,A
        LD   D,HANDS>>8
        LD   A,(DE)
        LD   (WAYS+5),A
        LD   A,E
        ADD  A,8
        LD   E,A
        LD   A,(DE)
        LD   E,A
        LD   A,(TURN)
        CPL
        LD   (TURN),A
        OR   E
        AND  (HL)
        LD   (HL),A
        CALL PULSE
        CALL WAIT
        JP   MNTICK
MNBREA: SCF
        RET


; ---- The position registers --------------------------------------------
;
; READ: J1 to J6 go to the six words at HL. They are the half steps made
; since OFF; those of the hand that went against the elbow do not count.

UREAD:  CALL CINT
READ:   LD   IX,COUNTS
        LD   B,6
RGNEXT: LD   A,(IX+0)
        SUB  (IX+12)
        LD   (HL),A
        INC  HL
        INC  IX
        LD   A,(IX+0)
        SBC  A,(IX+12)
        LD   (HL),A
        INC  HL
        INC  IX
        DJNZ RGNEXT
        PUSH HL
        POP  IX
        LD   A,(IX-2)           ; J6 and J3
        ADD  A,(IX-8)
        LD   (IX-2),A
        LD   A,(IX-1)
        ADC  A,(IX-7)
        LD   (IX-1),A
        RET

; OFF: registers to zero, no current in the six motors.

OFF:    LD   HL,COUNTS
        LD   DE,ZEROS
        LD   BC,12
        LDIR
        LD   A,(BASE)
        LD   C,A
        LD   B,6
        XOR  A
OFNEXT: OUT  (C),A
        INC  C
        DJNZ OFNEXT
        RET


; ---- How long a tick is ------------------------------------------------
;
; In:   DE      D, 0 to 32767
;       HL      T-states that the caller's own loop takes in a tick,
;               besides PULSE and WAIT and the two CALLs of them
;
; A tick is 1.2 + 0.03 D milliseconds, which at 1.77408 MHz are 2128.896
; + 53.2224 D T-states. WAIT waits for what PULSE, WAIT and the loop
; leave of that, to the T-state; it lets 65536ths of one add up. So a
; long motion takes as long as it should. A tick cannot be shorter than
; these three, though.

PACE:   LD   BC,TPULSE+TWAIT
        ADD  HL,BC
        PUSH HL
        RES  7,D
        PUSH DE
        POP  IX
        LD   HL,0               ; C, DE, HL: 53.2224 times 65536 times D
        LD   D,H
        LD   E,H
        LD   C,H
        LD   B,16
PCBIT:  ADD  HL,HL
        RL   E
        RL   D
        RL   C
        ADD  IX,IX
        JR   NC,PCZERO
        LD   A,L
        ADD  A,EACHD\256
        LD   L,A
        LD   A,H
        ADC  A,EACHD\65536>>8
        LD   H,A
        LD   A,E
        ADC  A,EACHD>>16
        LD   E,A
        JR   NC,PCZERO
        INC  D
        JR   NZ,PCZERO
        INC  C
PCZERO: DJNZ PCBIT
        LD   A,C
        LD   BC,FIRST0\65536    ; 2128.896
        ADD  HL,BC
        LD   (FRAC),HL
        LD   HL,FIRST0>>16
        ADC  HL,DE
        ADC  A,0
        POP  DE
        OR   A
        SBC  HL,DE
        SBC  A,0                ; A, HL: T-states to wait
        JR   C,PCNOTI
        LD   B,A
        OR   H
        LD   A,L
        JR   NZ,PCTIME
        CP   32
        JR   NC,PCTIME
PCNOTI: LD  HL,32
        LD   (FRAC),HL          ; as good as none
        LD   B,H
        LD   A,L
PCTIME: AND  31
        LD   (ODD),A
        LD   A,B                ; divided by 32: times 8, without the
        ADD  HL,HL              ; last byte
        RLA
        ADD  HL,HL
        RLA
        ADD  HL,HL
        RLA
        LD   L,H
        LD   H,A
        LD   (LONG),HL
        LD   HL,0
        LD   (PART),HL
        RET

EACHD:  EQU  3487983            ; 53.2224 in 65536ths
FIRST0: EQU  139519328          ; 2128.896

TPULSE: EQU  1143               ; T-states of CALL PULSE by its entry,
TWAIT:  EQU  247                ; of CALL WAIT but for what it is to wait,
TTICK:  EQU  720-20             ; and of the loops: of a move,
TCLOS:  EQU  150-20             ; of CLOSE
TSETT:  EQU  611-20             ; and of manual mode, which CALL without
                                ; the entries' JPs


; ---- The rest of a tick ------------------------------------------------
;
; A bit of ODD that is set takes so many T-states more than one that is
; not, and so does a whole T-state that has come together.

WAIT:   LD   HL,(PART)
        LD   DE,(FRAC)
        ADD  HL,DE
        LD   (PART),HL
        JR   C,WTFRAC           ; 12 T-states, or 7
        NOP                     ; and 4
WTFRAC: LD   A,(ODD)
        LD   C,A
        RR   C
        JR   C,WTONE            ; 12, or 7
        NOP                     ; and 4
WTONE:  RR   C
        JR   NC,WTTWO           ; 12, or 7
        LD   A,0                ; and 7
WTTWO:  RR   C
        JR   NC,WTFOUR          ; 12, or 7
        LD   A,R                ; and 9
WTFOUR: RR   C
        JR   NC,WTEIGH          ; 12, or 7
        LD   A,(ODD)            ; and 13
WTEIGH: RR   C
        JR   NC,WTSIXT          ; 12, or 7
        PUSH HL                 ; and 11
        POP  HL                 ; and 10
WTSIXT: LD   DE,(LONG)
WTLOOP: DEC  DE                 ; 32 T-states each time
        LD   A,D
        OR   E
        NOP
        NOP
        JP   NZ,WTLOOP
        RET


; ---- A half step -------------------------------------------------------
;
; Every motor whose byte in WAYS is 1 or 255 makes a half step that way.
; The patterns of all six are made ready first; then the latches get
; them, from J1 to J6, each 15 T-states after the other.
;
; A motor that rests is not written: the OUT (n),A of its port is made an
; IN A,(n), which takes as long and changes nothing there. Every PULSE
; takes the same time.

PULSE:
M:      EQU  FOR 6              ; for the six motors; listed once
        LD   A,(WAYS+M)
        LD   E,A
        RLA
        SBC  A,A
        LD   D,A                ; the way in 16 bits
        LD   HL,(COUNTS+2*M)
        ADD  HL,DE
        LD   (COUNTS+2*M),HL
        LD   A,L
        AND  7
        OR   RING\256
        LD   L,A
        LD   H,RING>>8
        LD   A,(HL)
        LD   (COILS+M),A
        LD   A,E
        RRA                     ; carry: it moves
        SBC  A,A
        AND  8
        XOR  0xDB               ; 0xDB is IN A,(n), 0xD3 is OUT (n),A
        LD   (SLOT{M}+1),A
        NEXT M
        LD   BC,(COILS)
        LD   DE,(COILS+2)
        LD   HL,(COILS+4)
SLOT0:  LD   A,C
        OUT  (0x98),A
SLOT1:  LD   A,B
        OUT  (0x99),A
SLOT2:  LD   A,E
        OUT  (0x9A),A
SLOT3:  LD   A,D
        OUT  (0x9B),A
SLOT4:  LD   A,L
        OUT  (0x9C),A
SLOT5:  LD   A,H
        OUT  (0x9D),A
        RET
