# Shadow Lab: what people call. README.md tells how to use it; `make help` lists the targets; grader/build.mk holds the rules.
MAKEFLAGS += --no-builtin-rules
# As many jobs as there are processors, where nobody says how many.
MAKEFLAGS += $(if $(filter 0,$(MAKELEVEL)),-j$(or $(shell nproc 2>/dev/null),2))
# One language for all tools, and no warning of a shell where that of the terminal is not installed.
SHELL := /usr/bin/env LC_ALL=C.UTF-8 bash
BUILD ?= build
LAB ?=
SUBMISSION ?= labs
ARGS ?=
LAB_OPERAND = $(if $(LAB),'$(LAB)')
LAB_OPTION = $(if $(LAB),--lab '$(LAB)')
RECORD = $(if $(filter labs,$(SUBMISSION)),--record)
SCRIPTS := grader/scripts

build: programs ## build everything (default)

# Where there are no solutions, as in the kit for students, the targets with ### are not.
TEACHERS := $(if $(wildcard solutions),,$(shell sed -nE 's/^([a-z_.-]+):.*### .*/\1/p' Makefile))
ABSENT := $(filter $(TEACHERS),$(MAKECMDGOALS))
$(if $(ABSENT),$(error make $(ABSENT) is not in this kit; make help lists what is))

