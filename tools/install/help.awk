# Reads what `PROGRAM --help` prints, and prints a line for each part of it, with tabs between the fields:
#
#   about     the first sentences, a line each
#   usage     the line after "Usage: "
#   argument  name, "", "", what it is
#   option    names with commas between, its value or "", the value's default or "", what the option does
#   command   name, "", "", what it does
#   footer    the lines after the lists, a line each
#
# A value is as in --help: "FILE", "WxH", or the choices as "flat|gouraud".

function finish() {
    if (kind != "") print kind "\t" name "\t" value "\t" preset "\t" text
    kind = ""
}

# The entry is "--with fixed|phong REQUIRED" or "--size WxH=640x480"; from CLI11 2.4 on "--size WxH [640x480]".
function start(entry, description,    at) {
    finish()
    kind = section; text = description; value = ""; preset = ""
    sub(/ *Excludes:.*/, "", entry)
    sub(/ *REQUIRED.*/, "", entry)
    gsub(/, +/, ",", entry)
    sub(/ +$/, "", entry)
    if (match(entry, / [[][^]]*[]]$/)) {
        preset = substr(entry, RSTART + 2, RLENGTH - 3); entry = substr(entry, 1, RSTART - 1)
    } else if ((at = index(entry, "=")) > 0) {
        preset = substr(entry, at + 1); entry = substr(entry, 1, at - 1)
    }
    if (section == "argument") {
        sub(/ [.][.][.]$/, "", entry)
        name = entry
    } else {
        at = index(entry, " ")
        name = at ? substr(entry, 1, at - 1) : entry
        value = at ? substr(entry, at + 1) : ""
    }
}

/^Usage: / { print "usage\t" substr($0, 8); described = 1; next }
!described { print "about\t" $0; next }
tolower($0) ~ /^positionals:$/ { finish(); section = "argument"; next }
tolower($0) ~ /^options:$/ { finish(); section = "option"; next }
tolower($0) ~ /^subcommands:$/ { finish(); section = "command"; next }
/^ *$/ { finish(); if (footer) print "footer\t"; next }
# An entry, and its text from column 31 on, which may have one space before it.
section != "" && !footer && /^  [^ ]/ {
    at = match(substr($0, 3), /  +[^ ]/)
    if (at) start(substr($0, 3, at - 1), substr($0, at + RLENGTH + 1))
    else if (substr($0, 30, 1) == " ") start(substr($0, 3, 27), substr($0, 31))
    else start(substr($0, 3), "")
    next
}
section != "" && !footer && /^        / { sub(/^ +/, ""); text = text (text == "" ? "" : " ") $0; next }
{ finish(); footer = 1; print "footer\t" $0 }
END { finish() }
