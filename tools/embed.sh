#!/bin/sh
# embed.sh HEADER TABLE FILE...: prints the C++ that defines TABLE, a std::vector<EmbeddedFile> declared in HEADER, from the files.
set -eu
header=$1 table=$2
shift 2
printf '#include "%s"\nnamespace twinlight {\nconst std::vector<EmbeddedFile> %s = {\n' "$header" "$table"
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
