# Installing Twinlight, and packing it for others; the Makefile includes this.
#
#   PREFIX=/usr/local   the folder that gets bin/ and share/
#   DESTDIR=            goes before every path, so that a package can be made without root
#   ZSH=                the folder for zsh's completion

PREFIX ?= /usr/local
ZSH ?= $(PREFIX)/share/zsh/site-functions
VERSION := $(shell sed -n 's/.*kVersion = "\(.*\)";.*/\1/p' src/app/version.h)
installed_programs := twinlight twinlight-demo
MADE := $(PROGRAMS)/share

# What is made from --help of the programs that were built.
manuals := $(installed_programs:%=$(MADE)/%.1)
manuals_html := $(manuals:%=%.html)
completions := $(foreach shell,bash zsh fish,$(installed_programs:%=$(MADE)/%.$(shell)))
scripts_install := $(wildcard tools/install/*.awk tools/install/*.sh)
$(manuals): $(MADE)/%.1: $(PROGRAMS)/% $(scripts_install)
	@mkdir -p $(@D); tools/install/man.sh $< >$@
$(manuals_html): %.html: %
	@mandoc -T html $< | sed 's,<head>,&<style>body { max-width: 55em; margin: 1em auto; padding: 0 1em; font: 1em/1.5 system-ui\, sans-serif; color-scheme: light dark; } h1\, h2 { font-size: 1.2em; } .permalink { color: inherit; text-decoration: none; }</style>,' >$@
$(completions): programs $(scripts_install) $(FILES_cases)
	@mkdir -p $(@D); tools/install/completion.sh $(subst .,,$(suffix $@)) $(PROGRAMS)/$(basename $(@F)) $(basename $(notdir $(sort $(FILES_cases)))) >$@

# "FILE:PLACE" for each file that is installed; a place that ends in / is a folder. Scenes have files beside them: meshes and textures.
files_of_scenes := $(filter-out %.cpp %.h,$(wildcard src/scene/scenes/*))
share := $(PREFIX)/share
installed := $(installed_programs:%=$(PROGRAMS)/%:$(PREFIX)/bin/) \
    $(manuals:%=%:$(share)/man/man1/) \
    $(foreach name,$(installed_programs),$(MADE)/$(name).bash:$(share)/bash-completion/completions/$(name) \
        $(MADE)/$(name).zsh:$(ZSH)/_$(name) $(MADE)/$(name).fish:$(share)/fish/vendor_completions.d/$(name).fish) \
    tools/install/twinlight.desktop:$(share)/applications/ tools/install/twinlight.svg:$(share)/icons/hicolor/scalable/apps/ \
    $(files_of_scenes:%=%:$(share)/twinlight/scenes/) $(FILES_cases:%=%:$(share)/twinlight/cases/) \
    golden/known_differences:$(share)/twinlight/ LICENSE:$(share)/doc/twinlight/ docs/homework.c:$(share)/doc/twinlight/ CITATION.cff:$(share)/doc/twinlight/
file_of = $(firstword $(subst :, ,$(1)))
place_of = $(lastword $(subst :, ,$(1)))
path_of = $(if $(filter %/,$(call place_of,$(1))),$(call place_of,$(1))$(notdir $(call file_of,$(1))),$(call place_of,$(1)))

.PHONY: install install-files uninstall dist deb manuals-html release

install: $(if $(wildcard $(PROGRAMS)/twinlight),,deps)  ## install into PREFIX (/usr/local): programs, scenes, manual pages, completion; DESTDIR goes before every path
	@$(MAKE) install-files

install-files: programs $(manuals) $(completions)
	@$(foreach folder,$(sort $(filter %/,$(foreach entry,$(installed),$(call place_of,$(entry))))), \
	    install -D -m $(if $(filter %/bin/,$(folder)),755,644) -t '$(DESTDIR)$(folder)' $(patsubst %:$(folder),%,$(filter %:$(folder),$(installed))) &&) \
	$(foreach entry,$(filter-out %/,$(installed)), \
	    install -D -m 644 $(call file_of,$(entry)) '$(DESTDIR)$(call place_of,$(entry))' &&) true
	@echo "Twinlight $(VERSION) is in $(DESTDIR)$(PREFIX): $(installed_programs)"

uninstall:  ## remove what `make install` with the same PREFIX, DESTDIR and ZSH installed
	@rm -f $(foreach entry,$(installed),'$(DESTDIR)$(call path_of,$(entry))')
	@rm -rf '$(DESTDIR)$(share)/twinlight' '$(DESTDIR)$(share)/doc/twinlight'

DIST ?= build
dist:  ## pack the last commit's sources: build/twinlight-VERSION.tar.gz
	@mkdir -p $(DIST)
	@git archive --prefix=twinlight-$(VERSION)/ HEAD | gzip -9n >$(DIST)/twinlight-$(VERSION).tar.gz
	@echo "$(DIST)/twinlight-$(VERSION).tar.gz"

deb: deps  ## make a Debian package for this system: build/twinlight_VERSION_ARCHITECTURE.deb
	@$(MAKE) programs
	@rm -rf build/deb
	@$(MAKE) install-files DESTDIR=build/deb/root PREFIX=/usr ZSH=/usr/share/zsh/vendor-completions >/dev/null
	@tools/install/deb.sh build/deb/root $(VERSION) build

manuals-html: $(manuals_html)

release: deps  ## write build/release/: sources, a Debian package, the page, manual pages, checksums and notes (SYSTEMS=all or 'trixie noble': packages for these, too)
	@tools/release.sh $(VERSION) $(SYSTEMS)
