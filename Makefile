# Twinlight's build. `make help` lists the targets; `make deps` installs what they need.
#
#   config=release|debug|sanitize   release builds into build/, the others into build/<config>/; `make fuzz` into build/fuzz/
#   units=rooms|files               compile each folder as one file (takes less than half the time), or each file by itself (debug)
#   CI=true                         warnings are errors
#   ALL_CASES=true                  the longest tests try all their cases, not a quarter of them

config ?= release
CXX ?= g++
$(if $(filter release debug sanitize fuzz,$(config)),,$(error config must be release, debug or sanitize, not '$(config)'))
units ?= $(if $(filter debug,$(config)),files,rooms)
$(if $(filter rooms files,$(units)),,$(error units must be rooms or files, not '$(units)'))
BUILD := $(if $(filter release,$(config)),build,build/$(config))
PROGRAMS := $(BUILD)

# Use every processor, unless the caller chose a number of jobs; a make within make shares its caller's jobs.
ifeq (0,$(MAKELEVEL)$(filter -j%,$(MAKEFLAGS)))
MAKEFLAGS += -j$(shell nproc 2>/dev/null || echo 2)
endif
MAKEFLAGS += --no-print-directory --no-builtin-rules
# Several goals that a person gives (make clean test) run one after the other.
ifneq (,$(and $(filter 0,$(MAKELEVEL)),$(word 2,$(MAKECMDGOALS))))
.NOTPARALLEL:
endif

# ---- Required packages: one line each, "apt package, command that succeeds if it is installed" -------------------
# Ubuntu has chromium and firefox as snaps only: there the tests that open a page are skipped.

# Whether clang has libFuzzer's runtime.
try_fuzzer := echo 'extern "C" int LLVMFuzzerTestOneInput(char*, int) { return 0; }' | \
    clang++ -x c++ -fsanitize=fuzzer,address - -o /dev/null

# Mesa 25.1 was the last with OSMesa. Only running needs it, not compiling.
has_library = /sbin/ldconfig -p | grep -q
apt_has_osmesa := apt-cache policy libosmesa6 2>/dev/null | grep -q "Candidate: [^(]"

define DEPENDENCIES
g++                 command -v $(CXX)
pkg-config          command -v pkg-config
libosmesa6|libegl-mesa0 $(has_library) libOSMesa.so.8 || { $(has_library) libEGL_mesa.so.0 && ! $(apt_has_osmesa); }
libegl-dev          pkg-config --exists egl
libglu1-mesa-dev    pkg-config --exists glu
freeglut3-dev       pkg-config --exists glut
libglm-dev          pkg-config --exists glm
libcli11-dev        pkg-config --exists CLI11
nlohmann-json3-dev  pkg-config --exists nlohmann_json
libfmt-dev          pkg-config --exists fmt
libstb-dev          pkg-config --exists stb
libdeflate-dev      pkg-config --exists libdeflate
libxsimd-dev        pkg-config --exists xsimd
libboost-dev        ls /usr/include/boost/multiprecision/cpp_bin_float.hpp
libtinyobjloader-dev pkg-config --exists tinyobjloader
libimgui-dev        pkg-config --exists imgui
fonts-dejavu-core   ls /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
fonts-droid-fallback ls /usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf
libjs-chart.js      ls /usr/share/javascript/chart.js
libgtest-dev        pkg-config --exists gtest_main
xvfb                command -v Xvfb
xdotool             command -v xdotool
xclip               command -v xclip
apitrace            command -v apitrace
mesa-utils          command -v glxgears
$(if $(CI),python3-opengl      /usr/bin/python3 -c 'import OpenGL.GLUT')
$(if $(filter real,$(BENCH)),xscreensaver-gl        ls /usr/libexec/xscreensaver/endgame)
$(if $(filter real,$(BENCH)),xscreensaver-gl-extra  ls /usr/libexec/xscreensaver/atlantis)
$(if $(filter real,$(BENCH)),crack-attack           PATH=$$PATH:/usr/games command -v crack-attack)
$(if $(CI),valgrind            command -v valgrind)
$(if $(CI),strace              command -v strace)
$(if $(CI),clang               command -v clang++)
$(if $(CI),libclang-rt-dev     $(try_fuzzer))
$(if $(CI),chromium            command -v chromium || grep -q ubuntu /etc/os-release)
$(if $(CI),glslang-tools       command -v glslangValidator)
$(if $(CI),firefox-esr         command -v firefox-esr || grep -q ubuntu /etc/os-release)
$(if $(CI),debootstrap         command -v debootstrap || ls /usr/sbin/debootstrap)
$(if $(CI)$(filter web release,$(MAKECMDGOALS)),emscripten          command -v em++)
$(if $(CI)$(filter web release,$(MAKECMDGOALS)),node-acorn          ls /usr/share/nodejs/acorn)
$(if $(CI)$(filter web release,$(MAKECMDGOALS)),libjs-codemirror    ls /usr/share/javascript/codemirror)
$(if $(CI)$(filter web release,$(MAKECMDGOALS)),esbuild             command -v esbuild)
$(if $(CI)$(filter web release,$(MAKECMDGOALS)),zip                 command -v zip)
$(if $(CI)$(filter slides,$(MAKECMDGOALS)),cmark-gfm           command -v cmark-gfm)
$(if $(CI),man-db              command -v man)
$(if $(CI),zsh                 command -v zsh)
$(if $(CI),fish                command -v fish)
$(if $(CI)$(filter deb release,$(MAKECMDGOALS)),dpkg-dev            command -v dpkg-shlibdeps)
$(if $(CI)$(filter release,$(MAKECMDGOALS)),mandoc              command -v mandoc)
endef
export DEPENDENCIES

