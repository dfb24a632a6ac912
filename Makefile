# Plumbago: one Makefile for everything. `make help` lists the targets.
# SPDX-License-Identifier: MIT

VERSION := $(shell awk '/define PLB_VERSION_(MAJOR|MINOR|PATCH) / { v = v dot $$3; dot = "." } END { print v }' src/api/plumbago.h)

# ---- settings ---------------------------------------------------------------------------------------------
PREFIX  = /usr/local
LIBDIR  = $(PREFIX)/lib
DESTDIR =
CC      = gcc
AR      = ar
BUILD   = release
V       = 0

flags_release = -O2 -DNDEBUG -fstack-protector-strong -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2
flags_debug   = -O0 -g3
flags_asan    = -O1 -g -fsanitize=address -fno-omit-frame-pointer
flags_ubsan   = -O1 -g -fsanitize=undefined,float-cast-overflow -fno-sanitize-recover=all
flags_tsan    = -O1 -g -fsanitize=thread
flags_cover   = -O0 -g --coverage
flags_failing = -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all -DPLB_TEST_ALLOCATIONS
flags_fuzz    = -O1 -g -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all -include tests/fuzz/short_runs.h
ifeq ($(origin flags_$(BUILD)),undefined)
$(error BUILD=$(BUILD) is not one of release debug asan ubsan tsan cover failing fuzz)
endif

# ---- nothing to change below ------------------------------------------------------------------------------
O = build/$(BUILD)$(SUFFIX)
Q = $(if $(filter 1,$(V)),,@)
say = @$(if $(filter 1,$(V)),:,printf '  %-7s %s\n')

# Formats of pictures that a build writes where their libraries are at hand.
with_jpeg := $(shell pkg-config --exists libjpeg && echo libjpeg)
with_webp := $(shell pkg-config --exists libwebp libwebpmux && echo libwebp libwebpmux)
with_assimp := $(shell pkg-config --exists assimp && echo assimp)
with_tiff := $(shell pkg-config --exists 'libtiff-4 >= 4.5' && echo libtiff-4)
# libtiff is loaded when a TIFF is written, by the name under which programs that link it would find it.
tiff_library := $(and $(with_tiff),$(shell objdump -p "$$(pkg-config --variable=libdir libtiff-4)/libtiff.so" 2>/dev/null | awk '$$1 == "SONAME" { print $$2 }'))
packages_linked = cairo libpng zlib libseccomp $(with_jpeg) $(with_webp)
packages_lib = $(packages_linked) $(with_tiff)
packages_tap = librsvg-2.0 cairo freetype2 cairo-script libxml-2.0 fontconfig
packages_plain = libxml-2.0

WARN   = -Wall -Wextra -Wpedantic -Wshadow -Wconversion
# -ffp-contract=off: the same drawing from every compiler and level (no fused multiply-add). Nobody asks whether a root or a
# division went wrong: the others let them stand in loops.
CFLAGS_ALL = -std=c17 $(WARN) -fPIC -ffp-contract=off -fno-math-errno -fno-trapping-math -fvisibility=hidden -MMD -MP $(flags_$(BUILD)) \
             $(if $(with_jpeg),-DPLB_WITH_JPEG) $(if $(with_webp),-DPLB_WITH_WEBP) $(if $(tiff_library),-DPLB_TIFF_LIBRARY='"$(tiff_library)"') \
             -D_POSIX_C_SOURCE=200809L -Isrc $(CFLAGS)
# Position-independent programs whose tables of addresses are read-only before the first line runs, no code on the stack.
LDFLAGS_release = -pie -Wl,-z,relro,-z,now,-z,noexecstack
LDFLAGS_ALL = $(filter -fsanitize=% --coverage,$(flags_$(BUILD))) $(LDFLAGS_$(BUILD)) $(LDFLAGS)

# The thread sanitizer would judge the threads of librsvg's libraries, which it cannot see into: neither compiled nor linked
# with it. The taps have none of their own.
CFLAGS_tap  = $(if $(filter tsan,$(BUILD)),-fno-sanitize=thread)
LDFLAGS_tap = $(filter-out -fsanitize=thread,$(LDFLAGS_ALL))

