# Shadow Lab. README.md tells how to use it; `make help` lists the targets.
MAKEFLAGS += --no-builtin-rules
SHELL := /bin/bash
CC := gcc
BUILD ?= build
CFLAGS ?= -O2 -g
SANITIZE ?=
LAB ?=
override LAB := $(if $(filter 1 2 3 4 5 6 7 8 9,$(LAB)),0)$(LAB)
SUBMISSION ?= labs
ARGS ?=

PACKAGES := libpng jansson
ALL_CFLAGS = -std=c11 -Wall -Wextra -Wpedantic -Werror $(CFLAGS) $(SANITIZE) -fno-math-errno -D_GNU_SOURCE -DCGLM_ALL_UNALIGNED \
	-Icommon -Igrader -isystem $(BUILD)/include $(shell pkg-config --cflags $(PACKAGES)) -MMD -MP
LIBS = $(shell pkg-config --libs $(PACKAGES)) -lm -ldl

# Those that are there: the student's kit does without some.
TOOLS := $(patsubst grader/%.c,%,$(wildcard $(patsubst %,grader/%.c,grade frame skeletons prove record scenes bench_frames bench_truth truth_worker \
	stability chart)))
WORKER := $(patsubst %,$(BUILD)/grader/%.o,worker host stage_view primitives_view capture)
SERVERS := $(BUILD)/grader/transfer.o # of every program that answers requests
GRADER := $(patsubst %.c,$(BUILD)/%.o,$(filter-out $(WORKER:$(BUILD)/%.o=%.c) $(TOOLS:%=grader/%.c),\
	$(wildcard grader/*.c grader/class/*.c grader/report/*.c)))
# The ray-traced truth and the only user of Embree; what stands on it: its benchmark and its tests.
TRUTH := $(patsubst %.c,$(BUILD)/%.o,$(wildcard grader/truth/*.c))
ON_TRUTH := $(patsubst %,$(BUILD)/%,bench_truth truth_worker stability chart test_truth test_truth_occlusion test_truth_lab test_study)
# The jail: the keeper's side belongs to the grader; the programs of inside/ stand alone. The shim is static where the
# system has the archives, so that a process inside begins sooner.
JAIL := $(patsubst %.c,$(BUILD)/%.o,$(wildcard grader/jail/*.c))
INSIDE := $(patsubst %,$(BUILD)/jail_%,shim probe unpack)
STATIC := $(if $(findstring /,$(shell $(CC) -print-file-name=libseccomp.a)),-static)
GRADER += $(JAIL)
# The window, the only user of GLFW and stb; the truth is one of its views where Embree is there.
WINDOW := $(patsubst %.c,$(BUILD)/%.o,$(wildcard grader/window/*.c))
EMBREE := $(wildcard $(addsuffix /include/embree3/rtcore.h,/usr /usr/local /opt/homebrew))
VIEW := $(if $(shell pkg-config --exists glfw3 && echo yes),$(BUILD)/view) $(if $(and $(EMBREE),$(TRUTH)),$(BUILD)/truth_worker)
# For their tests; among them shims that are weakened on purpose.
WEAK := $(patsubst %,$(BUILD)/weak_%,files filter limit)
HOSTILE := $(BUILD)/hostile $(BUILD)/without $(WEAK)
# The study: labs measured against the truth.
STUDY := $(patsubst %.c,$(BUILD)/%.o,$(wildcard grader/study/*.c))
ON_STUDY := $(patsubst %,$(BUILD)/%,stability chart test_truth_lab test_study)
STABILITY := $(patsubst %.c,$(BUILD)/%.o,$(wildcard grader/stability/*.c))
COMMON := $(patsubst %.c,$(BUILD)/%.o,$(wildcard common/*.c))
GLAD := $(patsubst %,$(BUILD)/glad/%.o,gl egl)
# The floor of common/ without GL, which the grader stands on.
NO_GL := $(filter-out $(patsubst %,$(BUILD)/common/%.o,casters context context_egl context_osmesa draw frame_view geometry gl gl_state model program \
	shadow_map target),$(COMMON))
TESTS := $(patsubst grader/tests/%.c,$(BUILD)/%,$(wildcard grader/tests/test_*.c))

# The watch: a program of several files.
WATCH := $(patsubst %.c,$(BUILD)/%.o,$(wildcard grader/watch/*.c))

build: $(BUILD)/worker $(BUILD)/watch $(VIEW) $(INSIDE) $(filter-out $(ON_TRUTH),$(TOOLS:%=$(BUILD)/%)) ## build everything (default)

grade: build ## grade a submission: make grade [LAB=03] [SUBMISSION=labs] [ARGS="--seed 1"]
	$(BUILD)/grade $(if $(LAB),--lab $(LAB)) $(if $(filter labs,$(SUBMISSION)),--record) $(ARGS) $(SUBMISSION)

watch: $(BUILD)/worker $(BUILD)/watch ## grade on save, with hints and progress: make watch [LAB=03]
	@$(BUILD)/watch $(if $(LAB),--lab $(LAB)) $(ARGS)

progress: $(BUILD)/watch ## how far am I in all labs?
	@$(BUILD)/watch --list

demo: build ## grade the labs as shipped, then the solutions
	$(BUILD)/grade labs || true
	$(BUILD)/grade solutions

run: build $(BUILD)/view ## open a lab in a window: make run LAB=05 [ARGS="--seed 2"]
	$(BUILD)/view $(if $(LAB),--lab $(LAB)) $(if $(filter-out labs,$(SUBMISSION)),--submission $(SUBMISSION)) $(ARGS)

hint: ## show the hints of a task: make hint TASK=3.2
	@grader/hint $(TASK)

trace: $(BUILD)/worker $(BUILD)/frame ## record a frame of your lab for a frame debugger: make trace LAB=03 [TOOL=renderdoc] [SCENE="far floor"]
	@TOOL="$(TOOL)" SCENE="$(SCENE)" grader/trace $(LAB)

site: grader/site/node_modules/.package-lock.json ## the handouts as web pages: build/site/index.html (needs common/setup --check)
	@command -v cmark-gfm >/dev/null || { echo "cmark-gfm is missing; it comes with: common/setup --check" >&2; exit 1; }
	@node grader/site/build.mjs $(BUILD)/site

%/node_modules/.package-lock.json: %/package.json
	@command -v npm >/dev/null || { echo "npm is missing; it comes with: common/setup --check" >&2; exit 1; }
	cd $* && npm install --no-package-lock --no-audit --no-fund --loglevel=error && touch node_modules/.package-lock.json

skeletons: build ## make labs/ from solutions/
	@$(BUILD)/skeletons labs

pictures: build ## draw the pictures of the handouts: make pictures [LAB=03]
	@grader/pictures $(LAB)

table: build ## measure the scenes, prove the rubrics, and put both tables into grader/README.md
	@grader/table

test: build $(BUILD)/stability $(BUILD)/chart $(TESTS) $(HOSTILE) ## run all tests
	@grader/tests/run $(BUILD)

test-hostile: build $(HOSTILE) ## attacks on the grader, by both routes into the jail (part of test)
	@BUILD=$(BUILD) grader/tests/test_hostile.sh

sanitize: ## the tests under AddressSanitizer and UBSan, but for the proofs of rubrics and gates
	@$(MAKE) --no-print-directory BUILD=build-sanitize CFLAGS="-O1 -g" \
		SANITIZE="-fsanitize=address,undefined -fno-sanitize-recover=undefined" QUICK=1 test

check: build ## the gates: labs/ is up to date, formats, task ids, floors, sizes
	@grader/gates $(BUILD)

stability: build $(BUILD)/stability ## where each method breaks: all rows, and build/study/stability.html
	@$(BUILD)/stability $(ARGS)

bench: build $(BUILD)/bench_truth ## where the time goes: grading one lab, and the truth's rays
	@grader/bench $(BUILD)

HAS_STUDY := $(wildcard grader/chart.c)
study: $(if $(HAS_STUDY),build $(BUILD)/chart) ## chart speed against error: make study [LAB=05 [SUBMISSION=labs]] [ARGS=--quick]
	$(if $(HAS_STUDY),$(BUILD)/chart $(if $(LAB),--lab $(LAB)) $(if $(filter-out file,$(origin SUBMISSION)),--submission \
		$(SUBMISSION)) $(ARGS),@echo "make study measures the solutions; they are not in this kit: ask your course" >&2; exit 2)

chart: build $(BUILD)/chart ## measure the study anew and put its chart and its findings into README.md
	@grader/study/publish $(BUILD) $(ARGS)

.PHONY: bench-class
bench-class: build ## labs a minute of a class run, cold and known shaders, and how it grows: ARGS="--labs 05 --counts 50,800"
	@grader/bench_class $(BUILD) $(ARGS)

compile_commands.json: ## for editors and clang-tidy (needs bear)
	bear -- $(MAKE) -B build

kit: build ## pack the kit for students, without solutions: build/shadow-lab-kit.tar.gz [LAB=03: can grade only that]
	@grader/make_kit $(BUILD) $(LAB)

gradescope: ## pack the autograder for Gradescope: build/shadow-lab-gradescope.zip [LAB=03]
	@grader/make_gradescope $(BUILD) $(LAB)

reset: $(filter $(BUILD)/skeletons,$(TOOLS:%=$(BUILD)/%)) ## put a lab of labs/ back to the skeleton: make reset LAB=03
	@grader/reset $(LAB)

clean: ## remove what was built
	rm -rf $(BUILD)

help: ## list the targets
	@grep -hE '^[a-z_.-]+:.*## ' $(MAKEFILE_LIST) | sed -E 's/^([a-z_.-]+):.*## /\1\t/' | expand -t 24

$(BUILD)/include/glad/gl.h:
	glad --quiet --reproducible --out-path $(BUILD)/glad --api gl:core=4.1 --extensions '' c --debug
	glad --quiet --reproducible --out-path $(BUILD)/glad --api egl=1.5 \
		--extensions EGL_MESA_platform_surfaceless,EGL_KHR_no_config_context c --loader
	mkdir -p $(BUILD)/include && cp -r $(BUILD)/glad/include/. $(BUILD)/include
# What every lab.c begins with, compiled once: gcc takes half the time for a submission. The flags are those of grader/compile.c;
# given.h itself is only read when they are not.
$(BUILD)/include/given.h.gch: $(wildcard common/*.h) Makefile | $(BUILD)/include/glad/gl.h
	echo '#include "lab.h"' >$(@:.gch=)
	$(CC) -std=c11 -O0 -g -fPIC -D_GNU_SOURCE -DCGLM_ALL_UNALIGNED -Icommon -isystem $(BUILD)/include -o $@ $(@:.gch=)
	printf '#include "lab.h"\n#define GIVEN_NOT_PRECOMPILED\n' >$(@:.gch=)
$(BUILD)/glad/%.o: $(BUILD)/include/glad/gl.h
	$(CC) -O1 -w -I$(BUILD)/include -c -o $@ $(BUILD)/glad/src/$*.c
$(BUILD)/%.o: %.c | $(BUILD)/include/glad/gl.h
	@mkdir -p $(@D)
	$(CC) $(ALL_CFLAGS) -c -o $@ $<
$(ON_TRUTH): $(TRUTH)
$(ON_STUDY): $(STUDY)
$(BUILD)/stability: $(STABILITY)
$(BUILD)/test_curve: $(BUILD)/grader/stability/curve.o
$(ON_TRUTH): LIBS += -lembree3 -lpthread
$(filter $(BUILD)/test_%,$(ON_TRUTH)): $(BUILD)/grader/tests/truth_points.o
$(BUILD)/test_metrics: $(BUILD)/grader/truth/metrics.o
$(BUILD)/grader/score.o: CFLAGS += -O3 # the vectors halve what a picture costs
$(BUILD)/test_view: $(patsubst %,$(BUILD)/grader/window/%.o,compose knob_step orbit place state)
$(BUILD)/worker: $(WORKER) $(SERVERS) $(COMMON) $(GLAD) $(BUILD)/include/given.h.gch
	$(CC) $(SANITIZE) -rdynamic -o $@ $(filter %.o,$^) $(LIBS)
inside = $(patsubst %.c,$(BUILD)/%.o,$(wildcard grader/jail/inside/$(1)*.c))
$(INSIDE): override SANITIZE :=
$(BUILD)/jail_shim: $(call inside,shim)
	$(CC) $(STATIC) -o $@ $^ -lseccomp
$(WEAK): override SANITIZE :=
$(WEAK): $(BUILD)/weak_%: $(BUILD)/grader/tests/weak_%.o $(call inside,shim)
	$(CC) $(STATIC) -o $@ $(filter-out %/shim_$*.o,$^) -lseccomp
$(BUILD)/without: override SANITIZE :=
$(BUILD)/without: $(BUILD)/grader/tests/without.o
	$(CC) -o $@ $^ -lseccomp
$(BUILD)/hostile: $(BUILD)/grader/tests/hostile.o $(GRADER) $(NO_GL)
	$(CC) $(SANITIZE) -o $@ $^ $(LIBS)
$(BUILD)/test_jail: | $(WEAK)
$(BUILD)/jail_probe: $(call inside,probe) $(call inside,attack)
	$(CC) -o $@ $^ -lpthread -lrt
$(BUILD)/jail_unpack: $(call inside,unpack)
	$(CC) -o $@ $^ -larchive
$(TOOLS:%=$(BUILD)/%): $(BUILD)/%: $(BUILD)/grader/%.o $(GRADER) $(NO_GL)
	$(CC) $(SANITIZE) -o $@ $^ $(LIBS)
$(WINDOW): ALL_CFLAGS += $(shell pkg-config --cflags glfw3) -pthread
$(BUILD)/view: $(WINDOW) $(GRADER) $(COMMON) $(GLAD)
	$(CC) $(SANITIZE) -pthread -o $@ $^ $(LIBS) $(shell pkg-config --libs glfw3)
$(BUILD)/watch: $(WATCH) $(GRADER) $(NO_GL)
	$(CC) $(SANITIZE) -o $@ $^ $(LIBS)
$(TESTS): $(BUILD)/%: $(BUILD)/grader/tests/%.o $(BUILD)/grader/tests/witness.o $(GRADER) $(NO_GL)
	@mkdir -p $(@D)
	$(CC) $(SANITIZE) -o $@ $^ $(LIBS) -lcmocka

.PHONY: test-hostile kit gradescope sanitize build grade run watch progress trace site demo hint skeletons pictures table test check stability bench study chart compile_commands.json reset clean help
.SECONDARY:
-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
