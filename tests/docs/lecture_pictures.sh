#!/usr/bin/env bash
# Draws the pictures of docs/lecture.md again: tests/docs/lecture_pictures.sh, after make programs. Needs ImageMagick, which
# scales them down, so that edges are smooth.
set -euo pipefail
cd "$(dirname "$0")/../.."
twinlight=${TWINLIGHT_BUILD:-build}/twinlight
out=docs/lecture
mkdir -p "$out"
draw() { # NAME SCENE OPTIONS...
    "$twinlight" render "${@:2}" --size 1200x900 -o "$out/$1.png" 2>/dev/null
    convert "$out/$1.png" -resize 400x300 -strip -define png:exclude-chunks=date,time "$out/$1.png"
}
gl() { draw "$1" "${@:2}" --with fixed; }
pixels() { draw "$1" "${@:2}" --with shaders --shading phong; }

gl terms terms
gl diffuse terms --step 3
gl specular terms --step 4
gl ambient terms --step 2
pixels half-vector half-vector
pixels half-vector-reflection half-vector --step 2
pixels half-vector-matched half-vector --step 3
gl shininess shininess
gl several-lights several-lights
gl distant-light-4 distant-light --step 1
gl distant-light-16 distant-light --step 2
gl distant-light-infinite distant-light --step 4
gl distant-viewer-local distant-viewer --step 1
gl distant-viewer-distant distant-viewer --step 2
gl emission light-model --step 1
gl separate-colors light-model --step 2
gl lamp-ambient light-model --step 3
gl two-sides light-model --step 4
gl attenuation attenuation
gl attenuation-gl attenuation --step 2
pixels attenuation-course attenuation --step 3
pixels spotlight spotlight
gl spotlight-coarse spotlight --step 2
gl interpolation interpolation
gl lost-highlight interpolation --step 2
pixels found-highlight interpolation --step 2
gl material-forms material-forms
gl queries queries
gl color-material color-material
gl materials materials
gl no-specular no-specular --step 1
gl no-specular-black no-specular --step 2
pixels report report
gl wireframes report --step 2
pixels cylinders cylinders
pixels lab lab
pixels lab-spot lab --step 4
gl lab-spot-gl lab --step 4
gl lab-fitted lab --step 5
pixels spectral spectral
gl no-shadows shadow-map --step 1
gl shadows shadow-map --step 2
gl no-mirror environment --step 1
gl mirror environment --step 3
gl cones cylinders --step 2
gl mesh-normals mesh-normals
gl cosine cosine
gl normal-sign cosine --step 2
gl material-color material-color
pixels tutorial-diffuse tutorial --step 2
pixels tutorial-ambient tutorial --step 3
pixels tutorial-specular tutorial --step 4
gl normals normals