# The inner loops of the texture and of the page are written for the compiler's vectors.
CFLAGS_stroke = $(if $(filter release,$(BUILD)),-O3)
CFLAGS_surface = $(CFLAGS_stroke)
CFLAGS_film = $(CFLAGS_stroke)

# Folders lie in folders: all of a layer, however deep.
below    = $(sort $(shell find $(1) -name '$(2)'))
layers   = base system list profile input plan stroke surface film api
lib_src  = $(foreach d,$(layers),$(call below,src/$(d),*.c))
lib_obj  = $(lib_src:src/%.c=$(O)/%.o)
pencils  = $(wildcard profiles/*.pencil)
c_tests  = $(wildcard tests/unit/*.c tests/stat/*.c tests/stage/*.c)
c_tools  = $(wildcard tests/tools/*.c)
examples_c = $(wildcard examples/*.c)
examples_cpp = $(wildcard examples/*.cpp)
CXX     = g++

# SOVERSION grows when programs must be compiled again. Sanitizers leave names to be found in the program.
SOVERSION = 0
shared = libplumbago.so.$(VERSION)
whole_release = -Wl,-z,defs
programs = $(O)/plumbago $(O)/plumbago-profile $(O)/tap-svg $(O)/tap-plain $(O)/tap-ps $(O)/tap-model $(if $(with_assimp),$(O)/tap-assimp) $(O)/tap-dxf
fuzzers  = $(patsubst tests/fuzz/fuzz_%.c,%,$(wildcard tests/fuzz/fuzz_*.c))
tests_bin = $(c_tests:tests/%.c=$(O)/tests/%) $(c_tools:tests/%.c=$(O)/tests/%) $(fuzzers:%=$(O)/tests/fuzz/fuzz_%)

.PHONY: all
all: $(programs) $(O)/libplumbago.a $(O)/$(shared)

# A file that holds a text: $(call changed,FILE,TEXT) makes its rule run when the text is another one than the file's, and
# $(call keep,TEXT) writes it. What depends on the file is then made again.
quote = '$(subst ','"'"',$(strip $(1)))'
changed = $(if $(subst <$(strip $(file <$(1)))>,,<$(strip $(2))>),FORCE)
keep = @mkdir -p $(@D) && printf '%s\n' $(call quote,$(1)) >$@
FORCE:

# Every object depends on the compiler, its version and the flags. Where a library is missing, this first rule says how to get it.
needed = $(packages_lib) $(packages_tap) $(packages_plain)
flags_now := $(CC) $(shell $(CC) -dumpfullversion -dumpversion 2>/dev/null) $(CFLAGS_ALL) $(CFLAGS_stroke) $(LDFLAGS_ALL)
$(O)/flags: $(call changed,$(O)/flags,$(flags_now))
	@$(CC) --version >/dev/null 2>&1 && pkg-config --exists $(needed) || { tests/packages --say $(packages_build); exit 1; }
	$(call keep,$(flags_now))
# The installed place of the taps is compiled into one object, which alone is made again when it changes.
$(O)/prefix: $(call changed,$(O)/prefix,$(PREFIX))
	$(call keep,$(PREFIX))
$(O)/system/process.o: $(O)/prefix
$(O)/system/process.o: DEFINES = -DPLB_LIBEXECDIR='"$(PREFIX)/libexec/plumbago"'

$(O)/%.o: src/%.c $(O)/flags
	$(say) CC $<
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS_ALL) $(CFLAGS_$(word 2,$(subst /, ,$<))) $(DEFINES) $(shell pkg-config --cflags $(packages_lib)) -c $< -o $@

# The eight pencils are part of the library: their files as one object, no code in between.
$(O)/pencils.o: $(pencils)
	$(say) LD $@
	@mkdir -p $(@D)
	$(Q)cd profiles && ld -r -b binary -z noexecstack -o "$(CURDIR)/$@" $(sort $(notdir $(pencils)))

# A source that is gone leaves the library, too.
$(O)/objects: $(call changed,$(O)/objects,$(lib_obj))
	$(call keep,$(lib_obj))
$(O)/libplumbago.a: $(lib_obj) $(O)/pencils.o $(O)/objects
	$(say) AR $@
	$(Q)rm -f $@ && $(AR) rcs $@ $(filter %.o,$^)

# The shared library gives away what plumbago.h declares and nothing else.
$(O)/exports.map: src/api/plumbago.h
	@mkdir -p $(@D)
	$(Q){ echo 'PLUMBAGO_$(SOVERSION) {'; echo 'global:'; sed -nE 's/^PLB_API .*[ *](plb_[a-z0-9_]+)\(.*/    \1;/p' $<; echo 'local: *;'; echo '};'; } > $@