# ---- Flags ------------------------------------------------------------------------------------------------------

MODULES := glm fmt CLI11 nlohmann_json stb libdeflate tinyobjloader imgui
GCC := $(shell $(CXX) -dumpversion 2>/dev/null)
WARNINGS := -Wall -Wextra -Wpedantic -Wshadow $(if $(CI),-Werror)
# False alarms of g++ 13 and 14 about copies in the standard library and in fmt.
WARNINGS += $(if $(filter 13,$(GCC)),-Wno-array-bounds -Wno-stringop-overflow) $(if $(filter 14,$(GCC)),-Wno-free-nonheap-object -Wno-maybe-uninitialized)
# clang counts the letters of embedded files, and does not know all of g++'s warnings.
WARNINGS += $(if $(findstring clang,$(CXX)),-Wno-overlength-strings -Wno-unknown-warning-option)
# The reference is compared bit by bit across builds: no contraction of a*b+c behind the source's back.
CXXFLAGS_common := -std=c++20 -ffp-contract=off $(WARNINGS) -Isrc -DGL_GLEXT_PROTOTYPES
CXXFLAGS_release := -O2
# For what no picture waits for: rooms without a loop over pixels, vertices or commands. It compiles in three quarters of the time.
# (At -Og g++ 12 sees copies beyond a std::string's own buffer where there are none, and takes std::regex for uninitialised.)
OPTIMISATION_less := $(if $(filter release,$(config)),-Og -Wno-array-bounds -Wno-stringop-overflow -Wno-maybe-uninitialized)
# Tests compile in 85 % of the time without optimisation, and run as fast.
OPTIMISATION_none := -O0
CXXFLAGS_debug := -O0 -g
# For src/lighting/points.h, which lights many points at once on processors that have these instructions.
INSTRUCTIONS_points_avx2 := -mavx2 -mfma
# (g++ 12's own header leaves some values undefined on purpose, and g++ warns about them.)
INSTRUCTIONS_points_avx512 := -mavx512f -mavx512cd -mavx512dq -mavx512bw -mavx512vl -Wno-uninitialized -Wno-maybe-uninitialized
# What the tests need of these instructions.
INSTRUCTIONS_lane_results_avx2 := $(INSTRUCTIONS_points_avx2)
INSTRUCTIONS_lane_results_avx512 := $(INSTRUCTIONS_points_avx512)
INSTRUCTIONS = $(if $(filter x86_64%,$(MACHINE)),$(INSTRUCTIONS_$(basename $(@F))))
MACHINE := $(shell $(CXX) -dumpmachine 2>/dev/null)
# -g1 is enough for line numbers in the sanitizers' reports, and compiles up to a third faster than -g. clang needs half of g++'s time, but
# only without optimisation.
# With the address sanitizer, g++ 12 warns wrongly that std::regex is uninitialised.
CXXFLAGS_sanitize := $(if $(findstring clang,$(CXX)),-O0,-Og -Wno-maybe-uninitialized) -g1 -fno-omit-frame-pointer \
    -fsanitize=address,undefined -fno-sanitize-recover=undefined
LDFLAGS_sanitize := -fsanitize=address,undefined
# For clang's libFuzzer, whose runtime is a package of its own (Debian: libclang-rt-dev).
CXXFLAGS_fuzz := -O1 -g1 -fno-omit-frame-pointer -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined
LDFLAGS_fuzz := -fsanitize=address,undefined
CXXFLAGS_all = $(CXXFLAGS_common) $(CXXFLAGS_$(config)) $(shell pkg-config --cflags $(MODULES) 2>/dev/null) $(CXXFLAGS)
CXXFLAGS_all := $(CXXFLAGS_all)
# A large room takes g++ a fifth longer if it stops to collect its memory. Without that it needs 1.3 GB at most instead of 1.
compile := $(CXX) $(if $(findstring clang,$(CXX)),,--param ggc-min-heapsize=1000000)
LDFLAGS_all := $(LDFLAGS_$(config)) $(LDFLAGS)
LIBS := $(shell pkg-config --libs fmt stb libdeflate 2>/dev/null)
# GL is loaded while the program runs. The program exports functions of GL's names, so that GLU's calls reach that library.
LIBS_offscreen := -Wl,--export-dynamic-symbol='gl[A-Z]*' $(shell pkg-config --libs glu 2>/dev/null)
LIBS_fuzz := $(shell pkg-config --libs fmt libdeflate 2>/dev/null)
LIBS_window := $(shell pkg-config --libs glut imgui glu gl x11 2>/dev/null)
LIBS_gtest := $(shell pkg-config --libs gtest_main 2>/dev/null)

