#!/bin/sh
# man.sh PROGRAM: prints the program's manual page, made from its --help and that of each of its commands.
set -eu
program=$1
name=${program##*/}
help=$(dirname "$0")/help.awk
version=$("$program" --version | sed -n "s/^$name //p")

# Prints the part of a page for one help text. `level` is SH for the program, SS for one of its commands.
page() {
    awk -f "$help" | awk -F '\t' -v level="$1" '
        # roff reads \ and, at the start of a line, . and apostrophe; "-" would become a hyphen.
        function escaped(text) {
            gsub(/\\/, "\\e", text)
            gsub(/-/, "\\-", text)
            if (text ~ /^[.\047]/) text = "\\&" text
            return text
        }
        function capital(text) { return toupper(substr(text, 1, 1)) substr(text, 2) }
        function heading(title) {
            if (title == last) return
            last = title
            if (level == "SH") print ".SH " title
        }
        # Names are bold, the words for values italic; choices are both words and values, so bold.
        function entry(names, value,    words) {
            words = names
            gsub(/,/, "\\fR, \\fB", words)
            words = "\\fB" escaped_names(words) "\\fR"
            if (value ~ /[|]/) { gsub(/[|]/, "\\fR|\\:\\fB", value); value = "\\fB" escaped_names(value) "\\fR" }
            else if (value != "") value = "\\fI" escaped(value) "\\fR"
            print ".TP\n" words (value == "" ? "" : " " value)
        }
        function escaped_names(text) { gsub(/-/, "\\-", text); return text }

        $1 == "about" { about = about (about == "" ? "" : "\n") $2; next }
        $1 == "usage" {
            if (level == "SH") print ".SH SYNOPSIS"
            else { print escaped(about) "."; print ".PP" }
            print ".B " escaped($2)
            if (level == "SH") { print ".SH DESCRIPTION"; print escaped(about) }
            next
        }
        $1 == "argument" { heading("ARGUMENTS"); entry($2, "") ; print escaped(capital($5)) "."; next }
        level == "SS" && ($2 == "-h,--help" || $2 == "--version") { next }
        $1 == "option" {
            heading("OPTIONS")
            entry($2, $3)
            print escaped(capital($5)) ($4 == "" ? "" : " (default: " escaped($4) ")") "."
            next
        }
        $1 == "command" { heading("COMMANDS"); entry($2, ""); print escaped($5) "."; next }
        # After the lists: lines with columns stay as they are, other lines are filled.
        $1 == "footer" {
            is_row = $2 ~ /^  / || $2 ~ /[^ ]  +[^ ]/
            if (!after) { heading("NOTES"); print ".PP"; after = 1 }
            if (is_row != in_rows) { print is_row ? ".nf" : ".fi\n.PP"; in_rows = is_row }
            if ($2 ~ /^Exit status: / && !is_row) print ".PP"
            if ($2 == "") print ".PP"
            else print escaped($2)
            next
        }
        END { if (in_rows) print ".fi" }'
}

# roff's own names of the parts: title, section, date (none: the page is the same each time that it is made), program, manual.
upper=$(printf %s "$name" | tr '[:lower:]' '[:upper:]')
printf '.TH %s 1 "" "Twinlight %s" "User Commands"\n.nh\n' "$upper" "$version"
case $name in
    twinlight) about="draw OpenGL lighting three ways and show where the pictures differ" also="twinlight-demo(1), apitrace(1)" ;;
    *) about="change a scene of OpenGL lighting in a window that draws it three ways" also="twinlight(1)" ;;
esac
printf '.SH NAME\n%s \\- %s\n' "$name" "$about"
"$program" --help | page SH
commands=$("$program" --help | awk -f "$help" | awk -F '\t' '$1 == "command" { print $2 }')
[ -z "$commands" ] || echo '.SH THE COMMANDS, ONE BY ONE'
for command in $commands; do
    printf '.SS %s %s\n' "$name" "$command"
    "$program" "$command" --help | page SS
done
printf '.SH SEE ALSO\n%s\n' "$(printf %s "$also" | sed 's/-/\\-/g')"
