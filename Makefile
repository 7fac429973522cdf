# Knotwork
#
#   make setup       install what drawing needs: gnuplot and a C compiler
#   make figures     build everything, run every driver, draw figures/*.svg
#   make check       recompute every number and judge it; needs a C compiler alone
#   make check SAN=1 the same under the address and undefined-behaviour sanitizers
#   make data        a small set of every family of the generator, in build/sets
#   make book        weave build/book/index.html, the lessons on one page (make setup-book installs pandoc)
#
# For those who change it (make setup-dev installs the tools):
#   make identical   the data are the same bytes from gcc and clang, -O0 and -O3
#   make aarch64     data sets have the same sums from another processor, under qemu-user; `make
#                    aarch64-reports`: so have all data and reports
#   make outside     NumPy, Octave, meshio and others read the data sets, and find the same
#   make valgrind    every driver and test under valgrind
#   make book-check  weaving stops when it should; the page in a real browser
#   make lint        clang-format, cppcheck, clang-tidy, shellcheck, luacheck, pyflakes
#   make format      clang-format, in place
#   make fuzz        the reader of mesh files under random input (clang's libFuzzer)
#   make bench       what an evaluation costs, beside the machine and GSL where it is installed
#   make install     the generator as PREFIX/bin/knotwork-gen
#   make clean
#
# CC, OPT and BUILD choose another compiler, optimization and build folder.

CC     ?= cc
OPT    ?= -O3
BUILD  ?= build
PREFIX ?= /usr/local
ifdef SAN
BUILD  := build/san
OPT    := -O1
SANITIZE := -g -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all
endif

# -ffp-contract=off: a fused multiply-add here and none there would change last bits.
CFLAGS = -std=c11 -D_POSIX_C_SOURCE=200809L $(OPT) -ffp-contract=off $(SANITIZE) \
         -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wstrict-prototypes \
         -Wmissing-prototypes -Werror -Ilib -DKW_BUILD='"$(BUILD)"'

