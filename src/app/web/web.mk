# The page for browsers: `make web` writes build/web/page/, for a host, and build/web/twinlight.html, the same as one file. The Makefile
# includes this.
#
#   EMXX=em++   Emscripten's compiler: 3.1.6 of Debian 12 or later

EMXX ?= em++
WEB := $(BUILD)/web
PAGE := $(WEB)/page
# The editor: CodeMirror 5, of Debian's libjs-codemirror, with its licence.
EDITOR_web := $(addprefix $(PAGE)/codemirror/,codemirror.js codemirror.css copyright)

# What exported pages have, too.
SHARED_web := $(addprefix $(PAGE)/,gl.js labels.js terms.js theme.css theme.js)

# The module has the rooms and files that need neither GL nor processes.
ROOMS_web := $(addprefix src/,base/image base/math base/text base/threads scene/command scene/mesh scene/scenes scene/shape scene/spectrum \
    scene/frame scene/state scene/recorded scene/trace lighting render/effect \
    $(addprefix render/programmable/,numbers text export) $(addprefix render/reference/,vertices textures geometry) render/reference render/webgl judge/compare \
    judge/explain judge/lesson judge/lint judge/study app/session app/web)
# The files of app/session that the page needs.
SESSION_web := alignment argument_places arguments axes camera edited_text edits history initial_values keys lesson_state probe probe_arrows \
    outside_view scaled session tutor world world_handles
