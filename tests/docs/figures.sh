#!/usr/bin/env bash
# Prints the table "How close the three pictures are" of docs/figures.md: tests/docs/figures.sh, after make programs.
set -euo pipefail
cd "$(dirname "$0")/../.."
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
for scene in report lab spectral commands legacy; do
    "${TWINLIGHT_BUILD:-build}/twinlight" compare "$scene" -o "$folder" --json >"$folder/$scene.json"
done
python3 - "$folder" <<'END'
import json, sys

PAIRS = [("fixed", "shaders"), ("fixed", "reference"), ("shaders", "reference"), ("shaders-phong", "reference-phong")]
print("| scene | pixels away from edges | fixed, shaders | fixed, reference | shaders, reference | shaders, reference: every pixel lit | verdict |")
print("|---|---|---|---|---|---|---|")
for scene in ["report", "lab", "spectral", "commands", "legacy"]:
    comparison = json.load(open(f"{sys.argv[1]}/{scene}.json"))
    if "steps" in comparison:
        comparison = comparison["steps"][0]["comparison"]  # the first step
    pairs = {(pair["a"], pair["b"]): pair for pair in comparison["pairs"]}
    cells = [f"{pairs[names]['interior']['differing']:,}" if names in pairs else "-" for names in PAIRS]
    pixels = max(pair["interior"]["pixels"] for pair in pairs.values())
    print(f"| {scene} | {pixels:,} | {' | '.join(cells)} | {comparison['verdict'].replace('within', 'agree')} |")
END
