#!/bin/sh
# embed.sh TABLE FILE...: prints the C++ that defines TABLE, a std::vector<EmbeddedFile>, from the files.
set -eu
table=$1
shift
printf '#include "base/image/embedded.h"\nnamespace twinlight {\nextern const std::vector<EmbeddedFile> %s;\n' "$table"
printf 'const std::vector<EmbeddedFile> %s = {\n' "$table"
for file; do
    case $file in
    *.png) # bytes: a string of escapes, and its length
        printf '{"%s", {\n' "${file##*/}"
        od -An -v -tx1 "$file" | sed 's/ /\\x/g; s/.*/"&"/'
        printf ', %d}},\n' "$(wc -c <"$file")" ;;
    *)
        printf '{"%s", R"twinlight(' "${file##*/}"
        cat "$file"
        printf ')twinlight"},\n' ;;
    esac
done
printf '};\n}\n'
