# How the programs are built: every room's objects in one archive, from which the linker takes what a program needs.
CC := gcc
CFLAGS ?= -O2 -g
SANITIZE ?=
PACKAGES := libpng jansson
ALL_CFLAGS = -std=c11 -Wall -Wextra -Wpedantic -Werror $(CFLAGS) $(SANITIZE) -fno-math-errno -D_GNU_SOURCE -DCGLM_ALL_UNALIGNED \
	-Icommon -Igrader -isystem $(BUILD)/include $(shell pkg-config --cflags $(PACKAGES)) -MMD -MP

# Rooms that need a package of their own are left out where it is missing: the truth (Embree) and what stands on it, the window (GLFW).
EMBREE := $(firstword $(foreach name,embree4 embree3,$(if $(wildcard $(addsuffix /include/$(name)/rtcore.h,/usr /usr/local /opt/homebrew)),$(name))))
GLFW := $(shell pkg-config --exists glfw3 && echo glfw3)
ON_TRUTH := truth study stability
ROOMS := $(filter-out programs tests $(if $(EMBREE),,$(ON_TRUTH)) $(if $(GLFW),,window),$(notdir $(patsubst %/,%,$(wildcard grader/*/))))
LIBS = $(shell pkg-config --libs $(PACKAGES) $(GLFW)) $(EMBREE:%=-l%) -lpthread -lm -ldl

objects = $(patsubst %.c,$(BUILD)/%.o,$(wildcard $(1)))
# The jail's own objects stand alone, and without a sanitizer: they lie in the worker, too, which forks into a jail.
inside = $(call objects,grader/jail/inside/$(1)*.c)
SECCOMP := $(if $(findstring /,$(shell $(CC) -print-file-name=libseccomp.a)),-l:libseccomp.a,-lseccomp)
GLAD := $(patsubst %,$(BUILD)/glad/%.o,gl egl)
# What a lab brings along lies in its folder: scenes*.c, predictions*.c, and study*.c, rows*.c and witness*.c where their rooms are. In a kit, which has
# no solutions, scenes and predictions lie elsewhere. Each file is told its lab, and the name of the table that it may define.
OURS := $(firstword $(wildcard solutions grader/recorded/scenes))
BRINGS := scenes predictions $(if $(filter study,$(ROOMS)),study) $(if $(filter stability,$(ROOMS)),rows)
brought = $(sort $(wildcard $(addprefix $(OURS)/[0-9][0-9]-*/,$(1)*.c)))
lab_id = $(firstword $(subst -, ,$(notdir $(patsubst %/,%,$(dir $(1))))))
lab_table = lab_$(call lab_id,$(1))_$(subst -,_,$(notdir $(basename $(1))))
LAB_FLAGS = -DLAB_ID='"$(call lab_id,$<)"' -DLAB_NUMBER=$(patsubst 0%,%,$(call lab_id,$<)) -DLAB_TABLE=$(call lab_table,$<)
LAB_OBJECTS := $(call objects,$(foreach kind,$(BRINGS),$(call brought,$(kind)))) $(patsubst %,$(BUILD)/tables/%.o,$(BRINGS))
COMMON := $(call objects,common/*.c common/scene/*.c) $(GLAD)
ROOM_OBJECTS := $(call objects,$(foreach room,$(filter-out worker,$(ROOMS)),grader/$(room)/*.c)) $(LAB_OBJECTS)
ARCHIVE := $(BUILD)/rooms.a
LINK = $(CC) $(SANITIZE) -o $@ $(1) -Wl,--as-needed $(ARCHIVE) $(LIBS)

PROGRAM_SOURCES := $(wildcard grader/programs/*.c)
MISSING := $(if $(EMBREE),,bench_truth truth_worker stability chart sweep record_study record_arena) $(if $(GLFW),,view)
PROGRAMS := $(addprefix $(BUILD)/,$(filter-out $(MISSING),$(basename $(notdir $(PROGRAM_SOURCES)))))
# The jail's own programs stand alone. The shim is static where the system has the archives, so that a process inside begins sooner.
INSIDE := $(patsubst %,$(BUILD)/jail_%,shim probe unpack)
STATIC := $(if $(findstring /,$(shell $(CC) -print-file-name=libseccomp.a)),-static)
TESTS := $(patsubst grader/tests/c/%.c,$(BUILD)/%,$(wildcard grader/tests/c/test_*.c))
witness = $(BUILD)/test_$(patsubst lab_%,%,$(call lab_table,$(1)))
WITNESSES := $(foreach file,$(call brought,witness),$(call witness,$(file)))
# Shims that are weakened on purpose, and other programs of the tests.
WEAK := $(patsubst %,$(BUILD)/weak_%,files filter limit)

# In a terminal one line counts the objects of all rooms that are not there yet. An error is written over it.
COUNTED := $(filter-out $(BUILD)/tables/% $(wildcard $(ROOM_OBJECTS) $(COMMON)),$(ROOM_OBJECTS) $(COMMON))
COUNTER := $(if $(V)$(filter dumb,$(TERM)),,$(if $(word 20,$(COUNTED)),$(shell test -t 2 && echo yes)))
count = $(if $(COUNTER),$(if $(filter $(1),$(COUNTED)),$(eval BEGUN += x)@printf $(COUNT_FORMAT) $(words $(BEGUN)) $(words $(COUNTED)) >&2))
COUNT_FORMAT = 'building the programs, once: %d of %d files\$(if $(word $(words $(COUNTED)),$(BEGUN)),n,r)'

programs: $(BUILD)/worker $(BUILD)/worker_address $(INSIDE) $(PROGRAMS)
tests: $(TESTS) $(WITNESSES) hostile-programs
hostile-programs: $(BUILD)/hostile $(BUILD)/without $(WEAK)
.PHONY: programs tests hostile-programs always
# Not of all files: what a package that was installed later brings would count as intermediate, and would not be built.
.SECONDARY: $(patsubst %,$(BUILD)/tables/%.c,$(BRINGS))

EGL_EXTENSIONS := EGL_MESA_platform_surfaceless,EGL_KHR_no_config_context,EGL_EXT_platform_base,EGL_EXT_platform_device
EGL_EXTENSIONS := $(EGL_EXTENSIONS),EGL_EXT_device_base,EGL_EXT_device_enumeration
$(BUILD)/include/glad/gl.h: grader/build.mk # which says what of EGL is asked for
	$(if $(COUNTER),,@echo "building the programs: this takes a minute or two, once")
	glad --quiet --reproducible --out-path $(BUILD)/glad --api gl:core=4.1 --extensions '' c --debug
	glad --quiet --reproducible --out-path $(BUILD)/glad --api egl=1.5 \
		--extensions $(EGL_EXTENSIONS) c --loader
	mkdir -p $(BUILD)/include && cp -r $(BUILD)/glad/include/. $(BUILD)/include
# What every lab.c begins with, compiled once: gcc takes half the time for a submission. given.h itself is only read when the
# compiler's flags are not those of lab.flags.
$(BUILD)/include/given.h.gch: $(wildcard common/*.h common/scene/*.h) common/lab.flags | $(BUILD)/include/glad/gl.h
	printf '#define LAB_WITHOUT_EARLIER\n#include "lab.h"\n' >$(@:.gch=)
	$(CC) @common/lab.flags -Icommon -Icommon/scene -isystem $(BUILD)/include -o $@ $(@:.gch=)
	printf '#define LAB_WITHOUT_EARLIER\n#include "lab.h"\n#define GIVEN_NOT_PRECOMPILED\n' >$(@:.gch=)
$(BUILD)/glad/%.o: $(BUILD)/include/glad/gl.h
	$(call count,$@)
	$(CC) -O1 -w -I$(BUILD)/include -c -o $@ $(BUILD)/glad/src/$*.c
$(BUILD)/%.o: %.c | $(BUILD)/include/glad/gl.h
	$(call count,$@)
	@mkdir -p $(@D)
	$(CC) $(ALL_CFLAGS) -c -o $@ $<
$(call objects,grader/window/*.c grader/programs/view.c): ALL_CFLAGS += $(shell pkg-config --cflags glfw3) -pthread
$(BUILD)/grader/score/score.o $(BUILD)/grader/worker/quantise.o: CFLAGS += -O3 # the vectors halve what a picture costs

$(BUILD)/$(OURS)/%.o: ALL_CFLAGS += $(LAB_FLAGS)
# The list of the tables of one kind, in the order of the labs. A file without a table helps another one.
TABLE_scenes := SceneMaker scene/scene_parts.h
TABLE_predictions := Prediction predict/prediction.h
TABLE_study := LabStudy study/study_scene.h
TABLE_rows := Row stability/row.h
tables = $(foreach file,$(shell grep -l 'LAB_TABLE\[\]' $(call brought,$(1)) /dev/null),$(call lab_table,$(file)))
$(BUILD)/tables/%.c: always
	@mkdir -p $(@D)
	@text=$$(printf '%s\n' '#include "$(lastword $(TABLE_$*))"' \
		$(foreach table,$(call tables,$*),'extern const $(firstword $(TABLE_$*)) $(table)[];') \
		'const $(firstword $(TABLE_$*)) *const $*_tables[] = {$(foreach table,$(call tables,$*),$(table), )NULL};'); \
	if ! cmp -s - $@ <<<"$$text"; then echo "$$text" >$@.new && mv $@.new $@; fi
$(BUILD)/tables/%.o: $(BUILD)/tables/%.c | $(BUILD)/include/glad/gl.h
	$(CC) $(ALL_CFLAGS) -c -o $@ $<
always:

$(ARCHIVE): $(ROOM_OBJECTS) $(COMMON)
	@rm -f $@ && ar rcs $@ $^
$(PROGRAMS): $(BUILD)/%: $(BUILD)/grader/programs/%.o $(ARCHIVE)
	$(call LINK,$<)
# A lab finds in the worker that loads it what all labs are given, and beside itself, in a library, what it is given of earlier labs
# (common/GIVEN).
HELPERS := $(filter %.h,$(shell grep '^[0-9]' common/GIVEN))
HELPERS := $(filter $(wildcard common/*.c common/scene/*.c),$(patsubst %.h,common/%.c,$(HELPERS)))
HELPER_OBJECTS := $(patsubst common/%.c,$(BUILD)/given/objects/%.o,$(HELPERS))
GIVEN := $(patsubst %,$(BUILD)/given/%/given.so,$(sort $(foreach folder,$(wildcard labs/[0-9]* solutions/[0-9]*),$(call lab_id,$(folder)/))) all)
$(HELPER_OBJECTS): $(BUILD)/given/objects/%.o: common/%.c | $(BUILD)/include/glad/gl.h
	@mkdir -p $(@D)
	$(CC) $(ALL_CFLAGS) -fPIC -c -o $@ $<
$(GIVEN): $(BUILD)/given/%/given.so: common/GIVEN common/earlier.h grader/compile/given $(HELPER_OBJECTS)
	@CC="$(CC)" SANITIZE="$(SANITIZE)" grader/compile/given $(BUILD) $*
$(BUILD)/given/exports: $(filter-out $(patsubst %.c,$(BUILD)/%.o,$(HELPERS)),$(COMMON))
	@mkdir -p $(@D)
	@{ echo '{'; nm -g --defined-only $^ | awk 'NF == 3 { print $$3 ";" }'; echo '};'; } >$@
$(BUILD)/worker: $(call objects,grader/worker/*.c) $(call inside,shim_) $(COMMON) $(ARCHIVE) $(BUILD)/include/given.h.gch $(BUILD)/given/exports $(GIVEN)
	$(CC) $(SANITIZE) -Wl,--dynamic-list=$(BUILD)/given/exports -o $@ $(filter %.o,$^) -Wl,--as-needed $(ARCHIVE) $(LIBS) $(SECCOMP)
# The same for a lab that is compiled with AddressSanitizer; empty where its library is missing.
$(BUILD)/worker_address: $(BUILD)/worker
	@$(if $(SANITIZE),false,$(CC) -fsanitize=address -Wl,--dynamic-list=$(BUILD)/given/exports -o $@ $(call objects,grader/worker/*.c) \
		$(call inside,shim_) $(COMMON) -Wl,--as-needed $(ARCHIVE) $(LIBS) $(SECCOMP)) 2>$@.said || : >$@
	@rm -f $@.said
$(TESTS): $(BUILD)/%: $(BUILD)/grader/tests/c/%.o $(call objects,grader/tests/helpers/*.c) $(ARCHIVE)
	$(call LINK,$(filter %.o,$^)) -lcmocka
$(foreach file,$(call brought,witness),$(eval $(call witness,$(file)): $(BUILD)/$(file:.c=.o)))
$(WITNESSES): $(call objects,grader/tests/helpers/*.c) $(ARCHIVE)
	$(call LINK,$(filter %.o,$^)) -lcmocka
$(BUILD)/hostile: $(BUILD)/grader/tests/programs/hostile.o $(ARCHIVE)
	$(call LINK,$<)

$(INSIDE) $(WEAK) $(BUILD)/without $(call inside,): override SANITIZE :=
$(BUILD)/jail_shim: $(call inside,shim)
	$(CC) $(STATIC) -o $@ $^ -lseccomp
$(WEAK): $(BUILD)/weak_%: $(BUILD)/grader/tests/programs/weak_%.o $(call inside,shim)
	$(CC) $(STATIC) -o $@ $(filter-out %/shim_$*.o,$^) -lseccomp
$(BUILD)/without: $(BUILD)/grader/tests/programs/without.o
	$(CC) -o $@ $^ -lseccomp
$(BUILD)/test_jail: | $(WEAK)
$(BUILD)/jail_probe: $(call inside,attack)
	$(CC) -o $@ $^ -lpthread -lrt
$(BUILD)/jail_unpack: $(call inside,unpack)
	$(CC) -o $@ $^ -larchive

%/node_modules/.package-lock.json: %/package.json
	@command -v npm >/dev/null || { echo "npm is missing; it comes with: common/setup --more" >&2; exit 1; }
	cd $* && npm install --no-package-lock --no-audit --no-fund --no-update-notifier --loglevel=error 2>npm.log || \
		{ grep -m3 . npm.log; echo "npm could not fetch its packages: the network is needed for them, once"; exit 1; } >&2
	rm -f $*/npm.log && touch $*/node_modules/.package-lock.json

-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
