# Plumbago: one Makefile for everything. `make help` lists the targets.
# SPDX-License-Identifier: MIT

VERSION = 0.1.0

# ---- settings ---------------------------------------------------------------------------------------------
PREFIX  = /usr/local
DESTDIR =
CC      = gcc
AR      = ar
BUILD   = release
V       = 0

flags_release = -O2 -DNDEBUG
flags_debug   = -O0 -g3
flags_asan    = -O1 -g -fsanitize=address -fno-omit-frame-pointer
flags_ubsan   = -O1 -g -fsanitize=undefined -fno-sanitize-recover=all
flags_tsan    = -O1 -g -fsanitize=thread
flags_cover   = -O0 -g --coverage
ifeq ($(origin flags_$(BUILD)),undefined)
$(error BUILD=$(BUILD) is not one of release debug asan ubsan tsan cover)
endif

# ---- nothing to change below ------------------------------------------------------------------------------
O = build/$(BUILD)$(SUFFIX)
Q = $(if $(filter 1,$(V)),,@)
say = @$(if $(filter 1,$(V)),:,printf '  %-7s %s\n')

packages_lib = cairo libpng
packages_tap = librsvg-2.0 cairo cairo-script libxml-2.0

WARN   = -Wall -Wextra -Wpedantic -Wshadow -Wconversion
# -ffp-contract=off: the same drawing from every compiler and level (no fused multiply-add)
CFLAGS_ALL = -std=c17 $(WARN) -fPIC -ffp-contract=off -fvisibility=hidden -MMD -MP $(flags_$(BUILD)) \
             -D_POSIX_C_SOURCE=200809L -DPLB_VERSION='"$(VERSION)"' -DPLB_LIBEXECDIR='"$(PREFIX)/libexec/plumbago"' \
             -Isrc $(CFLAGS)
LDFLAGS_ALL = $(filter -fsanitize=% --coverage,$(flags_$(BUILD))) $(LDFLAGS)

layers   = base list profile input plan stroke surface api
lib_src  = $(foreach d,$(layers),$(wildcard src/$(d)/*.c))
lib_obj  = $(lib_src:src/%.c=$(O)/%.o)
pencils  = $(wildcard profiles/*.pencil)
c_tests  = $(wildcard tests/unit/*.c tests/stat/*.c tests/stage/*.c)
c_tools  = $(wildcard tests/tools/*.c)
examples_c = $(wildcard examples/*.c)

programs = $(O)/plumbago $(O)/plumbago-profile $(O)/tap-svg
tests_bin = $(c_tests:tests/%.c=$(O)/tests/%) $(c_tools:tests/%.c=$(O)/tests/%)

.PHONY: all
all: $(programs) $(O)/libplumbago.a

$(O)/%.o: src/%.c
	$(say) CC $<
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS_ALL) $(CFLAGS_$(word 2,$(subst /, ,$<))) $(shell pkg-config --cflags $(packages_lib)) -c $< -o $@

# The eight pencils are part of the library: their files as one object, no code in between.
$(O)/pencils.o: $(pencils)
	$(say) LD $@
	@mkdir -p $(@D)
	$(Q)cd profiles && ld -r -b binary -z noexecstack -o $(CURDIR)/$@ $(sort $(notdir $(pencils)))

$(O)/libplumbago.a: $(lib_obj) $(O)/pencils.o
	$(say) AR $@
	$(Q)rm -f $@ && $(AR) rcs $@ $^

$(O)/plumbago: $(O)/tool/plumbago.o $(O)/tool/options.o $(O)/libplumbago.a
$(O)/plumbago-profile: $(O)/tool/plumbago_profile.o $(O)/tool/options.o $(O)/libplumbago.a
$(O)/plumbago $(O)/plumbago-profile:
	$(say) LINK $@
	$(Q)$(CC) $(LDFLAGS_ALL) $^ $(shell pkg-config --libs $(packages_lib)) -lm -o $@

# The tap includes nothing of ours and links librsvg; the library does not.
$(O)/tap-svg: src/tap/tap_svg.c
	$(say) LINK $@
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS_ALL) $(shell pkg-config --cflags $(packages_tap)) $< $(LDFLAGS_ALL) $(shell pkg-config --libs $(packages_tap)) -lm -o $@

$(O)/tests/%: tests/%.c $(O)/libplumbago.a
	$(say) LINK $@
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS_ALL) -UNDEBUG -Itests $(shell pkg-config --cflags $(packages_lib)) $< $(O)/libplumbago.a $(LDFLAGS_ALL) $(shell pkg-config --libs $(packages_lib)) $(LIBS_$(notdir $@)) -lm -o $@

-include $(lib_obj:.o=.d) $(wildcard $(O)/tool/*.d $(O)/*.d $(O)/tests/*/*.d)