# ---- Files ------------------------------------------------------------------------------------------------------

# The GL of programs without a window.
SOURCES_offscreen := src/render/context/offscreen.cpp
SOURCES_library := $(filter-out src/app/% $(SOURCES_offscreen),$(sort $(shell find src -name '*.cpp')))
SOURCES_app := $(wildcard src/app/*.cpp)
# What src/app needs: the commit and the versions of the libraries, for --version.
OBJECT_version := $(BUILD)/embedded/version.o
# The errors of a recording that the window has asked for, in its language.
SOURCES_language := src/app/session/language.cpp
SOURCES_cli := $(SOURCES_app) $(SOURCES_language) $(wildcard src/app/cli/*.cpp)
# The tests link what carries out a command line, too.
SOURCES_subcommands := $(filter-out %/main.cpp,$(SOURCES_cli))
# The window's state, without GL; the tests link it, too.
SOURCES_session := $(wildcard src/app/session/*.cpp)
# The page for browsers, without GL and JavaScript; the tests link it, too.
SOURCES_web := $(filter-out src/app/web/module.cpp,$(wildcard src/app/web/*.cpp))
SOURCES_demo := $(SOURCES_app) $(SOURCES_session) $(wildcard src/app/demo/*.cpp)
SOURCES_bench := $(wildcard tests/bench/*.cpp)
SOURCES_bench_library := $(addprefix src/app/cli/,progress.cpp machine.cpp renderers.cpp)
# The tests link these too: they count the instructions of the same meshes.
SOURCES_bench_meshes := tests/bench/lit_spheres.cpp
# Each fuzzer is a program. They link the parts of the library that read untrusted input, without drivers and reports.
SOURCES_fuzzers := $(wildcard tests/fuzz/*_fuzzer.cpp)
SOURCES_fuzz_common := tests/fuzz/command_bytes.cpp tests/fuzz/stb.cpp
SOURCES_fuzz_seeds := tests/fuzz/write_seeds.cpp
SOURCES_fuzz := $(SOURCES_fuzzers) $(SOURCES_fuzz_common) $(SOURCES_fuzz_seeds)
SOURCES_fuzz_library := $(filter-out src/judge/% $(addsuffix /%,$(addprefix src/render/,context stages fixed programmable webgl webgpu)),$(SOURCES_library))
# The tables of bad input; with the sanitizers they are a program of their own.
SOURCES_bad_input := tests/property/bad_input_test.cpp
SOURCES_recorder := $(wildcard tests/window/recorder/*.cpp)
SOURCES_tests := $(filter-out $(SOURCES_bench) $(SOURCES_fuzz) $(SOURCES_recorder),$(sort $(shell find tests -name '*.cpp' -not -path 'tests/recorded/*')))
# The folders of tests that are built; all of them without FOLDERS=.
SOURCES_some_tests := $(if $(FOLDERS),$(filter $(FOLDERS:%=%/%),$(SOURCES_tests)),$(SOURCES_tests))
SOURCES_all := $(sort $(SOURCES_library) $(SOURCES_offscreen) $(SOURCES_cli) $(SOURCES_demo) $(SOURCES_web) $(SOURCES_tests) $(SOURCES_recorder) \
    $(SOURCES_bench) $(SOURCES_fuzz))
HEADERS := $(sort $(shell find src tests -name '*.h'))
EMBEDDED := $(patsubst %,$(BUILD)/embedded/%.cpp,scenes scene_assets shaders webgl pages cases conformance lessons lessons-zh tutors recorder)
# The scenes that only tests need come last.
SCENES_of_tests := $(patsubst %,src/scene/scenes/%.gl,commands legacy)
FILES_scenes := $(sort $(filter-out $(SCENES_of_tests),$(wildcard src/scene/scenes/*.gl))) $(SCENES_of_tests)
# What the scenes load: pictures, and meshes with their materials.
FILES_scene_assets := $(wildcard $(addprefix src/scene/scenes/*.,png obj mtl))
FILES_recorder := src/scene/record/python_lines.py
FILES_shaders := $(wildcard $(patsubst %,src/render/programmable/%,shaders/*.glsl export/*.glsl export/*.c export/gl_state.h export/scene.h export/names.sed))
FILES_webgl := $(addprefix src/render/webgl/,exported_page.html gl.js labels.js terms.js theme.css theme.js viewer.js webgpu.html)
# Chart.js as a browser loads it: version 3 has chart.min.js, version 4 chart.umd.js.
CHART := $(firstword $(wildcard $(addprefix /usr/share/javascript/chart.js/,chart.umd.min.js chart.umd.js chart.min.js)))
FILES_cases := $(wildcard golden/hard/*.gl)
FILES_conformance := $(sort $(wildcard src/judge/conformance/suite/*))
FILES_tutors := $(wildcard src/app/session/tutors/*.gl)
FILES_lessons := $(filter-out %/README.md,$(wildcard docs/lessons/*.md))
FILES_lessons_zh := $(filter-out %/README.md,$(wildcard docs/zh-CN/lessons/*.md))
FILES_pages := $(wildcard src/judge/report/pages/*) $(BUILD)/embedded/chart.js

# With units=rooms, each folder of src/ and tests/ (a room) is one translation unit, which reads its headers once. ALONE lists the
# files that are compiled by themselves.
ifeq ($(units),files)
ALONE := %.cpp
else
# Some programs link these without the rest of their room, or the rest without these.
ALONE := src/app/cli/main.cpp $(SOURCES_language) $(SOURCES_offscreen) $(SOURCES_bench_library) $(SOURCES_bench_meshes) $(SOURCES_fuzz) $(SOURCES_bad_input)
# These have their own flags (INSTRUCTIONS_...).
ALONE += src/lighting/points_avx%.cpp tests/unit/lighting/lane_results_avx%.cpp
# All memory of the tests comes through this, so it is optimised.
ALONE += tests/unit/app/refused_memory.cpp
# With this in its room, g++ would no longer inline some of what reads a scene.
ALONE += src/scene/command/loop_length.cpp
# This calls so many of the equation's functions that g++ would no longer inline them where pictures are lit.
ALONE += src/render/reference/pixel_history.cpp
# Only Emscripten compiles this.
ALONE += src/app/web/module.cpp
endif
ROOMS := $(patsubst %/,%,$(sort $(dir $(filter-out $(ALONE),$(SOURCES_all)))))
objects_of = $(sort $(patsubst %.cpp,$(BUILD)/objects/%.o,$(filter $(ALONE),$(1))) \
    $(patsubst %,$(BUILD)/objects/%.room.o,$(patsubst %/,%,$(dir $(filter-out $(ALONE),$(1))))))
# PLAIN=ROOMS: the objects of these rooms are those of `make programs`, whatever the config.
plain := $(PLAIN:%=$(BUILD)/objects/src/%.room.o)
plain_objects := $(PLAIN:%=build/objects/src/%.room.o)
object = $(filter-out $(plain),$(objects_of)) $(patsubst $(BUILD)/%,build/%,$(filter $(plain),$(objects_of)))
# The rooms that are optimised less.
LESS := $(patsubst %,src/%,app app/cli app/demo app/session app/web judge/check judge/conformance judge/explain judge/fuzz judge/lesson judge/lint \
    judge/report judge/study render/programmable/export render/webgl render/webgpu scene/scenes) tests/instructions
# What is not optimised: the other tests.
UNOPTIMISED := $(if $(filter release,$(config)), \
    $(filter-out $(LESS),$(patsubst %/,%,$(sort $(dir $(SOURCES_tests))))) $(SOURCES_bad_input:.cpp=))
unoptimised := $(foreach ending,o room.o,$(UNOPTIMISED:%=$(BUILD)/objects/%.$(ending)))
optimisation = $(if $(filter $(LESS),$*),$(OPTIMISATION_less))$(if $(filter $(UNOPTIMISED),$*),$(OPTIMISATION_none))
OBJECTS_embedded := $(EMBEDDED:.cpp=.o)
OBJECTS_library := $(call object,$(SOURCES_library)) $(OBJECTS_embedded)
# Programs without a window link this as well as their own objects.
OFFSCREEN := $(call object,$(SOURCES_offscreen)) $(BUILD)/objects/entry_points.o $(OBJECTS_library)
# What changes twinlight's pictures: all but its commit.
OBJECTS_cli := $(call object,$(SOURCES_cli)) $(OFFSCREEN)

.PHONY: all deps demo test test-binary build-tests bench fuzz bad-input nightly gallery slides programs golden tables instructions format check headers tidy clean help force
.DEFAULT_GOAL := all
.DELETE_ON_ERROR:

all: deps
	@$(MAKE) programs

programs: $(PROGRAMS)/twinlight $(PROGRAMS)/twinlight-demo
test-binary: $(PROGRAMS)/twinlight-tests $(PROGRAMS)/shape-recorder programs

demo: deps  ## build, then open the window; without a display, write a comparison report instead
	@if [ -n "$$DISPLAY" ]; then \
	    $(MAKE) $(PROGRAMS)/twinlight-demo || exit; \
	    nice $(MAKE) programs >$(BUILD)/programs.log 2>&1 & \
	    $(PROGRAMS)/twinlight-demo $(SCENE); status=$$?; \
	    [ -e $(PROGRAMS)/twinlight ] || echo "$(PROGRAMS)/twinlight is still being compiled."; \
	    wait; $(MAKE) programs && exit $$status; else \
	    $(MAKE) programs || exit; \
	    echo "There is no display (DISPLAY is not set): writing a comparison report of the scene 'report' instead."; \
	    mkdir -p build/report && $(PROGRAMS)/twinlight compare report -o build/report && \
	    echo "Open build/report/index.html in a browser."; fi

# What `make test` needs. The page's last step leaves a processor free, so the page comes first.
page = $(if $(shell command -v $(EMXX)),$(FILES_web))
build-tests:
ifeq ($(config),release)
	@$(MAKE) $(page) test-binary
else
	@$(if $(page),$(MAKE) config=release web)
	@$(MAKE) test-binary
endif

test_environment := LSAN_OPTIONS=suppressions=$(CURDIR)/tests/leaks_of_drivers.supp:print_suppressions=0 \
    $(if $(ALL_CASES),ALL_CASES=$(ALL_CASES))
test: deps  ## build, then run every test; needs no display (TEST='Spot*' runs some; FOLDERS='tests/golden' builds only those of some folders)
	@$(MAKE) build-tests
	@$(test_environment) TWINLIGHT_BUILD=$(PROGRAMS) \
	    tests/run.sh $(PROGRAMS)/twinlight-tests '$(or $(TEST),*)'

bench: deps  ## measure speed: print medians, write ratios to build/bench.json (BENCH=Regex runs some, QUICK=1 runs each once)
	@$(if $(filter real,$(BENCH)),[ -d $(BUILD)/recorded ] || tests/traces/record.sh -m -o $(BUILD)/recorded || [ $$? -eq 1 ])
	@$(MAKE) $(PROGRAMS)/twinlight-demo
	@$(MAKE) $(PROGRAMS)/twinlight-bench
	@TWINLIGHT_BUILD=$(PROGRAMS) $(PROGRAMS)/twinlight-bench $(if $(QUICK),--quick) '$(or $(BENCH),.)'

# Each target starts from seeds and from the corpus of earlier runs. clang warns about other things than g++, so CI=true
# (warnings are errors) is not passed on.
TIME ?= 60
fuzz_targets := $(patsubst tests/fuzz/%_fuzzer.cpp,%,$(SOURCES_fuzzers))
fuzz: deps  ## look for crashes on random input (TIME=seconds per target; TARGET=scene|dump|trace|png|obj|state|picture for one)
	@if ! { $(try_fuzzer); } 2>/dev/null; then \
	    echo "fuzz: skipped, because clang++ or its fuzzer runtime is not installed (Debian packages clang and libclang-rt-dev)"; exit 0; fi; \
	$(MAKE) config=fuzz CXX=clang++ CI= $(patsubst %,build/fuzz/%-fuzzer,$(or $(TARGET),$(fuzz_targets))) build/fuzz/write-seeds && \
	printf '%s\n' $(or $(TARGET),$(fuzz_targets)) | xargs -P $$(nproc) -I TARGET tests/fuzz/run.sh TARGET $(TIME)

# No row of tests/bad_input comes as far as these rooms (valgrind --tool=callgrind shows which it calls), so they need no sanitizers here.
# (make check has them with sanitizers.)
UNREACHED := $(addprefix judge/,conformance explain fuzz lesson oracle report) render/webgl render/webgpu
try_sanitizers := echo 'int main() {}' | clang++ -x c++ -fsanitize=address,undefined - -o /dev/null 2>/dev/null
bad-input: deps  ## try each row of tests/bad_input under the address and undefined-behaviour sanitizers (by clang, where it has them)
	@$(MAKE) config=release $(UNREACHED:%=build/objects/src/%.room.o)
	@if $(try_sanitizers); then CXX=clang++; else CXX=$(CXX); fi; \
	$(MAKE) config=sanitize CXX=$$CXX PLAIN='$(UNREACHED)' PROGRAMS=build/sanitize/input build/sanitize/input/twinlight build/sanitize/input/bad-input
	@$(test_environment) TWINLIGHT_BUILD=build/sanitize/input tests/run.sh build/sanitize/input/bad-input

nightly:  ## what takes too long for each change, on all five systems (PART='fuzz noble' runs some)
	@tools/nightly.sh $(PART)

gallery: deps  ## draw all scenes and their steps with every renderer: build/gallery/index.html (SCENES='lab report' draws some)
	@$(MAKE) $(PROGRAMS)/twinlight
	@tools/gallery.sh $(PROGRAMS)/twinlight build/gallery $(SCENES)

slides: deps  ## the lecture as slides with live pictures, for a projector: build/slides/index.html
	@$(MAKE) $(PROGRAMS)/twinlight
	@tools/slides/slides.sh $(PROGRAMS)/twinlight build/slides

deps:  ## install missing packages with apt; build nothing
	@tools/deps.sh

golden: deps  ## rewrite the golden pictures (CASE=scene for one); look at each before you commit it
	@$(MAKE) test-binary
	@TWINLIGHT_BUILD=$(PROGRAMS) TWINLIGHT_WRITE_GOLDEN='$(or $(CASE),*)' $(PROGRAMS)/twinlight-tests --gtest_filter='*GoldenScenes*:*GoldenHomework*:GoldenShaders*'

tables: deps  ## rewrite the tables of docs/hard-cases.md and docs/driver.md after a change of cases, rulings or known differences
	@$(MAKE) test-binary
	@TWINLIGHT_BUILD=$(PROGRAMS) TWINLIGHT_WRITE_TABLES=1 $(PROGRAMS)/twinlight-tests --gtest_brief=1 --gtest_filter='DocsTables*'

instructions: deps  ## recount the instructions in tests/instructions after an intended change
	@$(MAKE) test-binary
	@TWINLIGHT_BUILD=$(PROGRAMS) TWINLIGHT_WRITE_INSTRUCTIONS=1 $(PROGRAMS)/twinlight-tests --gtest_brief=1 --gtest_filter='Instructions*'

format:  ## format every source with clang-format
	clang-format -i $(SOURCES_all) $(HEADERS)

check:  ## check the format, compile each file by itself, run clang-tidy, and run every test under the address and undefined-behaviour sanitizers
	@if command -v clang-format >/dev/null; then \
	    clang-format --dry-run -Werror $(SOURCES_all) $(HEADERS); \
	    else echo "format: skipped, because clang-format is not installed"; fi
	@$(MAKE) headers
	@if command -v clang-tidy >/dev/null; then $(MAKE) tidy; \
	    else echo "tidy: skipped, because clang-tidy is not installed"; fi
	@$(MAKE) test config=sanitize units=files

# A source includes its own header first, so only headers without a source are compiled here. (Those of export/*.c are C; only Emscripten needs
# app/web/compat.)
HEADERS_alone := $(filter-out $(SOURCES_all:.cpp=.h) $(FILES_shaders) $(FILES_conformance) src/app/web/compat/%,$(HEADERS))
headers: deps  ## compile headers by themselves: each must include what it uses (units=files does so with sources)
	@$(MAKE) --keep-going $(HEADERS_alone:%=alone/%)
alone/%: %
	@$(CXX) $(CXXFLAGS_all) $(INSTRUCTIONS) -fsyntax-only -include $< -x c++ /dev/null

tidy: $(patsubst %,tidy/%,$(SOURCES_all))
tidy/%: % programs
	@clang-tidy --quiet $< -- $(CXXFLAGS_all) 2>/dev/null

clean:  ## remove build/
	rm -rf build

help:  ## show this list
	@grep -hE '^[a-z-]+:.*##' Makefile tools/install/install.mk src/app/web/web.mk | sed -E 's/:[^#]*## */\t/' | awk -F'\t' '{printf "  make %-12s %s\n", $$1, $$2}'

# ---- Installing: make install, uninstall, dist, deb, release ------------------------------------------------------------

include tools/install/install.mk

# ---- The page for browsers: make web -----------------------------------------------------------------------------

include src/app/web/web.mk

# ---- Rules ------------------------------------------------------------------------------------------------------

# Files that are rewritten when their content changes: the compiler's flags, the list of files, the folders of tests, and the commit.
flags := $(compile) $(CXXFLAGS_all) $(OPTIMISATION_less) $(LESS) $(OPTIMISATION_none) $(UNOPTIMISED) $(LDFLAGS_all)
files := $(SOURCES_all) $(FILES_scenes) $(FILES_scene_assets) $(FILES_shaders) $(FILES_webgl) $(FILES_pages) $(FILES_cases) $(FILES_conformance) $(FILES_lessons) $(FILES_lessons_zh) $(FILES_tutors)
tests := $(FOLDERS)
commit := $(shell tools/commit.sh 2>/dev/null)
# (make 4.3 leaves some files' last line break in place.)
changed = $(if $(subst |$(strip $($(1)))|,,|$(strip $(file <$(BUILD)/$(1)))|),force)
$(BUILD)/flags: $(call changed,flags)
$(BUILD)/files: $(call changed,files)
$(BUILD)/tests: $(call changed,tests)
$(BUILD)/commit: $(call changed,commit)
$(BUILD)/flags $(BUILD)/files $(BUILD)/tests $(BUILD)/commit:
	@mkdir -p $(@D); printf '%s\n' '$(subst ','\'',$($(@F)))' >$@

