#!/usr/bin/env bash
# Makes the pictures of docs/demo.md again: tests/window/demo_pictures.sh, after make programs. Needs a display (or xvfb-run).
set -euo pipefail
cd "$(dirname "$0")/../.."
shoot() { # NAME SCENE OPTIONS...
    build/twinlight-demo "${@:2}" --language en --scale 1 --size 1280x800 --quit-after 300 --screenshot "docs/demo/$1.png"
}
mkdir -p docs/demo
shoot slider report
shoot grid report --view grid --panel lights
shoot world lab --view world
shoot probe report --view grid --probe 250,170
shoot overlays report --view single --keys "mn---" --panel overlays
shoot tutor --tutor light
shoot scenes report --keys '<Ctrl+O>'
shoot lesson --lesson shininess
shoot lint tests/window/mistakes.gl --view grid --panel lint
