#!/bin/sh
# report.sh RESULTS: sums up the lines of run.sh: report.txt (also printed), report.json, report.html. cases.txt has what is known of each
# case, with tabs between: name, section, "defined" or "open", what is hard, why.
set -eu
results=$1
for format in txt json html; do
    awk -F '\t' -v format=$format '
    function escaped(text) {
        if (format == "json") {
            gsub(/\\/, "\\\\\\\\", text)
            gsub(/"/, "\\\"", text)
        }
        if (format == "html") {
            gsub(/&/, "\\&amp;", text)
            gsub(/</, "\\&lt;", text)
        }
        return text
    }
    FNR == NR {
        order[++count] = $1
        section[$1] = $2
        status[$1] = $3
        what[$1] = $4
        why[$1] = $5
        next
    }
    /^GL: / { gl = substr($0, 5); next }
    {
        at = index($0, ": ")
        name = substr($0, 1, at - 1)
        rest = substr($0, at + 2)
        if (name in what) detail[name] = rest
        else if (name == "all") of_all = rest
    }
    END {
        verdicts = split("wrong;crashed;open;not run;right", verdict, ";")
        for (i = 1; i <= count; ++i) {
            name = order[i]
            if (!(name in detail)) detail[name] = of_all != "" ? of_all : "not run: the program ended before it"
            for (v = 1; v <= verdicts; ++v)
                if (index(detail[name], verdict[v]) == 1) result[name] = verdict[v]
            ++number[result[name]]
            text = substr(detail[name], length(result[name]) + 1)
            sub(/^ \((feedback|pixel)\)/, "", text)
            sub(/^: /, "", text)
            finding[name] = text
            read[name] = index(detail[name], "(feedback)") ? "feedback" : index(detail[name], "(pixel)") ? "pixel" : ""
        }
        summary = sprintf("%d right, %d wrong, %d open, %d not run, %d crashed", number["right"], number["wrong"],
                          number["open"], number["not run"], number["crashed"])
        if (format == "txt") {
            print gl
            print count " cases: " summary
            for (v = 1; v < verdicts; ++v) {
                if (number[verdict[v]]) print "\n" verdict[v] ":"
                for (i = 1; i <= count; ++i)
                    if (result[order[i]] == verdict[v]) print "  " order[i] ": " finding[order[i]]
            }
        } else if (format == "json") {
            printf "{\n  \"gl\": \"%s\",\n  \"right\": %d,\n  \"wrong\": %d,\n  \"open\": %d,\n  \"not_run\": %d,\n  \"crashed\": %d,\n  \"cases\": [", \
                escaped(gl), number["right"], number["wrong"], number["open"], number["not run"], number["crashed"]
            for (i = 1; i <= count; ++i) {
                name = order[i]
                printf "%s\n    {\"name\": \"%s\", \"section\": \"%s\", \"status\": \"%s\", \"what\": \"%s\", \"result\": \"%s\", \"read_by\": \"%s\", \"finding\": \"%s\"}", \
                    (i > 1 ? "," : ""), escaped(name), escaped(section[name]), status[name], escaped(what[name]), result[name], \
                    read[name], escaped(finding[name])
            }
            print "\n  ]\n}"
        } else {
            print "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>OpenGL lighting: " escaped(gl) "</title>"
            print "<style>body { font: 16px/1.5 sans-serif; max-width: 75em; margin: 2em auto; padding: 0 1em }"
            print "table { border-collapse: collapse } td, th { text-align: left; vertical-align: top; padding: .3em .8em; border-top: 1px solid #ccc }"
            print ".wrong, .crashed { color: #b00020; font-weight: bold } .right { color: #1b6e20 } small { color: #555 }</style>"
            print "<h1>Hard cases of OpenGL lighting</h1>\n<p>" escaped(gl) "</p>\n<p>" count " cases: " summary ".</p>"
            print "<p><em>Open</em>: another answer than ours, where the specification is silent. Sections are those of OpenGL 2.1.</p>"
            print "<table>\n<tr><th>case<th>result<th>what is hard<th>the specification, and this GL"
            for (v = 1; v <= verdicts; ++v)
                for (i = 1; i <= count; ++i) {
                    name = order[i]
                    if (result[name] != verdict[v]) continue
                    text = finding[name]
                    suffix = "; OpenGL 2.1, section " section[name]
                    if (substr(text, length(text) - length(suffix) + 1) == suffix) text = substr(text, 1, length(text) - length(suffix))
                    printf "<tr id=\"%s\"><td>%s<td class=\"%s\">%s<td>%s<br><small>%s</small><td>%s%s\n", escaped(name), escaped(name), \
                        verdict[v], verdict[v], escaped(what[name]), escaped(why[name]), escaped(section[name]), \
                        (text == "" ? "" : "<br><small>" escaped(text) "</small>")
                }
            print "</table>\n</html>"
        }
    }' cases.txt "$results" >report.$format
done
cat report.txt