WITHOUT_web := $(wildcard src/lighting/points_avx*.cpp) $(filter-out %/tolerance.cpp,$(wildcard src/judge/compare/*.cpp)) \
    $(filter-out %/scene_of_choice.cpp,$(wildcard src/judge/study/*.cpp)) \
    $(filter-out $(patsubst %,src/app/session/%.cpp,$(SESSION_web)),$(wildcard src/app/session/*.cpp))
sources_web = $(sort $(filter-out $(WITHOUT_web),$(wildcard $(1)/*.cpp)))
# Rooms where it costs nothing are made small. (All of the module with -Oz would make the reference a third slower, and scene/command,
# scene/shape and scene/state would take twice as long to open a scene.)
SMALL_web := $(addprefix src/,scene/mesh scene/recorded scene/scenes scene/trace judge/explain judge/lesson judge/lint judge/study \
    $(addprefix render/programmable/,numbers text export) render/webgl app/session app/web)
OBJECTS_web := $(ROOMS_web:%=$(WEB)/objects/%.room.o) $(WEB)/objects/stb.o $(WEB)/objects/demangle.o \
    $(patsubst %,$(WEB)/objects/embedded/%.o,scenes scene_assets shaders webgl lessons lessons-zh tutors)
HEADERS_web := fmt glm nlohmann stb tiny_obj_loader.h

# em++ has a library and a /usr/include of its own, so it sees only these of the system's headers.
CXXFLAGS_web := -std=c++20 -O2 -ffp-contract=off -fwasm-exceptions -DFMT_HEADER_ONLY -Isrc -Isrc/app/web/compat \
    -isystem $(WEB)/include -include src/app/web/compat/library.h \
    -Wno-defaulted-function-deleted
# (Debian's node finds Debian's acorn, which Emscripten needs, only there.)
# One module for the page and its workers, without eval (for the page's Content-Security-Policy) and files. The stack is as large
# as a program's, because the reader of scenes is recursive. The tests, in Node, pass the module as bytes (wasmBinary).
# (Emscripten 3 gives this and HEAPU8 unasked, 6 only if they are named.)
LDFLAGS_web := -O2 -fwasm-exceptions -sMODULARIZE=1 -sEXPORT_ES6=1 -sENVIRONMENT=web,worker -sDYNAMIC_EXECUTION=0 -sFILESYSTEM=0 \
    -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=2147483648 -sTOTAL_STACK=8388608 \
    -sEXPORTED_RUNTIME_METHODS=HEAPU8 -sINCOMING_MODULE_JS_API=wasmBinary,instantiateWasm,locateFile

FILES_web := $(WEB)/twinlight.zip $(WEB)/twinlight-page.zip
.PHONY: web
web: deps  ## build the page for browsers: build/web/twinlight.html, and build/web/page for a host
	@$(MAKE) $(FILES_web)

$(WEB)/flags: $(if $(subst |$(EMXX) $(CXXFLAGS_web) $(SMALL_web) $(LDFLAGS_web)|,,|$(file <$(WEB)/flags)|),force)
	@mkdir -p $(WEB)/include; ln -sf $(HEADERS_web:%=/usr/include/%) $(WEB)/include
	@printf '%s\n' '$(EMXX) $(CXXFLAGS_web) $(SMALL_web) $(LDFLAGS_web)' >$@

$(OBJECTS_web): $(WEB)/flags
# A room's list of sources is written only if it changed, so that a new file compiles its own room and no other.
define room_web
$(WEB)/objects/$(1).room.cpp: $(BUILD)/files src/app/web/web.mk
	@mkdir -p $$(@D); printf '#include "%s"\n' $(call sources_web,$(1)) >$$@.new
	@cmp -s $$@.new $$@ && rm $$@.new || mv $$@.new $$@
endef
$(foreach name,$(ROOMS_web),$(eval $(call room_web,$(name))))
$(WEB)/objects/%.room.o: $(WEB)/objects/%.room.cpp
	@echo "compile $*/*.cpp for browsers"
	@$(EMXX) $(CXXFLAGS_web) $(if $(filter $(SMALL_web),$*),-Oz,$(if $(filter $(LESS),$*),-O1)) -iquote . -MMD -MP -c $< -o $@
$(WEB)/objects/%.o: src/app/web/compat/%.cpp
	@$(EMXX) $(CXXFLAGS_web) -w -c $< -o $@
$(WEB)/objects/embedded/%.o: $(BUILD)/embedded/%.cpp
	@mkdir -p $(@D); $(EMXX) $(CXXFLAGS_web) -MMD -MP -c $< -o $@

$(PAGE)/module.js: $(OBJECTS_web)
	@echo "link $@"
	@mkdir -p $(@D); NODE_PATH=$${NODE_PATH:-/usr/share/nodejs} $(EMXX) $(LDFLAGS_web) $(OBJECTS_web) -o $@
$(PAGE)/%: src/app/web/page/%
	@mkdir -p $(@D); cp $< $@
$(SHARED_web): $(PAGE)/%: src/render/webgl/%
	@mkdir -p $(@D); cp $< $@
$(PAGE)/codemirror/%: /usr/share/javascript/codemirror/lib/%
	@mkdir -p $(@D); cp $< $@
$(PAGE)/codemirror/copyright: /usr/share/doc/libjs-codemirror/copyright
	@mkdir -p $(@D); cp $< $@
# Mesa's pictures of the built-in scenes, and the list of their names.
$(PAGE)/mesa.json: $(OBJECTS_cli) tools/mesa-pictures.mjs tools/png.mjs $(addprefix $(PAGE)/,module.js twinlight.js recorded.js package.json) | $(PROGRAMS)/twinlight
	@echo "draw the built-in scenes with Mesa, for the page"
	@node tools/mesa-pictures.mjs $(PROGRAMS)/twinlight $(@D) >$@.new && mv $@.new $@
# The pictures of the list of scenes.
$(PAGE)/scenes.json: $(OBJECTS_cli) tools/scene-pictures.mjs | $(PROGRAMS)/twinlight
	@mkdir -p $(@D); node tools/scene-pictures.mjs $(PROGRAMS)/twinlight >$@.new && mv $@.new $@
# The whole page.
FILES_page := $(PAGE)/module.js $(patsubst src/app/web/page/%,$(PAGE)/%,$(wildcard src/app/web/page/*)) $(SHARED_web) $(EDITOR_web)
$(WEB)/twinlight.html: $(FILES_page) $(PAGE)/mesa.json $(PAGE)/scenes.json tools/pack-page.mjs
	@echo "pack $@"
	@node tools/pack-page.mjs $(PAGE) $@
# Both forms to give away. A zip file has one time for all its files, so that it changes only with them.
$(WEB)/hosting.html: src/app/web/hosting.html
	@cp $< $@
zip_web = rm -rf $@ $@.d; mkdir -p $@.d/twinlight; cp -R $(1) $(WEB)/hosting.html $@.d/twinlight; \
    find $@.d -exec touch -d 2000-01-01T00:00Z {} +; cd $@.d && find twinlight -type f | LC_ALL=C sort | TZ=UTC zip -q -X -9 ../$(@F) -@; \
    status=$$?; rm -rf ../$(@F).d; exit $$status
$(WEB)/twinlight.zip: $(WEB)/twinlight.html $(WEB)/hosting.html
	@$(call zip_web,$<)
$(WEB)/twinlight-page.zip: $(WEB)/twinlight.html $(WEB)/hosting.html
	@$(call zip_web,$(PAGE)/.)
# For Node: these files are modules.
$(PAGE)/package.json:
	@mkdir -p $(@D); echo '{"type": "module"}' >$@

-include $(OBJECTS_web:.o=.d)

# axe-core, with which a test looks for what keeps people from using the pages. The tests skip this where it is not installed.
.PHONY: axe
axe:  ## install axe-core by npm into build/npm, for a test of the pages
	@npm install --silent --no-save --ignore-scripts --prefix build/npm axe-core@4.14.1
