#!/usr/bin/env bash
# run.sh TARGET SECONDS: fuzzes one target from its seeds and from the corpus that earlier runs left in build/fuzz/corpus.
# What it finds is kept in build/fuzz/findings; then it exits with 1.
set -euo pipefail
cd "$(dirname "$0")/../.."
target=$1 seconds=$2 build=build/fuzz
corpus=$build/corpus/$target seeds=$build/seeds/$target findings=$build/findings
mkdir -p "$corpus" "$seeds" "$findings"

# Small seeds, for small inputs are tried faster: those that are kept for it, and pieces of the scenes and recordings that the
# tests draw.
if [ -d "tests/fuzz/seeds/$target" ]; then cp tests/fuzz/seeds/"$target"/* "$seeds"; fi
case $target in
scene) for scene in src/scene/scenes/*.gl; do split -l 8 "$scene" "$seeds/$(basename "$scene")-"; done ;;
state | picture) "$build/write-seeds" "$seeds" src/scene/scenes/*.gl tests/fuzz/seeds/scene/*.gl ;;
trace) grep -a -v '^#' tests/bad_input/traces.txt | cut -f 2- | while IFS= read -r row; do
    printf '%b' "$row" >"$seeds/$(printf '%s' "$row" | cksum | cut -d ' ' -f 1)"
    done ;;
dump) for dump in tests/traces/*/dump.txt; do
    head -n 200 "$dump" | split -l 8 - "$seeds/$(basename "$(dirname "$dump")")-"
    done ;;
esac

# The words of both texts; those of C and GLUT for whole programs.
sed -nE 's/^(GL|SHAPE|QUADRIC|PRAGMA)_COMMAND\((\w+),.*/"\2"/p; s/^ENUM\((\w+),.*/"GL_\1"/p; s/^WORD\((\w+),.*/"\1"/p' src/scene/command/*.def |
    sort -u >"$build/$target.dict"
if [ "$target" = obj ]; then
    printf '"%s"\n' 'v ' 'vt ' 'vn ' 'f ' 'usemtl ' 'mtllib ' 'newmtl ' 'Ka ' 'Kd ' 'Ks ' 'Ke ' 'Ns ' 'd ' 'Tr ' 'illum ' 'map_Kd ' '-s ' '-clamp on' \
        '//' '-1' 'nan' 'inf' '1e39' '\x0c' >"$build/$target.dict"
fi
if [ "$target" = scene ]; then
    printf '"%s"\n' 'for (' 'while (' 'do ' 'if (' 'else ' 'switch (' 'case ' 'default:' break continue 'return ' static const enum \
        'void ' 'int ' 'float ' 'double ' 'GLfloat ' 'GLuint ' bool 'main(' 'display' glutDisplayFunc glutReshapeFunc glutInitWindowSize \
        glutMainLoop glutSwapBuffers '#define ' '#ifdef ' '#if ' '#else\x0a' '#endif\x0a' sin cos sqrt fabs pow atan2 fmod floor M_PI \
        'typedef ' 'char *' 'float *' '*p++' '(*p)' '++' '--' '+=' '&&' '||' '==' '!=' '<=' '<<' '?' '%' \
        'struct ' 'union ' 'struct a { ' 'struct a *' '->' '.x' '.x = ' '[1] = ' '&p' '**p' '(*f)(' 'sizeof ' 'NULL' 'unsigned short int ' \
        'malloc(' 'calloc(' 'realloc(' 'free(' 'memset(' 'memcpy(' strlen strcpy 'sprintf(' '%s' '%d' rand srand glutBitmapCharacter \
        glutStrokeString GLUT_BITMAP_8_BY_13 GLUT_STROKE_ROMAN GLUT_ELAPSED_TIME '##' __VA_ARGS__ __has_include '#include \x22' >>"$build/$target.dict"
fi

# A leak is told at the end; what a machine does in a second may take a sanitizer's build a minute.
status=0
ASAN_OPTIONS=malloc_context_size=5 "$build/$target-fuzzer" "$corpus" "$seeds" -max_total_time="$seconds" -entropic=0 -max_len=768 -timeout=60 -rss_limit_mb=6144 \
    -dict="$build/$target.dict" -artifact_prefix="$findings/$target-" -print_final_stats=1 -verbosity=0 \
    >"$build/$target.log" 2>&1 || status=$?
executions=$(sed -nE 's/^stat::number_of_executed_units: *//p' "$build/$target.log")
if [ "$status" -ne 0 ]; then
    cat "$build/$target.log"
    echo "fuzz $target: found something after ${executions:-?} executions; repeat it: $build/$target-fuzzer FILE of $findings"
    exit 1
fi
echo "fuzz $target: $executions executions in $seconds s, nothing found"
