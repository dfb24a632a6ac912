/* SPDX-License-Identifier: MIT
 *
 * A profile says what a pencil is: the statistics of the pencil's line, measured once from scans (001 section 3.2, thesis section 4.1).
 * A profile is immutable once made; one may serve many threads. The file format is in pencil(5). (plb_profile_load and
 * its like are the public interface's names for what is here.)
 */
#ifndef PLB_PROFILE_PROFILE_H
#define PLB_PROFILE_PROFILE_H

#include "base/error.h"

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#define PROFILE_GREYS 256
#define PROFILE_NAME_SIZE 32 /* bytes of a name with its final zero */
/* Bins of the cross-section: the middle of bin k is (k + 0.5) * PROFILE_SECTION_STEP pixels from the centreline; a
 * pixel counts in the two bins nearest to it, in proportion. */
#define PROFILE_SECTION_BINS 64
#define PROFILE_SECTION_STEP 0.25

/* ---- the grain: what the graphite model needs beyond the papers' statistics; plumbago(7) tells the model ---- */

#define GRAIN_SECTION 36      /* mean section: bins of PROFILE_SECTION_STEP px of the reference width */
#define GRAIN_MODES 6         /* ways in which the section changes slowly along the line … */
#define GRAIN_MODE_PLACES 65  /* … at -8 to 8 px by steps of 0.25 px */
#define GRAIN_LEVELS 25       /* expected darkness, see plb_grain_levels … */
#define GRAIN_SCORES 33       /* … by normal scores -3 to 3 */
#define GRAIN_PLACES 17       /* distances from the centreline by 0.5 px */
#define GRAIN_CLASSES 8       /* of correlation across: 0, .1 … .7 */
#define GRAIN_TAPS 5          /* the filter's side, px */
#define GRAIN_LINE 11         /* log depth, log width, log roughness, correlation along, across, six modes */

/* Darkness is 255 - grey; "relative" means divided by the line's depth D; places are px at 300 dpi scaled so that the line
 * has the reference width. */
typedef struct {
    bool present;                                  /* false: the profile was made without it */
    float reference_width;                         /* px, width at half depth that the places below refer to */
    float section[GRAIN_SECTION];                  /* mean relative darkness, bin k at (k + 1/2) / 4 px from the centreline */
    float mode[GRAIN_MODES][GRAIN_MODE_PLACES];    /* unit vectors, each even or odd */
    bool mode_is_odd[GRAIN_MODES];
    float mode_between[GRAIN_MODES];               /* variance of its coefficient between lines (odd ones) */
    float mode_within[GRAIN_MODES];                /* … and within a line */
    float mode_length[GRAIN_MODES];                /* correlation length along the line, px, before smoothing by 8 px */
    float darkness[GRAIN_LEVELS][GRAIN_SCORES];    /* relative darkness of a pixel by its expected level and normal score */
    float place_scale[GRAIN_PLACES];               /* spread of the scores by distance */
    float place_along[GRAIN_PLACES];               /* correlation of the scores along there, less that of the core */
    float place_across[GRAIN_PLACES];              /* the same across, of the pixels half a pixel to either side */
    float chain_high, chain_low, chain_share, chain_correlation; /* two-state chain of the columns' coefficient */
    float filter[GRAIN_CLASSES][GRAIN_TAPS][GRAIN_TAPS]; /* of the innovations, [class][along][across], unit energy */
    float volatility, volatility_across;           /* sd of the log amplitude; its correlation with the next row */
    float line_mean[GRAIN_LINE];                   /* joint normal distribution of a line's own figures … */
    float line_factor[GRAIN_LINE][GRAIN_LINE];     /* … mean + factor × standard normals, lower triangle */
} grain_model;

/* The levels of the rows of grain_model.darkness: 0 .005 .01 .02 .03 .045 .06 .08 .1 .13 .16 .2 .25 .3 .4 (by .1) 1.4. */
extern const float plb_grain_levels[GRAIN_LEVELS];
/* Sigma of the Gaussian along the line that separates slow from fast, px. */
#define GRAIN_SMOOTH 8.0

