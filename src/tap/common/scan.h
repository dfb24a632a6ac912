/* SPDX-License-Identifier: MIT
 *
 * The scanner that PostScript and CairoScript share: bytes to tokens (PostScript Language Reference, 3rd
 * edition, section 3.2). CairoScript adds `//NAME` constants and `<| … ~>` and `<~ … ~>` encoded strings.
 */
#ifndef PLB_TAP_COMMON_SCAN_H
#define PLB_TAP_COMMON_SCAN_H

#include "base/array.h"
#include "base/error.h"

#include <stddef.h>

typedef enum {
    TOKEN_END,          /* end of input */
    TOKEN_NUMBER,       /* `number`; `integer` tells how it was written */
    TOKEN_NAME,         /* executable name in text[0..length) */
    TOKEN_LITERAL,      /* /name */
    TOKEN_IMMEDIATE,    /* //name */
    TOKEN_STRING,       /* (…) or <hex> or <~…~>, decoded, in text[0..length) */
    TOKEN_DATA,         /* <|…~>: CairoScript's deflated data; skipped, not decoded */
    TOKEN_ARRAY_OPEN,   /* [ */
    TOKEN_ARRAY_CLOSE,  /* ] */
    TOKEN_PROC_OPEN,    /* { */
    TOKEN_PROC_CLOSE,   /* } */
    TOKEN_DICT_OPEN,    /* << */
    TOKEN_DICT_CLOSE    /* >> */
} token_kind;

typedef struct {
    token_kind kind;
    double number;
    bool integer;
    const char *text; /* valid until the next token is read; not NUL-terminated */
    size_t length;
} token;

typedef struct {
    const char *at, *end;   /* bytes not yet scanned */
    /* The scanner calls this at the end of the bytes: gives more (and true), or false at the end of the input. May be NULL. */
    bool (*refill)(void *closure, const char **data, size_t *size);
    void *closure;
    int line;               /* of the token last read (its first byte), from 1 */
    int next_line;          /* of the byte at `at` */
    ARRAY(char) buffer;     /* text of tokens that need unescaping or cross a refill */
} scanner;

/* Names and strings have at most so many bytes; longer ones are an error. */
#define SCAN_MAX_TOKEN ((size_t)16 << 20)

void plb_scan_init(scanner *s, const char *data, size_t size);
void plb_scan_free(scanner *s);
/* Reads the next token, comments skipped. False and `err` (without file name) on malformed input. */
bool plb_scan_next(scanner *s, token *t, error *err);

#endif
