# Shadow Lab. `make help` lists the targets; README.md tells the rest.
MAKEFLAGS += --no-builtin-rules
CC ?= gcc
ifeq ($(origin CC),default)
CC := gcc
endif
BUILD ?= build
SANITIZE ?=
PACKAGES := libpng jansson
WARNINGS := -std=c11 -Wall -Wextra -Wpedantic -Werror
CFLAGS ?= -O2 -g
ALL_CFLAGS := $(WARNINGS) $(CFLAGS) $(SANITIZE) -D_GNU_SOURCE -DCGLM_ALL_UNALIGNED -Icommon -Igrader \
	-isystem $(BUILD)/include $(shell pkg-config --cflags $(PACKAGES) 2>/dev/null) -MMD -MP
LIBS := $(shell pkg-config --libs $(PACKAGES) 2>/dev/null) -lm -ldl

COMMON := $(patsubst %.c,$(BUILD)/%.o,$(wildcard common/*.c))
GLAD := $(BUILD)/glad/gl.o $(BUILD)/glad/egl.o
TOOLS := grade frame skeletons prove
GRADER := $(patsubst %.c,$(BUILD)/%.o,$(filter-out grader/worker.c grader/stage_view.c $(TOOLS:%=grader/%.c),$(wildcard grader/*.c)))
NO_GL := $(patsubst %,$(BUILD)/common/%.o,check random image mesh scene scene_parts scenes context_kind) \
	$(patsubst %.c,$(BUILD)/%.o,$(wildcard common/scenes_*.c))
WORKER := $(BUILD)/grader/worker.o $(BUILD)/grader/stage_view.o

all: $(BUILD)/worker $(TOOLS:%=$(BUILD)/%)
$(BUILD)/include/glad/gl.h:
	glad --quiet --reproducible --out-path $(BUILD)/glad --api gl:core=4.1 --extensions '' c --debug
	glad --quiet --reproducible --out-path $(BUILD)/glad --api egl=1.5 \
		--extensions EGL_MESA_platform_surfaceless,EGL_KHR_no_config_context c --loader
	mkdir -p $(BUILD)/include && cp -r $(BUILD)/glad/include/. $(BUILD)/include
$(BUILD)/glad/%.o: $(BUILD)/include/glad/gl.h
	$(CC) -O1 -w -I$(BUILD)/include -c -o $@ $(BUILD)/glad/src/$*.c
$(BUILD)/%.o: %.c $(BUILD)/include/glad/gl.h
	@mkdir -p $(@D)
	$(CC) $(ALL_CFLAGS) -c -o $@ $<
$(BUILD)/worker: $(WORKER) $(COMMON) $(GLAD)
	$(CC) $(SANITIZE) -rdynamic -o $@ $^ $(LIBS)
-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
$(TOOLS:%=$(BUILD)/%): $(BUILD)/%: $(BUILD)/grader/%.o $(GRADER) $(NO_GL)
	$(CC) $(SANITIZE) -o $@ $^ $(LIBS)