# A room's translation unit includes its sources; it is written when the list of them changes.
room_sources = $(sort $(filter-out $(ALONE),$(wildcard $(1)/*.cpp)))
room_written = $(patsubst "%",%,$(filter "%",$(file <$(BUILD)/objects/$(1).room.cpp)))
define room
$(BUILD)/objects/$(1).room.cpp: $(if $(subst |$(call room_written,$(1))|,,|$(call room_sources,$(1))|),force)
	@mkdir -p $$(@D); printf '#include "%s"\n' $(call room_sources,$(1)) >$$@
endef
$(foreach name,$(ROOMS),$(eval $(call room,$(name))))

# (g++ takes an included source for a header, and warns about its uses of anonymous namespaces.)
ROOM_WARNINGS := $(if $(findstring clang,$(CXX)),,-Wno-subobject-linkage)
$(BUILD)/objects/%.room.o: $(BUILD)/objects/%.room.cpp $(BUILD)/flags
	@echo "compile $*/*.cpp"
	@$(compile) $(CXXFLAGS_all) $(optimisation) $(precompiled) $(ROOM_WARNINGS) -iquote . -MMD -MP -c $< -o $@

$(BUILD)/objects/%.o: %.cpp $(BUILD)/flags
	@echo "compile $<"
	@mkdir -p $(@D)
	@$(compile) $(CXXFLAGS_all) $(optimisation) $(or $(INSTRUCTIONS),$(precompiled)) -MMD -MP -c $< -o $@

# What nearly all rooms include is compiled once, and once more for tests.
PRECOMPILED := $(BUILD)/precompiled.h
UNOPTIMISED_precompiled := $(BUILD)/precompiled-tests.h
ifeq ($(units),rooms)
precompiled = -include $(if $(filter $(UNOPTIMISED),$*),$(UNOPTIMISED_precompiled),$(PRECOMPILED))
$(filter-out $(unoptimised),$(call object,$(SOURCES_all))): $(PRECOMPILED).gch
$(filter $(unoptimised),$(call object,$(SOURCES_all))): $(UNOPTIMISED_precompiled).gch
endif
$(UNOPTIMISED_precompiled).gch: optimisation = $(OPTIMISATION_none) -include gtest/gtest.h
$(PRECOMPILED).gch $(UNOPTIMISED_precompiled).gch: src/base/precompiled.h $(BUILD)/flags
	@echo "compile $<"
	@mkdir -p $(@D); cp $< $(@:.gch=); $(compile) $(CXXFLAGS_all) $(optimisation) -MMD -MP -MT $@ -MF $(@:.gch=.d) -x c++-header -c $< -o $@

# If several objects instantiate a template, the linker takes the first copy. So lower layers come first: a change in a higher layer
# cannot change how fast they are. Objects that are optimised less come last, and after them those that are not optimised or that have no
# sanitizers (PLAIN).
objects_less = $(filter $(LESS:%=$(BUILD)/objects/%.room.o),$^)
objects_last = $(filter $(unoptimised) $(plain_objects),$^)
objects_more = $(filter-out $(objects_less) $(objects_last),$(filter %.o,$^))
layers := $(addsuffix /%,$(addprefix $(BUILD)/objects/src/,base lighting scene))
objects_first = $(foreach layer,$(layers),$(filter $(layer),$(objects_more)))
link = @echo "link $@"; mkdir -p $(@D); \
    $(CXX) $(LDFLAGS_all) $(objects_first) $(filter-out $(objects_first),$(objects_more)) $(objects_less) $(objects_last) -o $@

$(PROGRAMS)/twinlight: $(OBJECTS_cli) $(OBJECT_version)
	$(link) $(LIBS_offscreen) $(LIBS)

# The window has no use for some rooms, so it need not wait for them.
SOURCES_demo_library := $(filter-out src/judge/check/% src/judge/conformance/% src/judge/fuzz/% src/judge/oracle/%,$(SOURCES_library))
$(PROGRAMS)/twinlight-demo: $(call object,$(SOURCES_demo) $(SOURCES_demo_library)) $(OBJECT_version) $(OBJECTS_embedded)
	$(link) $(LIBS_window) $(LIBS)

$(PROGRAMS)/twinlight-tests: $(OFFSCREEN) $(call object,$(SOURCES_some_tests)) $(BUILD)/tests \
    $(call object,$(SOURCES_bench_meshes) $(SOURCES_subcommands) $(SOURCES_session) $(SOURCES_web)) $(OBJECT_version)
	$(link) $(LIBS_offscreen) $(LIBS) $(LIBS_gtest)

$(PROGRAMS)/twinlight-bench: $(call object,$(SOURCES_bench) $(SOURCES_bench_library) $(SOURCES_session)) $(OFFSCREEN)
	$(link) $(LIBS_offscreen) $(LIBS)

OBJECTS_fuzz := $(call object,$(SOURCES_fuzz_common) $(SOURCES_fuzz_library)) $(patsubst %,$(BUILD)/embedded/%.o,scenes scene_assets recorder)
$(fuzz_targets:%=$(BUILD)/%-fuzzer): $(BUILD)/%-fuzzer: $(BUILD)/objects/tests/fuzz/%_fuzzer.o $(OBJECTS_fuzz)
	$(link) -fsanitize=fuzzer $(LIBS_fuzz)

# The tables of bad input as a program of their own, for the sanitizers.
$(PROGRAMS)/bad-input: $(call object,$(SOURCES_bad_input)) $(OFFSCREEN)
	$(link) $(LIBS_offscreen) $(LIBS) $(LIBS_gtest)

$(BUILD)/write-seeds: $(call object,$(SOURCES_fuzz_seeds)) $(OBJECTS_fuzz)
	$(link) $(LIBS_fuzz)

# Records what the real freeglut and GLU send for their shapes; the tests compare src/scene/shape with it.
$(PROGRAMS)/shape-recorder: $(call object,$(SOURCES_recorder))
	$(link) $(LIBS_window)

# Files that are embedded in the programs: a table of {name, text} for each folder.
embed = @mkdir -p $(@D); tools/embed.sh $(1) $(2) >$@

$(BUILD)/embedded/scenes.cpp: $(FILES_scenes) $(BUILD)/files tools/embed.sh
	$(call embed,kSceneFiles,$(FILES_scenes))
$(BUILD)/embedded/scene_assets.cpp: $(FILES_scene_assets) $(BUILD)/files tools/embed.sh
	$(call embed,kSceneAssets,$(sort $(FILES_scene_assets)))
$(BUILD)/embedded/recorder.cpp: $(FILES_recorder) $(BUILD)/files tools/embed.sh
	$(call embed,kRecorderFiles,$(FILES_recorder))
$(BUILD)/embedded/shaders.cpp: $(FILES_shaders) $(BUILD)/files tools/embed.sh
	$(call embed,kShaderFiles,$(sort $(FILES_shaders)))
$(BUILD)/embedded/webgl.cpp: $(FILES_webgl) $(BUILD)/files tools/embed.sh
	$(call embed,kWebglFiles,$(FILES_webgl))
$(BUILD)/embedded/pages.cpp: $(FILES_pages) $(BUILD)/files tools/embed.sh
	$(call embed,kPageFiles,$(sort $(FILES_pages)))
$(BUILD)/embedded/cases.cpp: $(FILES_cases) $(BUILD)/files tools/embed.sh
	$(call embed,kCaseFiles,$(sort $(FILES_cases)))
$(BUILD)/embedded/conformance.cpp: $(FILES_conformance) $(BUILD)/files tools/embed.sh
	$(call embed,kConformanceFiles,$(FILES_conformance))
$(BUILD)/embedded/tutors.cpp: $(FILES_tutors) $(BUILD)/files tools/embed.sh
	$(call embed,kTutorFiles,$(FILES_tutors))
$(BUILD)/embedded/lessons.cpp: $(FILES_lessons) $(BUILD)/files tools/embed.sh
	$(call embed,kLessonFiles,$(sort $(FILES_lessons)))
$(BUILD)/embedded/lessons-zh.cpp: $(FILES_lessons_zh) $(BUILD)/files tools/embed.sh
	$(call embed,kChineseLessonFiles,$(sort $(FILES_lessons_zh)))

$(BUILD)/embedded/version.cpp: $(BUILD)/commit $(BUILD)/flags
	@mkdir -p $(@D); printf '#include "app/version.h"\nconst char* const twinlight::kCommit = "%s";\nconst char* const twinlight::kLibraries = "%s";\n' \
	    '$(commit)' "$$(for name in $(filter-out stb,$(MODULES)) glut glu; do echo "$$name $$(pkg-config --modversion $$name)"; done | sed '$$!s/$$/, /' | tr -d '\n')" >$@
$(BUILD)/embedded/chart.js: $(CHART)
	@mkdir -p $(@D); cp $< $@

$(BUILD)/objects/entry_points.cpp: src/render/context/gl.h src/render/context/entry_points.awk $(BUILD)/flags
	@mkdir -p $(@D); echo '#include "$<"' | $(CXX) $(CXXFLAGS_all) -iquote . -E -P -x c++ - -o $(@:.cpp=.headers)
	@awk -f $(word 2,$^) $(@:.cpp=.headers) >$@
$(BUILD)/objects/entry_points.o: $(BUILD)/objects/entry_points.cpp $(BUILD)/flags
	@$(CXX) $(CXXFLAGS_all) -MMD -MP -c $< -o $@

$(BUILD)/embedded/%.o: $(BUILD)/embedded/%.cpp $(BUILD)/flags
	@$(CXX) $(CXXFLAGS_all) -O0 -MMD -MP -c $< -o $@

-include $(patsubst %.o,%.d,$(call object,$(SOURCES_all)) $(OBJECTS_embedded) $(OBJECT_version)) $(BUILD)/objects/entry_points.d $(PRECOMPILED).d $(UNOPTIMISED_precompiled).d
