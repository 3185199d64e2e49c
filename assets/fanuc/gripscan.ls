/PROG  GRIPSCAN
/ATTR
OWNER		= MNEDITOR;
COMMENT		= "gripscan turn J6";
PROG_SIZE	= 0;
FILE_NAME	= ;
VERSION		= 0;
LINE_COUNT	= 31;
MEMORY_SIZE	= 0;
PROTECT		= READ_WRITE;
TCD:  STACK_SIZE	= 0,
      TASK_PRIORITY	= 50,
      TIME_SLICE	= 0,
      BUSY_LAMP_OFF	= 0,
      ABORT_REQUEST	= 0,
      PAUSE_REQUEST	= 0;
DEFAULT_GROUP	= 1,*,*,*,*;
CONTROL_CODE	= 00000000 00000000;
/MN
   1:  !gripscan: turns joint 6 to PR[81] ;
   2:  !when gs_motion asks for it. ;
   3:  !Not a safety function. ;
   4:  UFRAME_NUM=0 ;
   5:  UTOOL_NUM=1 ;
   6:  F[82:GS go]=(OFF) ;
   7:  R[82:GS stop]=0    ;
   8:  R[83:GS result]=1    ;
   9:  RUN GS_MONITOR ;
  10:  RUN GS_MOTION ;
  11:   ;
  12:  LBL[10] ;
  13:  !ready for a target ;
  14:  F[81:GS ready]=(ON) ;
  15:  WAIT (F[82:GS go])    ;
  16:  F[81:GS ready]=(OFF) ;
  17:  F[82:GS go]=(OFF) ;
  18:   ;
  19:  !R[82] = 1 stops the motion ;
  20:  SKIP CONDITION R[82:GS stop]=1    ;
  21:J PR[81:GS target] R[81:GS speed]% FINE Skip,LBL[20]    ;
  22:   ;
  23:  !skipped: told to stop ;
  24:  R[83:GS result]=2    ;
  25:  JMP LBL[10] ;
  26:   ;
  27:  !arrived ;
  28:  LBL[20] ;
  29:  R[83:GS result]=1    ;
  30:  JMP LBL[10] ;
  31:   ;
/POS
/END