typedef struct {
    char name[PROFILE_NAME_SIZE]; /* the grade, "HB", or what the user called it */
    /* Lengths are multiples of 1/1000 px, greys of the section of 1/256: a profile and its file hold the same numbers. */
    double dpi;              /* of the scans and of all pixel figures below */
    double width_half;       /* width at half depth, px */
    double width_tenth;      /* width at a tenth of depth, px: the line's full width */
    int paper;               /* grey of the bare paper in the scans before it was mapped to 255 */
    int lines;               /* how many scanned lines were pooled */
    uint64_t pixels;         /* how many columns of line */

    /* Greys are scaled so that bare paper is 255. The counts of each histogram and of `ccm` sum to less than 2^31. */
    uint32_t mid[PROFILE_GREYS];   /* histogram along the centre; 255: bare paper showing through there */
    uint32_t range[PROFILE_GREYS]; /* histogram of the whole line, white (255) left out as the papers do */
    /* The papers' bounds: 1st and 99th percentile of `mid` and of `range`, white left out (percentiles: a single pixel
     * of dust must not set a bound). min_mid <= max_mid <= max_range < 255, min_range <= max_mid. */
    int min_mid, max_mid;
    int min_range, max_range;

    double section_mean[PROFILE_SECTION_BINS]; /* grey against distance from the centreline */
    double section_sd[PROFILE_SECTION_BINS];

    grain_model grain;
    double hand; /* how far the lines stray, times a free hand (hand.h), a multiple of 1/1000; 0: not measured, as a free one */

    uint32_t *ccm;           /* 256 × 256, ccm[i * 256 + j]: pixels of grey i whose neighbour along the line has j */
    int grade;               /* of the built-in ones: its index, see plb_profile_grade, plus 1; 0: another */
    char *provenance;        /* free text, UTF-8: scans, hand, licence, how the grade was assigned */
} profile;

/* ---- files (profile_read.c, profile_write.c) ---- */

/* Reads a profile from bytes in memory; `name` is for messages. NULL and `err` when malformed. The caller frees. */
profile *plb_profile_parse(const char *name, const unsigned char *data, size_t size, error *err);
/* Loads a grade ("HB": one of the eight built in, any case) or else a file. The caller frees. */
profile *plb_profile_read(const char *grade_or_file, error *err);
/* Gives the bytes of the file form, owned by the caller (plb_free). */
unsigned char *plb_profile_serialise(const profile *p, size_t *size, error *err);
/* Writes beside `file` and renames onto it when complete: a failure leaves nothing behind. */
bool plb_profile_write(const profile *p, const char *file, error *err);
void plb_profile_release(profile *p);
/* Gives the eight grades from hard to soft: "2H" "H" "F" "HB" "B" "3B" "6B" "8B"; NULL past the end. */
const char *plb_profile_grade(size_t index);

/* Gives the median grey along the centre of the line, bare paper included. */
int plb_profile_centre(const profile *p);

/* ---- capture from scans (profile_capture.c and its steps) ---- */

/* Draws `lines` lines with a pencil as it would be, each onto paper of its own, along x: `width` x `height` greys of 300 dpi, one
 * picture after the other in `grey`, which is white. */
typedef bool line_sampler(void *closure, const profile *p, int lines, int width, int height, uint8_t *grey, error *err);

typedef struct {
    const char *name;        /* of the profile */
    const char *provenance;  /* text to store */
    double dpi;              /* of the scans; 0: from the PNG's pHYs, else 300 */
    int centre_min, centre_max; /* only lines whose median grey at the centre lies within; 0, 255: all */
    double width;            /* mm: stretch the section so that its width at half depth is this; 0: as measured */
    const grain_model *grain; /* borrow from this one: the tooth that lines pressed hard do not show; NULL: as measured */
    bool free_hand;          /* the hand is not measured */
    line_sampler *sample;    /* to correct the grain by what it draws; NULL: it stays as measured */
    void *closure;           /* of `sample` */
    log_sink say;           /* one detail line per scan: what was found, or why it was left out */
} capture_options;
capture_options plb_capture_defaults(void);
/* Finds the one pencil line in each 8-bit grey or RGB PNG scan, straightens it, pools the statistics. */
profile *plb_capture(const char *const files[], size_t n, const capture_options *options, error *err);

/* ---- reports (profile_report.c; the picture is in surface/plot/profile_plot.h) ---- */

bool plb_profile_print(const profile *p, FILE *to);
bool plb_profile_print_difference(const profile *a, const profile *b, FILE *to);

#endif