# The marks of what can be started are lost in a .zip or on a disk of Windows; a disk may forbid all of it.
CAN_START := $(shell test -x $(SCRIPTS)/lay_out || { chmod +x common/setup $(SCRIPTS)/* grader/compile/given; test -x $(SCRIPTS)/lay_out; } && echo yes)
$(if $(CAN_START),,$(error no program can be started from this disk: copy this folder to a place of your own, and work there))

V ?=
ifeq ($(V),) # one wants to see what fails, and not hundreds of commands; make V=1 shows them
.SILENT:
endif

ifeq ($(wildcard solutions),)
# It brings no labs/, which would lie over what was solved in an older one.
$(if $(shell $(SCRIPTS)/lay_out >&2 || echo failed),$(error this kit cannot be used as it is))
endif

# Where nothing can be written, as on a read-only medium, gcc would only say so file by file.
IS_WRITABLE := $(shell test -w "$$(test -e '$(BUILD)' && echo '$(BUILD)' || dirname '$(BUILD)')" && echo yes)
BUILDS := $(filter-out help hint,$(or $(MAKECMDGOALS),build))
$(if $(IS_WRITABLE),,$(if $(BUILDS),$(error nothing can be written to $(BUILD)/ here: copy this folder to a place of your own, and work there)))

include grader/build.mk

grade: build ## grade a submission: make grade [LAB=03] [SUBMISSION=labs] [ARGS="--seed 1"]
	@$(BUILD)/grade $(LAB_OPTION) $(RECORD) $(ARGS) $(SUBMISSION) || [ $$? = 1 ] # 1: graded, but not all passed

report: build ## the same as a web page with pictures: make report [LAB=03]
	@ARGS="$(RECORD) $(ARGS)" $(SCRIPTS)/report_page $(BUILD) '$(LAB)' $(SUBMISSION)

watch: $(BUILD)/worker $(BUILD)/watch ## grade on save, with hints and progress: make watch [LAB=03]
	@$(BUILD)/watch $(LAB_OPTION) $(ARGS)

answer: $(BUILD)/watch ## of a lab that is done: its idea, the answers to its questions, what to try: make answer LAB=03
	@$(if $(LAB),,echo "which lab? make answer LAB=03" >&2; exit 2;) $(BUILD)/watch $(LAB_OPTION) --answer || [ $$? = 1 ]

predictions: $(BUILD)/watch ## the numbers to work out before a lab runs, your own ones: make predictions LAB=03
	@$(if $(LAB),,echo "which lab? make predictions LAB=03" >&2; exit 2;) $(BUILD)/watch $(LAB_OPTION) --predict $(SUBMISSION)

progress: $(BUILD)/watch ## how far am I in all labs?
	@$(BUILD)/watch --list

demo: build ### grade the labs as shipped, then the solutions
	$(BUILD)/grade labs || true
	$(BUILD)/grade solutions

run: build $(BUILD)/view ## open a lab in a window: make run LAB=05 [ARGS="--seed 2"]
	$(BUILD)/view $(LAB_OPTION) $(if $(filter-out labs,$(SUBMISSION)),--submission $(SUBMISSION)) $(ARGS)

hint: ## show the hints of a task: make hint TASK=3.2
	@$(SCRIPTS)/hint $(if $(TASK),'$(TASK)')

trace: $(BUILD)/worker $(BUILD)/frame ## record a frame of your lab for a frame debugger: make trace LAB=03 [TOOL=renderdoc] [SCENE="far floor"]
	@TOOL="$(TOOL)" SCENE="$(SCENE)" $(SCRIPTS)/trace $(LAB_OPERAND)

showcase: build ## all pictures that your labs draw, points and mistakes met, on one page: build/showcase.html
	@$(SCRIPTS)/showcase $(BUILD) $(SUBMISSION)

reset: $(filter $(BUILD)/skeletons,$(PROGRAMS)) ## put a lab of labs/ back to the skeleton: make reset LAB=03
	@$(SCRIPTS)/reset $(LAB_OPERAND)

hand-in: $(filter $(BUILD)/skeletons,$(PROGRAMS)) ## pack what you hand in, of all labs that you began: make hand-in [LAB=03]
	@$(SCRIPTS)/hand_in $(LAB_OPERAND)

site: grader/site/node_modules/.package-lock.json ## the handouts as web pages: build/site/index.html (needs common/setup --more)
	@command -v cmark-gfm >/dev/null || { echo "cmark-gfm is missing; it comes with: common/setup --more" >&2; exit 1; }
	@node grader/site/build.mjs $(BUILD)/site

skeletons: build ### make labs/ from solutions/
	@$(BUILD)/skeletons labs

new-lab: ### begin a new lab from a template: make new-lab LAB=09 NAME="soft shadows"
	@mkdir -p $(BUILD)
	@$(SCRIPTS)/new_lab $(BUILD) "$$LAB" "$$NAME" # from the environment, as they are

pictures: build ### draw the pictures of the handouts: make pictures [LAB=03]
	@$(SCRIPTS)/pictures $(LAB_OPERAND)

diagrams: ### draw the diagrams of the handouts: make diagrams [LAB=03] (needs node); then make skeletons
	@node grader/site/diagrams.mjs $(LAB_OPERAND)

frames: build $(BUILD)/sweep ### draw the labs over a knob, for sliders on the site: make frames [LAB=04]; then make site
	@node grader/site/frames.mjs $(LAB_OPERAND)

contexts: build ### do OSMesa and EGL give the same verdicts on the whole catalogue? make contexts [LAB=03]
	@$(SCRIPTS)/contexts $(BUILD) $(LAB_OPERAND)

table: build ### measure the scenes, prove the rubrics, try all mutants, and put the tables into grader/proof/
	@$(SCRIPTS)/table

mutants: build ### does each rubric notice every small change of its solution? make mutants [LAB=03] [ARGS="--seeds 3"]
	$(BUILD)/mutants $(LAB_OPTION) $(ARGS)

test: build tests ### run all tests
	@grader/tests/run $(BUILD)

test-hostile: build hostile-programs ### attacks on the grader, by both routes into the jail (part of test)
	@BUILD=$(BUILD) grader/tests/shell/test_hostile.sh

sanitize: ### the tests under AddressSanitizer and UBSan, but for the proofs of rubrics and gates
	@$(MAKE) --no-print-directory BUILD=build-sanitize CFLAGS="-O1 -g" \
		SANITIZE="-fsanitize=address,undefined -fno-sanitize-recover=undefined" QUICK=1 test

check: build ### the gates: labs/ is up to date, formats, task ids, floors, sizes
	@$(SCRIPTS)/gates $(BUILD)

stability: build $(BUILD)/stability ### where each method breaks: all rows, and build/study/stability.html
	@$(BUILD)/stability $(ARGS)

bench: build $(BUILD)/bench_truth ### where the time goes: grading one lab, and the truth's rays
	@$(SCRIPTS)/bench $(BUILD)

bench-class: build ### labs a minute of a class run, cold and known shaders, and how it grows: ARGS="--labs 05 --counts 50,800"
	@$(SCRIPTS)/bench_class $(BUILD) $(ARGS)

# A kit has no study of its own, but points that were recorded of it.
HAS_STUDY := $(wildcard grader/study)
study: build $(if $(HAS_STUDY),$(BUILD)/chart) ## chart speed against error: make study LAB=05 SUBMISSION=labs
	$(if $(HAS_STUDY),$(BUILD)/chart $(LAB_OPTION) $(if $(filter-out file,$(origin SUBMISSION)),--submission $(SUBMISSION)) \
		$(ARGS),@$(SCRIPTS)/study_page $(BUILD) '$(LAB)' $(SUBMISSION))

compete: build ## rank methods by what they cost, without times: make compete LAB=14 [SUBMISSION=labs | CLASS=DIR] [SEED=N]
	@SEED='$(SEED)' CLASS='$(CLASS)' ARGS='$(ARGS)' $(SCRIPTS)/compete $(BUILD) '$(LAB)' $(SUBMISSION)

chart: build $(BUILD)/chart ### measure the study again and put its chart and its findings into README.md
	@$(SCRIPTS)/publish_chart $(BUILD) $(ARGS)

compile_commands.json: ### for editors and clang-tidy (needs bear)
	bear -- $(MAKE) -B build

kit: build ### pack the kit for students, without solutions: build/shadow-lab-kit.tar.gz [LAB=03: can grade only that]
	@$(SCRIPTS)/make_kit $(BUILD) $(LAB_OPERAND)

gradescope: ### pack the autograder for Gradescope: build/shadow-lab-gradescope.zip [LAB=03]; with SEED=N (LAB=14) its leaderboard, too
	@CONTEST='$(SEED)' $(SCRIPTS)/make_gradescope $(BUILD) $(LAB_OPERAND)

clean: ## remove what was built
	rm -rf $(BUILD)

help: ## list the targets
	@grep -hE '^[a-z_.-]+:.* ##$(if $(wildcard solutions),#?) ' Makefile | sed -E 's/^([a-z_.-]+):.*## /\1 /' | awk '{ \
		line = sprintf("%-13s", $$1); full = length($$0) > 66; \
		for (i = 2; i <= NF; i++) { \
			if (length(line $$i) > 78 || full && $$i == "make" && $$(i - 1) ~ /:$$/) { print line; line = sprintf("%13s", "") } \
			line = line " " $$i } \
		print line }'

# No file is made under these names.
.PHONY: $(filter-out compile_commands.json,$(shell grep -oE '^[a-z-]+:' Makefile | tr -d :)) compile_commands.json