$(O)/$(shared): $(lib_obj) $(O)/pencils.o $(O)/exports.map
	$(say) LINK $@
	$(Q)$(CC) -shared -Wl,-soname,libplumbago.so.$(SOVERSION) -Wl,--version-script=$(O)/exports.map $(whole_$(BUILD)) \
	    $(filter-out -pie,$(LDFLAGS_ALL)) $(filter %.o,$^) $(shell pkg-config --libs $(packages_linked)) -lm -pthread -o $@
	$(Q)ln -sf $(shared) $(O)/libplumbago.so.$(SOVERSION) && ln -sf libplumbago.so.$(SOVERSION) $(O)/libplumbago.so

# The programs share these files, in folders.
tool_parts = $(patsubst src/%.c,$(O)/%.o,$(call below,src/tool/options,*.c) $(call below,src/tool/command,*.c))
$(O)/plumbago: $(O)/tool/plumbago.o $(tool_parts) $(O)/libplumbago.a
$(O)/plumbago-profile: $(O)/tool/plumbago_profile.o $(tool_parts) $(O)/libplumbago.a
$(O)/plumbago $(O)/plumbago-profile:
	$(say) LINK $@
	$(Q)$(CC) $(LDFLAGS_ALL) $^ $(shell pkg-config --libs $(packages_linked)) -lm -pthread -o $@