LESSONS := $(sort $(wildcard chapters/*/))
DRIVERS := $(notdir $(basename $(sort $(wildcard chapters/*/*.c))))
PLOTS   := $(notdir $(basename $(sort $(wildcard chapters/*/*.gp))))
TESTS   := $(notdir $(basename $(sort $(wildcard tests/test_*.c))))
SCRIPTS := $(filter-out run summary,$(notdir $(basename $(sort $(wildcard tests/*.sh)))))
ifneq ($(words $(DRIVERS)),$(words $(sort $(DRIVERS))))
$(error two drivers have the same name: $(sort $(foreach d,$(DRIVERS),$(if $(filter-out 1,$(words $(filter $d,$(DRIVERS)))),$d))))
endif
LIBRARY := $(BUILD)/lib/libknotwork.a
GEN     := $(BUILD)/bin/gen
FAMILIES := $(filter-out count reference,$(patsubst gen/gen_%.c,%,$(sort $(wildcard gen/gen_*.c))))
GALLERY := $(FAMILIES:%=figures/ex_gen_%.svg)
REPORTS := $(DRIVERS:%=$(BUILD)/claims/%.tsv)
LOGS    := $(TESTS:%=$(BUILD)/tests/%.log) $(SCRIPTS:%=$(BUILD)/tests/%.log) \
           $(BUILD)/tests/ledger.log
SETUP   := $(filter setup setup-book,$(MAKECMDGOALS))

vpath %.c  lib gen tests tests/bench tests/fuzz $(LESSONS)
vpath %.gp $(LESSONS)

.DELETE_ON_ERROR:
.SECONDARY:
.PHONY: all setup setup-book setup-dev figures reports data install check book book-check identical aarch64 aarch64-reports outside valgrind lint format bench fuzz clean FORCE

all: figures

# --- building ---

FOLDERS := $(addprefix $(BUILD)/,obj lib bin data claims tests sets)
$(FOLDERS):
	@mkdir -p $@

$(BUILD)/obj/%.o: %.c | $(FOLDERS) $(SETUP)
	@echo "$(CC) $<"
	@$(CC) $(CFLAGS) -MMD -c -o $@ $<
-include $(wildcard $(BUILD)/obj/*.d)

$(LIBRARY): $(patsubst lib/%.c,$(BUILD)/obj/%.o,$(wildcard lib/*.c))
	@rm -f $@
	@$(AR) rcs $@ $^

$(BUILD)/bin/fuzz_%: $(BUILD)/obj/fuzz_%.o $(LIBRARY)
	@$(CC) $(CFLAGS) -fsanitize=fuzzer -o $@ $^ -lm

$(BUILD)/bin/test_%: $(BUILD)/obj/test_%.o $(BUILD)/obj/test.o $(LIBRARY)
	@$(CC) $(CFLAGS) -o $@ $^ -lm

$(GEN): $(patsubst gen/%.c,$(BUILD)/obj/%.o,$(wildcard gen/*.c)) $(LIBRARY)
	@$(CC) $(CFLAGS) -o $@ $^ -lm

$(BUILD)/bin/%: $(BUILD)/obj/%.o $(LIBRARY)
	@$(CC) $(CFLAGS) -o $@ $^ -lm

# --- drivers and figures: a driver writes its data, then, last of all, its report ---

$(BUILD)/claims/%.tsv: $(BUILD)/bin/%
	$<

reports: $(REPORTS)

figures: $(GEN) $(PLOTS:%=figures/%.svg) $(GALLERY)

# the data are older than the report; if somebody removed them, they are made again
$(BUILD)/data/%.dat: $(BUILD)/claims/%.tsv
	@if [ -f $@ ]; then touch $@; else $(BUILD)/bin/$*; fi

figures/%.svg: %.gp figures/style.gp $(BUILD)/data/%.dat figures/draw.sh | $(SETUP)
	@figures/draw.sh $< $(BUILD)/data/$*.dat $@

# --- data sets ---

data: $(GEN) | $(BUILD)/sets
	@for family in $(FAMILIES); do \
	    $(GEN) $$family --count 20 --validation 5 --test 5 --out $(BUILD)/sets/$$family || exit 1; done

# the gallery: a plot for each family, which begins with the calls of the sets that it shows
$(BUILD)/sets/ex_gen_%/made: gen/ex_gen_%.gp $(GEN)
	@rm -rf $(@D) && mkdir -p $(@D)
	@cd $(@D) && sed -n 's/^#   gen //p' $(abspath $<) | while read -r call; do \
	    $(abspath $(GEN)) $$call || exit 1; done
	@touch $@

figures/ex_gen_%.svg: gen/ex_gen_%.gp gen/gallery.gp figures/style.gp $(BUILD)/sets/ex_gen_%/made figures/draw.sh | $(SETUP)
	@figures/draw.sh $< $(BUILD)/sets/ex_gen_$* $@

install: $(GEN)
	install -D $(GEN) $(DESTDIR)$(PREFIX)/bin/knotwork-gen

# --- checks ---

check: $(LOGS)
	@tests/summary.sh $(LOGS)

$(BUILD)/tests/test_%.log: $(BUILD)/bin/test_% FORCE
	@tests/run.sh $@ $<

$(BUILD)/tests/ledger.log: $(BUILD)/bin/ledger $(REPORTS) FORCE
	@tests/run.sh $@ $< chapters/claims.tsv chapters/ERRATA.md tests/items.txt \
	    $(BUILD)/claims $(DRIVERS)

$(BUILD)/tests/%.log: tests/%.sh $(BUILD)/bin/ledger $(GEN) $(REPORTS) FORCE
	@BUILD=$(BUILD) tests/run.sh $@ $<

# --- the book: woven only from a ledger that holds ---

book: $(BUILD)/book/index.html

$(BUILD)/book/index.html: $(wildcard chapters/book/* chapters/*.* chapters/*/chapter.md \
    chapters/*/*.[ch] lib/*.[ch]) tests/items.txt CITATION.cff $(REPORTS) \
    $(PLOTS:%=figures/%.svg) $(BUILD)/bin/ledger | $(SETUP)
	@$(BUILD)/bin/ledger chapters/claims.tsv chapters/ERRATA.md tests/items.txt $(BUILD)/claims \
	    $(DRIVERS) >$(BUILD)/tests/ledger.log || { grep '^not ok' $(BUILD)/tests/ledger.log; exit 1; }
	@chapters/book/weave.sh $(BUILD)/claims $@

# Woven again, the page has the same bytes.
book-check: $(BUILD)/book/index.html
	@chapters/book/weave.sh $(BUILD)/claims $(BUILD)/book/again.html && \
	    cmp $< $(BUILD)/book/again.html && rm $(BUILD)/book/again.html
	@tests/run.sh $(BUILD)/tests/book_weave.log tests/book/weave_test.sh
	@tests/run.sh $(BUILD)/tests/book_page_check.log tests/book/page_check_test.sh
	@tests/run.sh $(BUILD)/tests/book_page.log tests/book/page_test.py $<
	@tests/summary.sh $(BUILD)/tests/book_*.log

# This build is compared with three others; cc is gcc where nobody says otherwise.
identical: reports
	@for other in gcc-O0 clang-O0 clang-O3; do \
	    $(MAKE) --no-print-directory -s reports CC=$${other%-*} OPT=-$${other#*-} BUILD=build/$$other || exit 1; \
	    for part in data claims; do diff -r $(BUILD)/$$part build/$$other/$$part || exit 1; done; done
	@echo "$(CC) $(OPT), gcc -O0, clang -O0 and -O3: the same bytes in every data file and report"

# The other processor has folders of its own. What is needed is asked for, not installed.
OTHER := $(BUILD)/aarch64
OTHER_MAKE = $(MAKE) --no-print-directory -s CC='aarch64-linux-gnu-gcc -static'
HAS_OTHER = command -v aarch64-linux-gnu-gcc >/dev/null && command -v qemu-aarch64 >/dev/null || \
    { echo "skipped: aarch64: there is no aarch64-linux-gnu-gcc, or no qemu-aarch64"; exit 0; }

aarch64:
	@$(HAS_OTHER); $(OTHER_MAKE) BUILD=$(OTHER) $(OTHER)/bin/gen && mkdir -p $(OTHER)/tests && \
	    BUILD=$(OTHER) RUN=qemu-aarch64 tests/run.sh $(OTHER)/tests/golden.log tests/gen_golden_test.sh && \
	    tests/summary.sh $(OTHER)/tests/golden.log

# gcc 12 for this processor fails with an internal error at a vectorized loop of fmax.
aarch64-reports: SCALAR := $(OTHER)/scalar
aarch64-reports: $(REPORTS)
	@$(HAS_OTHER); $(OTHER_MAKE) BUILD=$(SCALAR) OPT='-O3 -fno-tree-loop-vectorize' $(DRIVERS:%=$(SCALAR)/bin/%) && \
	    for driver in $(DRIVERS); do qemu-aarch64 $(SCALAR)/bin/$$driver || exit 1; done && \
	    for part in data claims; do diff -r $(BUILD)/$$part $(SCALAR)/$$part || exit 1; done && \
	    echo "aarch64: the same bytes in every data file and report"

# Each check is skipped with a word where its program is not installed.
outside: $(GEN) | $(FOLDERS)
	@BUILD=$(BUILD) tests/run.sh $(BUILD)/tests/outside_sets.log tests/outside/sets_test.sh
	@tests/summary.sh $(BUILD)/tests/outside_sets.log
	@grep '^# skipped' $(BUILD)/tests/outside_sets.log || true

WATCHED ?= $(DRIVERS) $(TESTS)

valgrind:
	@$(MAKE) --no-print-directory -s OPT='-O1 -g' BUILD=build/valgrind $(WATCHED:%=build/valgrind/bin/%)
	@$(MAKE) --no-print-directory -s $(WATCHED:%=valgrind-%)
	@echo "valgrind finds nothing in $(words $(WATCHED)) programs"

valgrind-%:
	@log=build/valgrind/$*.log; valgrind -q --leak-check=full --child-silent-after-fork=yes \
	    --error-exitcode=9 build/valgrind/bin/$* >$$log 2>&1 || \
	    { cat $$log; echo "valgrind: $*" >&2; exit 1; }

SOURCES := $(sort $(wildcard lib/*.[ch] gen/*.[ch] tests/*.[ch] tests/*/*.[ch] chapters/*/*.c))

# A function is followed along so many states at most; with the usual 225000 it takes three times as long.
SHALLOWER := -Xclang -analyzer-config -Xclang max-nodes=50000

lint:
	clang-format --dry-run --Werror $(SOURCES)
	cppcheck --quiet --std=c11 --error-exitcode=1 --inline-suppr -Ilib \
	    --enable=warning,style,performance,portability \
	    --suppressions-list=tests/cppcheck.txt $(filter %.c,$(SOURCES))
	@printf '%s\n' $(filter %.c,$(SOURCES)) | xargs -P 2 -n 4 sh -c \
	    'clang-tidy --quiet --warnings-as-errors="*" $(SHALLOWER:%=--extra-arg=%) "$$@" -- \
	    -std=c11 -D_POSIX_C_SOURCE=200809L -Ilib' clang-tidy
	shellcheck .ci/run .ci/install figures/*.sh tests/*.sh tests/book/*.sh tests/outside/*.sh chapters/book/*.sh
	luacheck -q --no-color --std lua54 --max-line-length 120 --read-globals pandoc PANDOC_SCRIPT_FILE \
	    --globals Pandoc -- chapters/book/*.lua
	pyflakes3 $(wildcard tests/*/*.py)

format:
	clang-format -i $(SOURCES)

# GSL takes part where this compiler finds it; nothing else in the project knows of it.
BENCHES  := $(patsubst tests/bench/%.c,$(BUILD)/bin/%,$(sort $(wildcard tests/bench/bench_*.c)))
MEASURES := $(patsubst tests/bench/%.c,$(BUILD)/obj/%.o,$(filter-out tests/bench/bench_%,$(wildcard tests/bench/*.c)))
WITH_GSL  = $(shell echo 'int main(void) { return 0; }' | $(CC) -include gsl/gsl_bspline.h -x c - \
            -lgsl -lgslcblas -lm -o /dev/null 2>/dev/null && echo yes)

$(BUILD)/obj/work_gsl.o: CFLAGS += $(if $(WITH_GSL),-DBENCH_GSL)
$(BUILD)/obj/work_gsl.o: FORCE

$(BUILD)/bin/bench_%: $(BUILD)/obj/bench_%.o $(MEASURES) $(LIBRARY)
	@$(CC) $(CFLAGS) -o $@ $^ $(if $(WITH_GSL),-lgsl -lgslcblas) -lm

bench: $(BENCHES) | $(GEN)
	@for program in $^; do $$program || exit 1; done
	@figures/draw.sh tests/bench/ex_bench.gp $(BUILD)/bench.dat $(BUILD)/ex_bench.svg

# A fixed seed and a fixed count of inputs; what is found is left in build/fuzz.
fuzz:
	@rm -rf build/fuzz/corpus && mkdir -p build/fuzz/corpus
	@$(MAKE) --no-print-directory -s CC=clang BUILD=build/fuzz build/fuzz/bin/fuzz_meshfile \
	    SANITIZE='-g -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all'
	build/fuzz/bin/fuzz_meshfile -seed=1 -runs=400000 -max_total_time=20 -max_len=400 \
	    -timeout=10 -rss_limit_mb=2048 -artifact_prefix=build/fuzz/ -verbosity=0 \
	    -dict=tests/fuzz/meshfile.dict build/fuzz/corpus tests/fuzz/corpus

# --- tools ---

setup:
	@.ci/install gnuplot:gnuplot-nox cc:gcc,libc6-dev

setup-book:
	@.ci/install pandoc:pandoc

MODULES := /usr/lib/python3/dist-packages

setup-dev: setup setup-book
	@.ci/install gcc:gcc,libc6-dev clang:clang,libclang-rt-14-dev valgrind:valgrind,libc6-dbg \
	    clang-format:clang-format clang-tidy:clang-tidy cppcheck:cppcheck \
	    shellcheck:shellcheck luacheck:lua-check pyflakes3:pyflakes3 chromium:chromium python3:python3 \
	    aarch64-linux-gnu-gcc:gcc-aarch64-linux-gnu,libc6-dev-arm64-cross qemu-aarch64:qemu-user \
	    xmllint:libxml2-utils octave-cli:octave \
	    $(MODULES)/numpy:python3-numpy $(MODULES)/meshio:python3-meshio \
	    $(MODULES)/jsonschema:python3-jsonschema

clean:
	rm -rf build
