# randpack: a literate laboratory for random packs. `make help` lists the verbs.

PACKAGES := make gcc libc6-dev libgsl-dev libfftw3-dev zlib1g-dev libconfig-dev gnuplot-nox noweb \
  texlive-latex-recommended texlive-fonts-recommended lmodern clang-format

SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
.DELETE_ON_ERROR:
.SECONDARY:
.SUFFIXES:
MAKEFLAGS += --no-builtin-rules
ifeq ($(MAKELEVEL),0)
MAKEFLAGS += -j$(shell nproc)
endif
.DEFAULT_GOAL := help

export SOURCE_DATE_EPOCH := 1767225600
export FORCE_SOURCE_DATE := 1
export TZ := UTC
export LC_ALL := C.UTF-8
export OMP_WAIT_POLICY := passive

# The book's chapters in reading order, as the spine names them, FOLDER/NAME; the modules are the chapters that hold C; the
# figures are what the folders of figures/ hold. Names are unique, so that a rule finds its file in whatever folder it lies.
CHAPTERS := $(shell sed -n 's/^%chapter //p' src.nw)
WEB      := src.nw $(CHAPTERS:%=src/%.nw)
MODULES  := $(patsubst %.nw,%,$(notdir $(shell grep -l '^<<\[\[[a-z_]*\.h\]\]>>=' $(CHAPTERS:%=src/%.nw))))
ENTRIES  := $(shell sed -n 's/^<<\[\[\([a-z_]*_entry\)\.c\]\]>>=/\1/p' $(CHAPTERS:%=src/%.nw) | sort -u)
# examples/NAME.scene is called NAME-example, so that it may have the name of a finding.
SCENES   := $(basename $(notdir $(sort $(wildcard figures/*/*.scene)))) $(patsubst examples/%.scene,%-example,$(sort $(wildcard examples/*.scene)))
DRAWINGS := $(filter-out figures/tools/%,$(sort $(wildcard figures/*/*.gp figures/*/*.sh)))
FIGURES  := $(basename $(notdir $(DRAWINGS)))
# What is derived from tables of scenes, by a script whose line `# from: SCENE/FILE ...` names these.
DERIVED  := $(basename $(notdir $(shell grep -l '^. from: ' figures/*/*.awk)))
vpath %.nw $(sort $(dir $(CHAPTERS:%=src/%)))
$(foreach kind,scene gp sh awk,$(eval vpath %.$(kind) $(filter-out figures/tools/,$(wildcard figures/*/))))
scene_of = $(or $(wildcard figures/*/$(1).scene),$(patsubst %-example,examples/%.scene,$(1)))
REFERENCES := $(sort $(wildcard tests/ref_*.c))
UNITS    := $(patsubst tests/test_%.c,%,$(sort $(wildcard tests/test_*.c)))

ifeq ($(origin CC),default)
CC       := gcc
endif
CFLAGS   := -O3 -g1 -std=c11 -D_POSIX_C_SOURCE=200809L -ffp-contract=off -fno-math-errno \
            -fno-trapping-math -fopenmp -ffile-prefix-map=$(CURDIR)=.
WARNINGS := -Wall -Wextra -Wpedantic -Wshadow -Wno-missing-field-initializers $(WERROR)
# `make MPI=1 build`: a run shares its realizations by MPI. Only the chapter of ranks is compiled otherwise, and no table knows it.
ifdef MPI
ifeq ($(shell command -v mpicc),)
$(error MPI=1 needs mpicc; on Debian: apt-get install libopenmpi-dev openmpi-bin)
endif
MPI_NEEDS := -DRANDPACK_MPI $(patsubst -I%,-isystem %,$(shell mpicc --showme:compile))
MPI_LIBS  := $(shell mpicc --showme:link)
endif
LIBS     := -lconfig -lfftw3 -lz -lgsl -lgslcblas -lm $(MPI_LIBS)
# Without vectors, of which clang would complain.
SAN      := $(filter-out -O3,$(CFLAGS)) -O1 -fsanitize=address,undefined \
            -fno-sanitize-recover=undefined -Wno-pass-failed
B        := build

.PHONY: FRESH COMPILER help deps build try paper white draft data atlas check check-slow programs lint mutants bench library install uninstall dist clean
help: ## this list
	@echo 'randpack: a literate laboratory for random packs of hard particles'
	@sed -n 's/^\([a-z-]*\):[^#]*## \(.*\)/  make \1\t\2/p' $(firstword $(MAKEFILE_LIST)) | expand -t 20

# ---------------------------------------------------------------- packages
INSTALL = apt-get install -y --no-install-recommends $(PACKAGES)
deps: ## install the packages (Debian 12 or 13, as root or with sudo)
	@state=$$(dpkg-query -W -f='$${Status}\n' $(PACKAGES) 2>&1 || true); \
	if grep -qv '^install ok installed$$' <<<"$$state"; then \
	  if ! command -v apt-get >/dev/null || [ ! -e /etc/debian_version ]; then \
	    printf 'not Debian; install what corresponds to:\n  %s\n' '$(INSTALL)'; exit 1; fi; \
	  if [ "$$(id -u)" = 0 ]; then as=; elif sudo -n true 2>/dev/null; then as=sudo; else \
	    printf 'no rights to install; type:\n  sudo %s\n' '$(INSTALL)'; exit 1; fi; \
	  $$as apt-get update -q && DEBIAN_FRONTEND=noninteractive $$as $(INSTALL); \
	else echo 'deps: all there'; fi

# `make deps paper`: nothing else starts before the packages are there.
ifneq ($(filter deps,$(MAKECMDGOALS)),)
.NOTPARALLEL:
$(filter-out deps,$(MAKECMDGOALS)): deps
	@$(MAKE) --no-print-directory $@
else

# ---------------------------------------------------------------- tangling
# A stamp a module: cpif leaves the time of an unchanged file alone.
$(B)/c/%.stamp: %.nw
	@mkdir -p $(B)/c $(B)/plain
	@for f in $$(sed -n 's/^<<\[\[\([a-z_]*\.[ch]\)\]\]>>=/\1/p' $< | sort -u); do \
	  if [[ $$f = *.h ]]; then L=; else L=-L; fi; \
	  notangle $$L -R"[[$$f]]" $< | cpif $(B)/c/$$f; \
	  notangle -R"[[$$f]]" $< | cpif $(B)/plain/$$f; done
	@touch $@
$(B)/c/randpack.stamp: src/scenes/randpack.nw
	@mkdir -p $(B)/c $(B)/plain
	@notangle -L -R'[[randpack.c]]' $< | cpif $(B)/c/randpack.c
	@notangle -R'[[randpack.c]]' $< | cpif $(B)/plain/randpack.c
	@touch $@
STAMPS := $(MODULES:%=$(B)/c/%.stamp) $(B)/c/randpack.stamp
$(B)/c/randpack.c $(B)/plain/randpack.c: $(B)/c/randpack.stamp ;
$(B)/c/%.c $(B)/c/%.h $(B)/plain/%.c $(B)/plain/%.h: $(B)/c/%.stamp ;
$(B)/c/%_entry.c $(B)/plain/%_entry.c: $(B)/c/%.stamp ;

# ---------------------------------------------------------------- fingerprints
# Of the code without comments, blank lines, #line and words for people, W("..."), so that prose and help are free.
PRINT = perl tests/bare.pl | tr '\n' ' ' | sed -E 's/\bW\((("([^"\\]|\\.)*")[[:space:]]*)+\)//g' | sha256sum | cut -c1-16
$(B)/print/%: tests/bare.pl $(B)/plain/%.h $(B)/plain/%.c
	@mkdir -p $(@D)
	@cat $(B)/plain/$*.h $(B)/plain/$*.c | $(PRINT) | cpif $@
$(B)/print/%_entry: tests/bare.pl $(B)/plain/%_entry.c
	@mkdir -p $(@D)
	@cat $(B)/plain/$*_entry.c | $(PRINT) | cpif $@
# Looked at each time, so that another compiler compiles everything anew; here one that is too old is told so.
$(B)/print/flags: COMPILER
	@mkdir -p $(@D)
	@version=$$(printf '%s\n' '#ifdef __has_builtin' '#if __has_builtin(__builtin_shufflevector)' __VERSION__ \
	  '#endif' '#endif' | $(CC) -E -P - | tr -d '\n'); [ -n "$$version" ] || { echo \
	  '$(CC) cannot compile this: gcc 12, clang 14 or a newer one is needed, as in make CC=gcc-12 build'; exit 1; }; \
	printf '%s\n' '$(filter-out -ffile-prefix-map%,$(CFLAGS))' "$$version" | sha256sum | cut -c1-16 | cpif $@
COMPILER: ;
$(B)/print/mpi: COMPILER
	@mkdir -p $(@D)
	@echo '$(MPI_NEEDS)' | cpif $@
$(B)/print/strict: COMPILER
	@mkdir -p $(@D)
	@echo '$(WERROR)' | cpif $@
PRINTS := $(MODULES:%=$(B)/print/%) $(ENTRIES:%=$(B)/print/%) $(B)/print/flags
$(B)/c/prints.stamp: $(PRINTS)
	@for p in $(PRINTS); do printf '{"%s", "%s"},\n' "$${p##*/}" "$$(<$$p)"; done | \
	  cpif $(B)/c/prints.inc
	@touch $@
$(B)/c/prints.inc: $(B)/c/prints.stamp ;
$(B)/c/includes.stamp: src/scenes/includes.awk $(STAMPS)
	@awk -f $< $(B)/plain/*.[ch] | cpif $(B)/c/includes.inc
	@touch $@
$(B)/c/includes.inc: $(B)/c/includes.stamp ;
INC := $(B)/c/prints.inc $(B)/c/includes.inc

# ---------------------------------------------------------------- compiling
OBJECTS := $(MODULES:%=$(B)/obj/%.o) $(ENTRIES:%=$(B)/obj/%.o)
$(B)/obj/%.o: $(B)/c/%.c $(B)/print/flags $(B)/print/strict | $(STAMPS) $(INC)
	@mkdir -p $(@D)
	@echo '  compile $*'
	@$(CC) $(CFLAGS) $(WARNINGS) -MMD -MP -I$(B)/c -c $< -o $@
$(B)/san/%.o: $(B)/c/%.c $(B)/print/flags $(B)/print/strict | $(STAMPS) $(INC)
	@mkdir -p $(@D)
	@$(CC) $(SAN) $(WARNINGS) -MMD -MP -I$(B)/c -c $< -o $@
$(B)/san/ref_%.o: tests/ref_%.c $(B)/print/flags $(B)/print/strict | $(STAMPS)
	@mkdir -p $(@D)
	@$(CC) $(SAN) $(WARNINGS) -MMD -MP -I$(B)/c -c $< -o $@
$(B)/obj/ranks.o: $(B)/print/mpi
$(B)/obj/ranks.o: private WARNINGS += $(MPI_NEEDS)
-include $(wildcard $(B)/obj/*.d $(B)/san/*.d)
$(B)/bin/randpack: $(B)/obj/randpack.o $(filter-out %/guard.o %/library.o,$(OBJECTS))
	@mkdir -p $(@D)
	@$(CC) $(CFLAGS) $^ $(LIBS) -o $@
# What the program does and says: its text without comments, so that an edit of prose neither draws nor runs anything again.
$(B)/print/program: $(STAMPS) tests/bare.pl | $(B)/bin/randpack
	@cat $(B)/plain/*.[ch] | perl tests/bare.pl | sha256sum | cpif $@
build: $(B)/bin/randpack ## leave build/bin/randpack; MPI=1: for mpirun, too (Debian's libopenmpi-dev)
try: $(B)/bin/randpack ## a first pack in seconds: its numbers, its g(R), a picture
	@examples/try.sh $< $(B)/try

# ---------------------------------------------------------------- computing
# What a command took, printed when it has ended.
TIMED = TIMEFORMAT='  $(1) in %R s, %U s of the processor'; time
# A scene runs again when its text or the fingerprint of the modules that it
# uses has changed, not when the program has merely been linked again.
# A line `# packs: FILE ...` in it names packs that it measures, instead of making some.
define note_key
	@mkdir -p $(@D)
	@{ $(B)/bin/randpack plan $< | grep '^fingerprint'; sed '/^ *#/d' $<; sed -n 's/^# packs: *//p' $< | xargs -r cat; } | cpif $(@:checked=key)
	@touch $@
endef
packs_of = $(shell sed -n 's/^. packs: *//p' $(call scene_of,$(1)))
do_scene = $(if $(call packs_of,$(1)),measure $(call packs_of,$(1)) --scene,run) $(call scene_of,$(1))
$(B)/data/%.checked: %.scene $(B)/bin/randpack
	$(note_key)
$(B)/data/%-example.checked: examples/%.scene $(wildcard examples/*.txt) $(B)/bin/randpack
	$(note_key)
$(B)/data/%.key: $(B)/data/%.checked ;
# Scenes with a line `# atlas` are too long for the book, which takes their tables from their record under data/atlas
# when the program of today makes their first realization as it was recorded.
ATLAS := $(basename $(notdir $(shell grep -lx '. atlas' figures/*/*.scene)))
$(ATLAS:%=$(B)/data/%/summary.tsv): $(B)/data/%/summary.tsv: $(B)/data/%.key data/atlas/%/record tests/atlas.sh $(if $(FRESH),FRESH)
	@echo '  verify $*'
	@[ -z "$(FRESH)" ] || FRESH=1 tests/atlas.sh $*
	@$(if $(DRAFT),,$(call TIMED,verified $*) tests/atlas.sh --probe $*)
	@rm -rf $(@D) && cp -r data/atlas/$* $(@D)
	@touch $@
data/atlas/%/record:
	@echo 'data/atlas/$*: not recorded; make atlas'; exit 1
$(B)/data/%/summary.tsv: $(B)/data/%.key
	@echo '  compute $*'
	@rm -rf $(@D)
	@$(call TIMED,computed $*) $(B)/bin/randpack $(call do_scene,$*) --out $(@D) \
	  $(if $(DRAFT),$$(paper/few $(call scene_of,$*) $(DRAFT)))
	@touch $@
# What is derived: the tables of other scenes, read again. A script runs in build/data, and may write tables beside its summary.
define sources
	@mkdir -p $(@D)
	@{ printf '$(B)/data/$*/summary.tsv:'; sed -n 's/^# from: //p' $< | tr ' ' '\n' | sed 's|/.*||' | sort -u | \
	  sed 's|.*| $(B)/data/&/summary.tsv|' | tr -d '\n'; echo; } | cpif $@
	@touch $@
endef
$(B)/derived/%.d: %.awk
	$(sources)
$(DERIVED:%=$(B)/data/%/summary.tsv): $(B)/data/%/summary.tsv: %.awk
	@mkdir -p $(@D)
	@cd $(B)/data && eval "set -- $$(sed -n 's/^# from: //p' $(CURDIR)/$<)" && \
	  awk -v dir=$* -f $(CURDIR)/$< "$$@" > $*/summary.tsv
# What the recorded runs have taken.
$(B)/data/atlas/summary.tsv: $(ATLAS:%=data/atlas/%/record)
	@mkdir -p $(@D)
	@awk 'BEGIN { print "quantity\tvalue\tstandard_error" } /seconds of the processor: / { n = split(FILENAME, path, "/"); \
	  printf "seconds@%s\t%.0f\t0\n", path[n - 1], $$NF }' $^ > $@
# Speed against error: the operations here, the seconds from their record.
BENCH := $(wildcard tests/bench*.[ch])
BENCHED := outcome simd box rng pack cells rsa pairs contact partials sizes mixture py table \
  near motion events engine crm core field gravity coarse dilute shake chain theory \
  elementary shape overlap apart cover turning compression penetrable points rim dynamics relax touch indicator threepoint \
  twopoint covariance raster microstructure ewald share flags
$(B)/data/speed/summary.tsv: $(BENCH) $(wildcard tests/ref_*) $(BENCHED:%=$(B)/print/%) | $(B)/bench
	@echo '  compute speed'
	@$(call TIMED,computed speed) $(B)/bench ops $(@D)
# Seconds that were recorded with other code, or by another compiler, are printed with a sign that says so; lint refuses
# them. `make paper FRESH=1` records new ones.
$(B)/data/seconds/summary.tsv: data/bench-seconds.tsv $(BENCH) $(BENCHED:%=$(B)/print/%) $(if $(FRESH),FRESH) | $(B)/bench
	@[ -z "$(FRESH)" ] || tests/bench.sh
	@$(B)/bench recorded $< $(@D)
FRESH: ;
data: $(SCENES:%=$(B)/data/%/summary.tsv) ## run all scenes, the long ones from their records
atlas: $(B)/bin/randpack ## the runs that are too long for the book, recorded under data/ (an hour)
	@tests/atlas.sh $(ATLAS)

# The hard cases, too, run again when the code has changed, not the prose.
$(B)/hard: tests/hard.c $(OBJECTS)
	@$(CC) $(CFLAGS) $(WARNINGS) -I$(B)/c $^ $(LIBS) -o $@
$(B)/hard.tsv: tests/hard tests/hard.c $(PRINTS) $(B)/plain/randpack.c | $(B)/hard $(B)/bin/randpack
	@echo '  compute hard cases'
	@$(call TIMED,computed hard cases) tests/hard $@

# ---------------------------------------------------------------- figures
# The scenes that a figure reads stand in its line `# data: ...`.
define depend
	@mkdir -p $(@D)
	@{ printf '$(B)/figures/$*.tex:'; sed -n 's/^# data://p' $< | tr ' ' '\n' | \
	  sed -n '/\//{s|^| |p;b};s|.\+| $(B)/data/&/summary.tsv|p' | tr -d '\n'; echo; } | cpif $@
	@touch $@
endef
$(B)/figures/%.d: %.gp
	$(depend)
$(B)/figures/%.d: %.sh
	$(depend)
ifneq ($(filter help deps clean install uninstall dist library bench build try lint mutants atlas,$(or $(MAKECMDGOALS),help)),$(or $(MAKECMDGOALS),help))
-include $(FIGURES:%=$(B)/figures/%.d) $(DERIVED:%=$(B)/derived/%.d)
endif
# Plots by gnuplot, checked as they are drawn; drawings of packs by their scripts.
$(B)/figures/%.tex: %.gp $(wildcard figures/tools/*)
	@echo '  draw $*'
	@mkdir -p $(@D)
	@figures/tools/draw $< $@ $(if $(DRAFT),|| echo '\fbox{a few packs do not make this figure}' > $@)
$(B)/figures/%.tex: %.sh $(wildcard figures/tools/* figures/*/*.awk)
	@echo '  draw $*'
	@mkdir -p $(@D)
	@$< > $@

$(B)/map.tsv: figures/book/map.awk $(WEB) $(STAMPS)
	@awk -f $< $(WEB) $(B)/plain/*.[ch] | cpif $@

# ---------------------------------------------------------------- the book
# What comes from runs that are recorded under data/ bears a sign wherever it is printed.
RECORDED := $(ATLAS) propellant-optimum atlas seconds
SUMMARIES := $(SCENES:%=$(B)/data/%/summary.tsv) $(DERIVED:%=$(B)/data/%/summary.tsv) \
  $(B)/data/speed/summary.tsv $(B)/data/seconds/summary.tsv $(B)/data/atlas/summary.tsv
# Those that the prose names: all of them are more than TeX has room for.
$(B)/paper/values.tex: paper/values.awk $(WEB) $(wildcard paper/*.tex) $(SUMMARIES)
	@mkdir -p $(@D)
	@perl -0777 -ne 'while (/\\val(?:only|err)?\s*\{([^{}]*)\}\s*\{([^{}]*)\}/g) { print "$$1\@$$2\n" }' \
	  $(WEB) $(wildcard paper/*.tex) | sort -u > $(B)/paper/used
	@awk -v recorded='$(RECORDED)' -f paper/values.awk $(B)/paper/used $(SUMMARIES) > $@
# Which figures are recorded, and how much in all.
$(B)/paper/recorded.tex: paper/recorded.awk $(WEB) paper/front.tex $(DRAWINGS) $(B)/data/seconds/summary.tsv Makefile
	@mkdir -p $(@D)
	@awk -v recorded='$(RECORDED)' -v runs=$(words $(ATLAS)) -v draft=$(DRAFT) \
	  -v other="$$(awk -F'\t' '$$1 == "other_code" { print $$2 + 0 }' $(B)/data/seconds/summary.tsv)" \
	  -f $< $(DRAWINGS) $(WEB) paper/front.tex > $@
# Claims of the sources, and our own controls, judged by one rule.
$(B)/findings.tsv: data/claims.tsv paper/findings.awk $(SUMMARIES)
	@awk -v draft=$(DRAFT) -f paper/findings.awk data/claims.tsv $(SUMMARIES) > $@
$(B)/controls.tsv: data/controls.tsv paper/findings.awk $(SUMMARIES)
	@awk -v draft=$(DRAFT) -f paper/findings.awk data/controls.tsv $(SUMMARIES) > $@
$(B)/paper/%.tex: $(B)/%.tsv paper/findings-tex.awk
	@mkdir -p $(@D)
	@awk -v score=$(@D)/$*-score.tex -v recorded='$(RECORDED)' -f paper/findings-tex.awk $< > $@
$(B)/paper/hard.tex: $(B)/hard.tsv paper/hard.awk
	@mkdir -p $(@D)
	@awk -v score=$(@D)/hard-score.tex -f paper/hard.awk $< > $@
$(B)/paper/woven.tex: $(WEB)
	@mkdir -p $(@D)
	@noweave -n -index $(WEB) > $@
# And what a reader looks things up in: subjects, what a chapter uses, what it is tested by.
$(B)/paper/web.tex: $(B)/paper/woven.tex paper/apparatus paper/subjects.tsv tests/mutants.tsv
	@paper/apparatus $< paper/subjects.tsv tests/mutants.tsv tests $(B)/plain > $@
# The user's guide: all keys, rows and tables, as the program tells them; and what its commands print, in a tree of their own.
$(B)/paper/keys.tex: paper/keys.awk paper/tex.awk paper/unwrap.awk $(B)/bin/randpack
	@mkdir -p $(@D)
	@$(B)/bin/randpack help | awk -f paper/unwrap.awk | awk -f paper/tex.awk -f $< | cpif $@
$(B)/paper/files.tex: paper/files.awk paper/tex.awk paper/unwrap.awk $(B)/bin/randpack
	@mkdir -p $(@D)
	@$(B)/bin/randpack help | sed -n 's/^  \([a-z]*\.[A-Za-z0-9_-]*\): .*/\1/p' | while read -r entry; do $(B)/bin/randpack help $$entry; done | \
	  awk -f paper/unwrap.awk | awk -f paper/tex.awk -f $< | cpif $@
$(B)/paper/guide.stamp: src/guide/guide.nw paper/sessions $(wildcard examples/*.scene examples/*.txt) $(B)/print/program
	@mkdir -p $(@D)
	@echo '  run the commands of the guide'
	@paper/sessions $< $(B)/guide | cpif $(B)/paper/guide.tex
	@touch $@
$(B)/paper/guide.tex: $(B)/paper/guide.stamp ;
TEX := paper/book.tex paper/front.tex paper/preamble.tex paper/refs.bib $(B)/paper/web.tex \
  $(B)/paper/values.tex $(B)/paper/recorded.tex $(B)/paper/keys.tex $(B)/paper/files.tex $(B)/paper/guide.tex \
  $(B)/paper/findings.tex $(B)/paper/controls.tex $(B)/paper/hard.tex $(FIGURES:%=$(B)/figures/%.tex)
# The same lines on the same pages, of one size of paper or the other.
PAPER := a4
$(if $(filter-out a4 letter,$(PAPER)),$(error PAPER is a4 or letter))
# What takes longest begins first, so that nothing waits for it at the end.
LONGEST := $(B)/data/speed/summary.tsv $(B)/data/growth-isothermal/summary.tsv
$(B)/paper.pdf $(B)/paper-letter.pdf: $(LONGEST) $(TEX) paper/weave
	@echo '  weave'
	@paper/weave $(B)/paper $(if $(filter %-letter.pdf,$@),letter,a4)
	@cp $(B)/paper/book$(if $(filter %-letter.pdf,$@),-letter).pdf $@
paper: $(B)/paper$(if $(filter letter,$(PAPER)),-letter).pdf ## build/paper.pdf: computed (long runs: from their records), drawn and woven; PAPER=letter: paper-letter.pdf
	@echo '$<'
white: $(B)/paper.pdf ## how much of the pages is white at their feet; needs pdftoppm
	@paper/white $<

# A draft is the same book from a few packs a scene, built in a folder of its own where only the program is that of build/.
draft: $(B)/bin/randpack $(B)/hard ## build/draft.pdf: the whole book in minutes, from a few packs a scene
	@mkdir -p $(B)/draft/$(B)
	@ln -sfn $(addprefix ../../,Makefile README.md src.nw src paper figures data tests examples) $(B)/draft
	@ln -sfn $(addprefix ../../../$(B)/,bin c plain print obj hard) $(B)/draft/$(B)
	@$(MAKE) --no-print-directory -C $(B)/draft DRAFT=2 $(B)/paper.pdf
	@cp $(B)/draft/$(B)/paper.pdf $(B)/draft.pdf
	@echo 'build/draft.pdf'

# ---------------------------------------------------------------- tests
# One program a module, with the sanitizers; then the command itself. All
# objects and references are compiled once; a program takes what it needs.
$(B)/san/all.a: $(MODULES:%=$(B)/san/%.o) $(ENTRIES:%=$(B)/san/%.o) $(REFERENCES:tests/%.c=$(B)/san/%.o)
	@rm -f $@
	@ar rcs $@ $^
$(B)/test/%: tests/test_%.c $(B)/san/all.a $(wildcard tests/*.h)
	@mkdir -p $(@D)
	@$(CC) $(SAN) $(WARNINGS) -I$(B)/c -Itests $< $(B)/san/all.a $(LIBS) -o $@
check: $(UNITS:%=$(B)/test/%) $(B)/bin/randpack $(B)/hard library ## the tests, in some minutes (five on two cores)
	@tests/run $(sort $(wildcard tests/check-*.sh)) $(UNITS:%=$(B)/test/%)
$(B)/slow: tests/slow.c tests/few.h $(OBJECTS)
	@$(CC) $(CFLAGS) $(WARNINGS) -I$(B)/c $(filter-out %.h,$^) $(LIBS) -o $@
# The same programs of the plain build.
$(B)/obj/ref_%.o: tests/ref_%.c $(B)/print/flags $(B)/print/strict | $(STAMPS)
	@mkdir -p $(@D)
	@$(CC) $(CFLAGS) $(WARNINGS) -MMD -MP -I$(B)/c -c $< -o $@
$(B)/unit/%: tests/test_%.c $(OBJECTS) $(REFERENCES:tests/%.c=$(B)/obj/%.o) $(wildcard tests/*.h)
	@mkdir -p $(@D)
	@$(CC) $(CFLAGS) $(WARNINGS) -I$(B)/c -Itests $(filter-out %.h,$^) $(LIBS) -o $@
check-slow: $(B)/bin/randpack $(B)/slow $(B)/bench $(B)/hard $(UNITS:%=$(B)/unit/%) ## the long tests, an hour or two
	@CC='$(CC)' tests/run $(sort $(wildcard tests/slow-*.sh))
# Warnings are errors here and in CI only: in a build of its own, or, as in CI, in the build that was made so from the start.
programs: $(B)/bin/randpack $(B)/hard $(B)/slow $(B)/bench $(UNITS:%=$(B)/test/%)
lint: $(STAMPS) $(INC) $(B)/bench ## form: the web, the warnings, the layout, the prose
	@$(MAKE) --no-print-directory $(if $(WERROR),,B=$(B)/lint WERROR=-Werror) programs
	@tests/lint '$(WEB)' '$(MODULES)' '$(ENTRIES)'
mutants: $(STAMPS) $(INC) ## planted errors, each caught by a named test
	@ROWS='$(ROWS)' tests/mutants '$(CC) $(CFLAGS)' '$(MODULES) $(ENTRIES)' '$(LIBS)'
$(B)/bench: $(BENCH) $(wildcard tests/ref_*.c) $(OBJECTS)
	@$(CC) $(CFLAGS) $(WARNINGS) $(if $(DRAFT),-DDRAFT) -I$(B)/c -Itests tests/bench.c $(wildcard tests/ref_*.c) $(OBJECTS) $(LIBS) -o $@
bench: $(B)/bench ## speeds on this machine when it is idle, recorded under data/
	@tests/bench.sh

# ---------------------------------------------------------------- the library
# The modules that the chapter library uses, compiled once more: as position-independent code without OpenMP, and with the
# functions that must not end a program replaced by those of the chapter guard, which has their names.
VERSION := $(shell sed -n 's/^.define TABLE_VERSION "\(.*\)"$$/\1/p' src/scenes/table.nw)
SONAME  := librandpack.so.0
LIBRARY := $(shell awk -f src/library/uses.awk $(CHAPTERS:%=src/%.nw))
GUARDED := $(shell sed -n '/^@ %def guard_[^r]/{s/@ %def//;s/ guard_/ /g;p}' src/library/guard.nw)
PIC     := $(filter-out -fopenmp,$(CFLAGS)) -fopenmp-simd -Wno-unknown-pragmas -fPIC -fvisibility=hidden -ffunction-sections -fdata-sections
$(B)/lib/names: COMPILER
	@mkdir -p $(@D)
	@echo '$(PIC) $(GUARDED)' | cpif $@
$(B)/lib/%.o: $(B)/c/%.c $(B)/print/flags $(B)/lib/names | $(STAMPS)
	@mkdir -p $(@D)
	@$(CC) $(PIC) $(WARNINGS) $(if $(filter outcome guard,$*),,$(foreach name,$(GUARDED),-D$(name)=guard_$(name))) -MMD -MP -I$(B)/c -c $< -o $@
-include $(wildcard $(B)/lib/*.d)
# One object of which only the functions of the header are seen, without what they do not reach.
$(B)/lib/librandpack.o: $(LIBRARY:%=$(B)/lib/%.o)
	@echo '  library'
	@$(CC) -r -nostdlib $^ -Wl,--gc-sections,--gc-keep-exported -o $@.part
	@objcopy --localize-hidden --strip-unneeded $@.part $@ && rm $@.part
$(B)/lib/librandpack.a: $(B)/lib/librandpack.o
	@rm -f $@ && ar rcsD $@ $<
$(B)/lib/librandpack.so: $(B)/lib/librandpack.o
	@echo 'RANDPACK_0 { global: randpack_*; local: *; };' > $(B)/lib/symbols
	@$(CC) -shared $< -Wl,-soname,$(SONAME),--version-script=$(B)/lib/symbols,-z,defs -lgsl -lgslcblas -lz -lm -o $@
library: $(B)/lib/librandpack.a $(B)/lib/librandpack.so ## build/lib/librandpack.a and .so, to be called from C

# ---------------------------------------------------------------- installing
PREFIX := /usr/local
bin     := $(DESTDIR)$(PREFIX)/bin
lib     := $(DESTDIR)$(PREFIX)/lib
shared  := $(DESTDIR)$(PREFIX)/share
include := $(DESTDIR)$(PREFIX)/include
DOCS    := $(shared)/doc/randpack
$(B)/share/randpack.1: share/man $(B)/bin/randpack
	@mkdir -p $(@D)
	@share/man $(B)/bin/randpack > $@
$(B)/share/completion: share/completion $(B)/bin/randpack
	@mkdir -p $(@D)
	@share/completion $(B)/bin/randpack > $@
install: $(B)/bin/randpack library $(B)/share/randpack.1 $(B)/share/completion ## to /usr/local, or to PREFIX=..., within DESTDIR=...
	install -D -m 755 $(B)/bin/randpack "$(bin)/randpack"
	install -D -m 644 $(B)/share/randpack.1 "$(shared)/man/man1/randpack.1"
	install -D -m 644 $(B)/share/completion "$(shared)/bash-completion/completions/randpack"
	install -D -m 644 $(B)/plain/library.h "$(include)/randpack.h"
	install -D -m 644 $(B)/lib/librandpack.a "$(lib)/librandpack.a"
	install -D -m 644 $(B)/lib/librandpack.so "$(lib)/librandpack.so.$(VERSION)"
	ln -sf librandpack.so.$(VERSION) "$(lib)/$(SONAME)"
	ln -sf $(SONAME) "$(lib)/librandpack.so"
	install -d "$(lib)/pkgconfig"
	sed 's|@PREFIX@|$(PREFIX)|; s|@VERSION@|$(VERSION)|' share/randpack.pc > "$(lib)/pkgconfig/randpack.pc"
	chmod 644 "$(lib)/pkgconfig/randpack.pc"
	install -d "$(DOCS)/examples"
	install -m 644 README.md CHANGES CITATION.cff LICENSE "$(DOCS)"
	install -m 644 examples/*.c examples/*.scene examples/*.txt "$(DOCS)/examples"
	@if [ -e $(B)/paper.pdf ]; then echo 'install -m 644 $(B)/paper.pdf "$(DOCS)"'; install -m 644 $(B)/paper.pdf "$(DOCS)"; \
	else echo 'without the book: $(B)/paper.pdf is not there; make paper makes it'; fi
uninstall: ## remove what install has put there
	rm -f "$(bin)/randpack" "$(shared)/man/man1/randpack.1" "$(shared)/bash-completion/completions/randpack" "$(include)/randpack.h" \
	  "$(lib)/librandpack.a" "$(lib)/librandpack.so.$(VERSION)" "$(lib)/$(SONAME)" "$(lib)/librandpack.so" "$(lib)/pkgconfig/randpack.pc"
	rm -rf "$(DOCS)"
# The same bytes from any clone: files by name, of one owner and one time.
dist: ## build/randpack-VERSION.tar.gz, which builds and is tested without git
	@mkdir -p $(B)
	@{ if [ -e .git ]; then git ls-files; else find . -path ./$(B) -prune -o -type f -print | sed 's|^\./||'; fi; } | LC_ALL=C sort > $(B)/dist.list
	@tar cf - --format=ustar --mtime=@$(SOURCE_DATE_EPOCH) --owner=0 --group=0 --numeric-owner --mode=u+rw,go-w,a+rX \
	  --transform='s|^|randpack-$(VERSION)/|' -T $(B)/dist.list | gzip -n -9 > $(B)/randpack-$(VERSION).tar.gz
	@echo '$(B)/randpack-$(VERSION).tar.gz'
endif
clean: ## remove build/
	rm -rf $(B)
