/* SPDX-License-Identifier: MIT
 *
 * How a tap ends: its exit status, plumbago-list(5). Its standard error then says why in a line, "LINE: why" where a line of
 * the drawing is to blame.
 */
#ifndef PLB_LIST_TEXT_TAP_STATUS_H
#define PLB_LIST_TEXT_TAP_STATUS_H

typedef enum {
    TAP_DONE,       /* the list is written to its end */
    TAP_USAGE,      /* its command line is wrong */
    TAP_MALFORMED,  /* the drawing is not what its format says */
    TAP_REFUSED,    /* the drawing needs what the tap does not do */
    TAP_WRITE,      /* its output cannot be written */
    TAP_LIMIT,      /* a bound on time, memory, size or depth is reached */
    TAP_MISSING,    /* a program or library that it needs is not installed */
    TAP_HANDED_OVER /* another program is to draw it: what the line says is between the tap and its reader */
} tap_status;

#endif