# Taps are programs of their own, made of base, list, tap/common and their own folder; the one links librsvg, the other libxml2
# alone, which starts in a fifth of the time.
tap_twice = $(if $(filter tsan,$(BUILD)),again/)
tap_base  = $(patsubst src/%.c,$(O)/$(tap_twice)%.o,$(call below,src/base,*.c) $(call below,src/list,*.c) src/tap/common/scan.c)
tap_common = $(patsubst %,$(O)/tap/common/%.o,$(1))
script_obj = $(patsubst src/%.c,$(O)/%.o,$(wildcard src/tap/svg/cairoscript*.c)) $(call tap_common,tap_area)
rewrite_obj = $(patsubst src/%.c,$(O)/%.o,$(call below,src/tap/svg/rewrite,*.c)) $(call tap_common,tap_colour)
losses_obj = $(patsubst src/%.c,$(O)/%.o,$(wildcard src/tap/svg/losses/*.c))
svg_obj   = $(O)/tap/svg/tap_svg.o $(O)/tap/svg/typeset/typeset.o $(losses_obj) $(script_obj) $(rewrite_obj) $(call tap_common,tap_memory tap_page tap_stream) $(tap_base)
plain_obj = $(patsubst src/%.c,$(O)/%.o,$(wildcard src/tap/plain/plain_*.c)) $(call tap_common,tap_area tap_colour tap_page)
tap_obj   = $(patsubst src/%.c,$(O)/%.o,$(filter-out src/tap/ps/% src/tap/model/%,$(call below,src/tap,*.c)))
$(tap_obj): $(O)/tap/%.o: src/tap/%.c $(O)/flags
	$(say) CC $<
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS_ALL) $(CFLAGS_tap) $(shell pkg-config --cflags $(packages_tap)) -c $< -o $@
$(O)/again/%.o: src/%.c $(O)/flags
	$(say) CC $<
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS_ALL) $(CFLAGS_tap) -c $< -o $@
$(O)/tap-svg: $(svg_obj)
	$(say) LINK $@
	$(Q)$(CC) $(LDFLAGS_tap) $(filter %.o,$^) $(shell pkg-config --libs $(packages_tap)) -lm -pthread -o $@
$(O)/tap-plain: $(O)/tap/plain/tap_plain.o $(call tap_common,tap_stream) $(plain_obj) $(tap_base)
	$(say) LINK $@
	$(Q)$(CC) $(LDFLAGS_tap) $(filter %.o,$^) $(shell pkg-config --libs $(packages_plain)) -lm -o $@

# All of this one is ours, so it is built, also for the sanitizers, as the library is.
ps_obj = $(patsubst src/%.c,$(O)/%.o,$(filter-out %/tap_ps.c,$(call below,src/tap/ps,*.c)) src/tap/common/scan.c)
ps_base = $(patsubst src/%.c,$(O)/%.o,$(call below,src/base,*.c) $(call below,src/list,*.c))
$(O)/tap-ps: $(O)/tap/ps/tap_ps.o $(call tap_common,tap_stream) $(ps_obj) $(ps_base)
	$(say) LINK $@
	$(Q)$(CC) $(LDFLAGS_ALL) $(filter %.o,$^) -lm -o $@

# So is this one.
model_obj = $(patsubst src/%.c,$(O)/%.o,$(filter-out %/tap_model.c %/tap_assimp.c %/program.c,$(call below,src/tap/model,*.c)))
model_program = $(O)/tap/model/program.o $(call tap_common,tap_stream) $(model_obj) $(ps_base)
$(O)/tap-model: $(O)/tap/model/tap_model.o $(model_program)
	$(say) LINK $@
	$(Q)$(CC) $(LDFLAGS_ALL) $(filter %.o,$^) -lm -o $@
$(O)/tap/model/tap_assimp.o: src/tap/model/tap_assimp.c $(O)/flags
	$(say) CC $<
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS_ALL) $(CFLAGS_tap) $(shell pkg-config --cflags $(with_assimp)) -c $< -o $@
$(O)/tap-assimp: $(O)/tap/model/tap_assimp.o $(model_program)
	$(say) LINK $@
	$(Q)$(CC) $(LDFLAGS_ALL) $(filter %.o,$^) $(shell pkg-config --libs $(with_assimp)) -lm -o $@

# The other tap is a script around the library ezdxf.
$(O)/tap-dxf: src/tap/dxf/tap_dxf.py
	@mkdir -p $(@D)
	$(Q)install $< $@

$(O)/tests/%: tests/%.c $(O)/libplumbago.a
	$(say) LINK $@
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS_ALL) -UNDEBUG -Itests $(shell pkg-config --cflags $(packages_lib)) $(filter %.c %.o,$^) $(O)/libplumbago.a $(LDFLAGS_ALL) $(shell pkg-config --libs $(packages_lib)) $(LIBS_$(notdir $@)) -lm -pthread -o $@

# A harness and what calls it: once for each file that is kept, or libFuzzer.
link_harness = $(Q)mkdir -p $(@D) && $(CC) $(CFLAGS_ALL) -UNDEBUG -Itests/fuzz $(shell pkg-config --cflags $(packages_lib)) $(filter %.c %.o,$^) $(filter %.a,$^) $(LDFLAGS_ALL) $(shell pkg-config --libs $(packages_lib)) $(LIBS_$(notdir $@)) -lm -pthread -o $@
LIBS_fuzz_plain_svg = $(shell pkg-config --libs $(packages_plain))
$(O)/tests/fuzz/fuzz_plain_svg $(O)/fuzz_plain_svg: $(plain_obj)
$(O)/tests/fuzz/fuzz_cairoscript $(O)/fuzz_cairoscript $(O)/tests/unit/test_cairoscript: $(script_obj) $(call tap_common,scan)
$(O)/tests/fuzz/fuzz_postscript $(O)/fuzz_postscript $(O)/tests/unit/test_postscript $(O)/tests/stage/postscript $(O)/tests/failing/test_allocations: $(ps_obj)
$(O)/tests/fuzz/fuzz_model $(O)/fuzz_model $(O)/tests/unit/test_model: $(model_obj)
$(O)/tests/unit/test_scan: $(call tap_common,scan)
$(O)/tests/fuzz/fuzz_%: tests/fuzz/fuzz_%.c tests/fuzz/replay.c tests/fuzz/fuzz.h $(tool_parts) $(O)/libplumbago.a
	$(say) LINK $@
	$(link_harness)
$(O)/fuzz_%: tests/fuzz/fuzz_%.c tests/fuzz/fuzz.h $(tool_parts) $(O)/libplumbago.a
	$(say) LINK $@
	$(link_harness) -fsanitize=fuzzer

# ---- tests ------------------------------------------------------------------------------------------------
# `make check` runs what takes minutes; TESTS= picks some, JOBS= says how many run at a time.
JOBS = $(shell nproc 2>/dev/null || echo 1)
# The longest come first, so that none is left running alone.
TESTS = tests/hostile.sh $(filter-out tests/check.sh tests/hostile.sh,$(wildcard tests/*.sh)) $(c_tests:tests/%.c=$(O)/tests/%) \
        $(wildcard tests/cli/*.sh tests/rules/*.sh tests/image/*.sh tests/stage/*.sh) tests/fuzz/replay.sh

.PHONY: check check-only tests
check: packages-check
	+$(Q)$(MAKE) --no-print-directory check-only
tests: all $(tests_bin) examples
check-only: tests
	$(Q)tests/run -j $(JOBS) $(O) $(TESTS)

# These tests take longer than one likes to wait. LOAD=N: how many drawings are made while make is killed.
.PHONY: check-long check-sanitizers
check-long:
	+$(Q)$(MAKE) --no-print-directory check-only TESTS="$(wildcard tests/long/*.sh) tests/lint/run.sh"
	+$(Q)$(MAKE) --no-print-directory check-sanitizers

# All tests in builds with the sanitizers of addresses (and leaks), of undefined behaviour and of threads, by both compilers;
# those that cannot work there say so and are skipped.
check-sanitizers:
	+$(Q)export TEST_TIMEOUT=7200; failed=; for build in asan ubsan tsan; do for with in 'CC=gcc' 'CC=clang SUFFIX=-clang'; do \
	    echo "BUILD=$$build $$with" && $(MAKE) --no-print-directory BUILD=$$build $$with check-only || failed="$$failed $$build ($$with)"; \
	done; done; [ -z "$$failed" ] || { echo "failed:$$failed"; exit 1; }

# The table of src/api/pencil/tone_known.c, to be put there when techniques, pencils or the page's ink change.
.PHONY: tones
tones: $(O)/tests/tools/tone_scale
	$(Q)$<

# clang-tidy and cppcheck (Debian: clang-tidy cppcheck), as tests/lint says.
.PHONY: lint
lint: all
	$(Q)tests/run $(O) tests/lint/run.sh

# The build in which a test decides which allocations fail (tests/allocations.sh).
.PHONY: failing
failing: $(O)/tests/failing/test_allocations

# Fuzzers, to be run as long as one likes: build/fuzz/fuzz_NAME tests/fuzz/corpus-NAME
.PHONY: fuzz fuzz-programs
fuzz:
	+$(Q)$(MAKE) --no-print-directory BUILD=fuzz CC=clang fuzz-programs
fuzz-programs: $(fuzzers:%=$(O)/fuzz_%)

# Each of them in turn, MINUTES long, with the counts.
MINUTES = 1
.PHONY: fuzz-all
fuzz-all: fuzz
	+$(Q)$(MAKE) --no-print-directory BUILD=ubsan all
	$(Q)tests/fuzz/all.sh build/fuzz $(MINUTES)

.PHONY: asan ubsan tsan
asan ubsan tsan:
	+$(Q)$(MAKE) --no-print-directory BUILD=$@ all

# ---- what users run first -----------------------------------------------------------------------------------
demo_drawing = examples/plan.svg
grades = 2H H F HB B 3B 6B 8B

.PHONY: demo demo-pictures
demo: packages
	+$(Q)$(MAKE) --no-print-directory demo-pictures
demo-pictures: all
	@mkdir -p build/demo
	$(Q)for p in $(grades); do $(O)/plumbago -p $$p $(demo_drawing) -o build/demo/plan-$$p.png || exit 1; echo "  build/demo/plan-$$p.png"; done
	@echo "$(demo_drawing), drawn with eight pencils, lies in build/demo."

# ---- packages (Debian) ------------------------------------------------------------------------------------
packages_build = gcc make binutils pkg-config libc6-dev librsvg2-dev libcairo2-dev libpng-dev zlib1g-dev libjpeg62-turbo-dev libwebp-dev libtiff-dev libseccomp-dev libxml2-dev libfontconfig-dev fonts-dejavu-core poppler-utils ghostscript python3-ezdxf
packages_tests = librsvg2-bin clang g++ mandoc strace locales unzip
packages_tests += libclang-rt-14-dev util-linux # for the fuzzers, and for writes that fail

.PHONY: packages packages-check
packages:
	@tests/packages $(packages_build)
packages-check:
	@tests/packages $(packages_build) $(packages_tests)

# ---- pictures and figures -----------------------------------------------------------------------------------
.PHONY: figures gallery bench realism fidelity profiles
figures: all $(tests_bin)
	$(Q)tests/figures $(O)
gallery: all
	$(Q)examples/gallery/gallery.sh $(O)/plumbago examples/gallery
bench: all $(O)/tests/tools/measure $(O)/tests/tools/stage_speed $(O)/tests/tools/core_speed
	$(Q)tests/bench $(O)
fidelity: all $(tests_bin)
	$(Q)tests/run $(O) tests/fidelity.sh
	@echo "  $(O)/fidelity.tsv $(O)/fidelity/sheet-*.png"
realism: all
	$(Q)tests/realism $(O)
profiles: $(O)/plumbago-profile
	$(Q)profiles/capture.sh $(O)/plumbago-profile

# ---- examples -----------------------------------------------------------------------------------------------
.PHONY: examples
examples: $(examples_c:examples/%.c=$(O)/examples/%) $(if $(shell command -v $(CXX)),$(examples_cpp:examples/%.cpp=$(O)/examples/%))
$(O)/examples/%: examples/%.c $(O)/libplumbago.a
	$(say) LINK $@
	@mkdir -p $(@D)
	$(Q)$(CC) -std=c17 $(WARN) $(flags_$(BUILD)) -Isrc/api $(shell pkg-config --cflags cairo) $< $(O)/libplumbago.a $(LDFLAGS_ALL) $(shell pkg-config --libs $(packages_lib)) -lm -pthread -o $@

$(O)/examples/%: examples/%.cpp $(O)/libplumbago.a
	$(say) LINK $@
	@mkdir -p $(@D)
	$(Q)$(CXX) -std=c++17 -Wall -Wextra $(flags_$(BUILD)) -Isrc/api $(shell pkg-config --cflags cairo) $< $(O)/libplumbago.a $(LDFLAGS_ALL) $(shell pkg-config --libs $(packages_lib)) -lm -pthread -o $@

# ---- the core for browsers ----------------------------------------------------------------------------------
# WebAssembly by Debian's clang-14, lld-14, wasi-libc and libclang-rt-14-dev-wasm32: build/web has all that a page needs.
# The library without cairo, taps and files; src/web/stand_in has what a browser lacks. Vectors are 128 bits broad. Size counts
# where a page loads it, speed where strokes are drawn.
W = build/web
WASM_CC = clang-14 --target=wasm32-wasi
packages_web = clang-14 lld-14 wasi-libc libclang-rt-14-dev-wasm32 nodejs
web_src = $(foreach d,base list plan stroke profile api/settings api/drawing api/pencil api/render web,$(call below,src/$(d),*.c)) \
          $(addprefix src/,surface/page.c surface/page_row.c surface/ground.c input/list.c api/output/pixels.c api/api_internal.c api/pipeline.c)
web_obj = $(patsubst src/%.c,$(W)/obj/%.o,$(filter-out %/scan_png.c %/profile_builtin.c,$(web_src)))
CFLAGS_web = -std=c17 $(WARN) -Wno-missing-field-initializers -DNDEBUG -msimd128 -ffp-contract=off -fno-math-errno -fno-trapping-math -MMD -MP \
             -D_POSIX_C_SOURCE=200809L -Isrc/web/stand_in -Isrc
$(W)/obj/%.o: src/%.c $(W)/flags
	$(say) WASM $<
	@mkdir -p $(@D)
	$(Q)$(WASM_CC) $(CFLAGS_web) $(if $(filter stroke surface,$(word 1,$(subst /, ,$*))),-O2,-Oz) -c $< -o $@
$(W)/flags: $(call changed,$(W)/flags,$(WASM_CC) $(CFLAGS_web))
	$(call keep,$(WASM_CC) $(CFLAGS_web))
$(W)/plumbago.wasm: $(web_obj)
	$(say) LINK $@
	$(Q)$(WASM_CC) -mexec-model=reactor -Wl,--gc-sections -Wl,--strip-all -Wl,-z,stack-size=1048576 $^ -lm -o $@
$(W)/%: src/web/%
	$(Q)cp $< $@
$(W)/%.pencil: profiles/%.pencil
	$(Q)cp $< $@

.PHONY: web
web:
	@tests/packages $(packages_web)
	+$(Q)$(MAKE) --no-print-directory web-files
.PHONY: check-web
check-web: web
	+$(Q)$(MAKE) --no-print-directory check-only TESTS=tests/web.sh
.PHONY: web-files
web-files: $(W)/plumbago.wasm $(addprefix $(W)/,plumbago.js plumbago.d.ts package.json README.md) $(grades:%=$(W)/%.pencil)

# ---- install ------------------------------------------------------------------------------------------------
manuals = $(wildcard man/*.[1-9])

# Where Debian's shells look for completions; zsh looks elsewhere for those of packages.
completion_files = bash-completion/completions/plumbago zsh/$(if $(filter /usr,$(PREFIX)),vendor-completions,site-functions)/_plumbago fish/vendor_completions.d/plumbago.fish
completions = for f in $(completion_files); do install -d "$(dest)/share/$${f%/*}" && $(O)/plumbago --completions $${f%%[-/]*} > "$(dest)/share/$$f" || exit 1; done

.PHONY: install uninstall
dest = $(DESTDIR)$(PREFIX)
install: all
	install -d "$(dest)/bin" "$(dest)/libexec/plumbago" "$(dest)/include" "$(dest)/share/plumbago/profiles"
	install $(O)/plumbago $(O)/plumbago-profile "$(dest)/bin"
	install $(O)/tap-svg $(O)/tap-plain $(O)/tap-ps $(O)/tap-model $(if $(with_assimp),$(O)/tap-assimp) $(O)/tap-dxf "$(dest)/libexec/plumbago"
	install -m 644 src/api/plumbago.h "$(dest)/include"
	install -d "$(DESTDIR)$(LIBDIR)/pkgconfig"
	install -m 644 $(O)/libplumbago.a $(O)/$(shared) "$(DESTDIR)$(LIBDIR)"
	ln -sf $(shared) "$(DESTDIR)$(LIBDIR)/libplumbago.so.$(SOVERSION)"
	ln -sf libplumbago.so.$(SOVERSION) "$(DESTDIR)$(LIBDIR)/libplumbago.so"
	install -m 644 $(pencils) "$(dest)/share/plumbago/profiles"
	printf '%s\n' 'prefix=$(PREFIX)' 'libdir=$(LIBDIR)' 'Name: plumbago' 'Description: vector drawings drawn with a pencil' 'Version: $(VERSION)' \
	    'Requires: cairo' 'Requires.private: $(filter-out cairo,$(packages_linked))' 'Libs: -L$${libdir} -lplumbago' 'Libs.private: -lm -pthread' \
	    'Cflags: -I$${prefix}/include' > "$(DESTDIR)$(LIBDIR)/pkgconfig/plumbago.pc"
	if [ -z "$(DESTDIR)" ] && [ "$$(id -u)" = 0 ]; then ldconfig "$(LIBDIR)"; fi
	$(completions)
	for m in $(notdir $(manuals)); do d="$(dest)/share/man/man$${m##*.}"; install -d "$$d" && \
	    sed 's#/usr/local#$(PREFIX)#g' man/$$m > "$$d/$$m" && chmod 644 "$$d/$$m" || exit 1; done
uninstall:
	rm -f "$(dest)/bin/plumbago" "$(dest)/bin/plumbago-profile" "$(dest)/include/plumbago.h"
	rm -f "$(DESTDIR)$(LIBDIR)"/libplumbago.a "$(DESTDIR)$(LIBDIR)"/libplumbago.so* "$(DESTDIR)$(LIBDIR)/pkgconfig/plumbago.pc"
	rm -rf "$(dest)/libexec/plumbago" "$(dest)/share/plumbago"
	for f in $(completion_files); do rm -f "$(dest)/share/$$f"; done
	for m in $(notdir $(manuals)); do rm -f "$(dest)/share/man/man$${m##*.}/$$m"; done

# Debian packages: the sources and examples/packaging/debian, in a folder of their own.
.PHONY: package
package:
	@tests/packages $(packages_build) debhelper dpkg-dev
	$(Q)rm -rf build/package && mkdir -p build/package/source
	$(Q)tar --exclude=./build --exclude=./.git -cf - . | tar -xf - -C build/package/source
	$(Q)cp -r examples/packaging/debian build/package/source/
	$(Q)cd build/package/source && env -u MAKEFLAGS -u MAKELEVEL -u MFLAGS dpkg-buildpackage -us -uc -b -j$(JOBS) >../log 2>&1 || \
	    { tail -n 20 ../log; exit 1; }
	@for p in build/package/*.deb; do echo "  $$p"; done

# The one number of this version, for those who ask.
.PHONY: version
version:
	@echo $(VERSION)

.PHONY: clean help
clean:
	rm -rf build
help:
	@echo 'make            programs and library, in build/release'
	@echo 'make demo       installs the packages that are missing, builds, draws a drawing with eight pencils'
	@echo 'make check      installs the packages that are missing, builds, runs all tests'
	@echo 'make check-long what takes an hour: sanitizers, valgrind, failing writes and allocations (Debian: valgrind)'
	@echo 'make lint       clang-tidy and cppcheck over all C (Debian: clang-tidy cppcheck)'
	@echo 'make fuzz       fuzzers of the readers, in build/fuzz (clang)'
	@echo 'make fuzz-all   every fuzzer in turn, MINUTES=N each'
	@echo 'make bench      speed, as ratios to rsvg-convert'
	@echo 'make figures    the figures of the papers, in build/figures'
	@echo 'make gallery    examples/gallery: drawings before and after'
	@echo 'make fidelity   do drawings show what the print shows? a table and contact sheets'
	@echo 'make realism    can a machine observer tell drawn lines from scanned ones?'
	@echo 'make tones      the scales of tones of the eight pencils, as src/api/pencil keeps them'
	@echo 'make profiles   captures the eight pencils anew, where the scans are at hand'
	@echo 'make install    to $$(DESTDIR)$$(PREFIX); uninstall takes it away'
	@echo 'make web        the core for browsers and Node, in build/web (Debian: $(packages_web)); check-web tests it'
	@echo 'make package    Debian packages, in build/package (Debian: debhelper)'
	@echo 'make clean      removes build/'
	@echo 'BUILD=release|debug|asan|ubsan|tsan|cover|failing|fuzz   CC=gcc|clang   V=1: show the commands'

-include $(web_obj:.o=.d) $(lib_obj:.o=.d) $(tap_obj:.o=.d) $(ps_obj:.o=.d) $(model_obj:.o=.d) $(O)/tap/ps/tap_ps.d $(O)/tap/model/tap_model.d $(O)/tap/model/tap_assimp.d $(O)/tap/model/program.d $(wildcard $(O)/tool/*.d $(O)/tool/*/*.d $(O)/*.d $(O)/tests/*/*.d)
