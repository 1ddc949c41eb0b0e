#!/bin/sh
# completion.sh SHELL PROGRAM [CASE...]: prints the completion of a program's command line for bash, zsh or fish, made from its --help.
# The CASEs are the names that the command `check` takes.
set -eu
shell=$1 program=$2
shift 2
name=${program##*/}
help=$(dirname "$0")/help.awk

# "COMMAND, KIND, NAMES, VALUE, DEFAULT, TEXT" with tabs between: of the program itself, whose COMMAND is "-", and of each command.
parts() {
    "$program" --help | awk -f "$help" | sed 's/^/-\t/'
    for command in $("$program" --help | awk -f "$help" | awk -F '\t' '$1 == "command" { print $2 }'); do
        "$program" "$command" --help | awk -f "$help" | sed "s/^/$command\t/"
    done
}
case $name in
    twinlight) list=$program ;;
    *) list=$(dirname "$program")/twinlight ;;
esac
scenes=$("$list" scenes | awk '/^  [^ ]/ { printf "%s%s", (n++ ? " " : ""), $1 }')

parts | awk -F '\t' -v shell="$shell" -v program="$name" -v scenes="$scenes" -v cases="$*" '
    function quoted(text) { gsub(/\047/, "\047\\\047\047", text); return "\047" text "\047" }
    # What a word after an option or in place of an argument may be: its choices, "files", "folders" or nothing.
    function choices(value) {
        if (value !~ /[|]/) return ""
        gsub(/[|][A-Z]+/, "", value)
        gsub(/[|]/, " ", value)
        return value
    }
    function places(value) {
        if (value ~ /DIR/) return "folders"
        if (value ~ /FILE|PATH|[.]json|SCENE|PROGRAM|CASE/) return "files"
        return ""
    }
    function named(argument) {
        if (argument ~ /SCENE|NAME/) return scenes
        return argument ~ /CASE/ ? cases : ""
    }
    # The start of a description, short enough for a list.
    function brief(text) {
        sub(/; .*| \(.*/, "", text)
        return length(text) > 70 ? substr(text, 1, 67) "..." : text
    }
    function identifier(text) { gsub(/-/, "_", text); return text }

    $2 == "command" { commands[++command_count] = $3; about[$3] = brief($6); next }
    $2 == "argument" && $3 ~ /ARGUMENTS/ { next }  # of the program that a command runs
    $2 == "argument" { argument[$1] = $3; argument_text[$1] = brief($6); next }
    $2 == "option" {
        ++count
        owner[count] = $1; names[count] = $3; value[count] = $4; text[count] = brief($6)
        next
    }

    # ---- bash: one function, which looks at the command and at the word before ----

    function bash_case(owner_pattern, i,    n, words, patterns, j, all) {
        if (value[i] == "") return
        n = split(names[i], words, ",")
        for (j = 1; j <= n; ++j) all = all (j > 1 ? " | " : "") owner_pattern ":" words[j]
        printf "        %s) words=%s places=%s ;;\n", all, quoted(choices(value[i])), quoted(places(value[i]))
    }
    function bash_words(command,    i, list) {
        for (i = 1; i <= count; ++i)
            if (owner[i] == command) { list = list " " names[i]; gsub(/,/, " ", list) }
        return substr(list, 2)
    }
    function bash(    i, f) {
        f = "_" identifier(program)
        print "# bash completion of " program ", made from its --help.\n" f "() {"
        print "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=- words= places= options="
        print "    COMPREPLY=()"
        # bash makes a word of the "=" in --with=fixed.
        print "    if [ \"$word\" = = ]; then word=; elif [ \"$before\" = = ]; then before=${COMP_WORDS[COMP_CWORD - 2]}; fi"
        if (command_count) print "    if [ \"$COMP_CWORD\" -gt 1 ]; then command=${COMP_WORDS[1]}; fi"
        print "    case $command in"
        printf "        -) options=%s words=%s places=%s ;;\n", quoted(bash_words("-")), \
            quoted(command_count ? list_of_commands() : named(argument["-"])), quoted(command_count ? "" : places(argument["-"]))
        for (i = 1; i <= command_count; ++i)
            printf "        %s) options=%s words=%s places=%s ;;\n", commands[i], quoted(bash_words(commands[i])), \
                quoted(named(argument[commands[i]])), quoted(places(argument[commands[i]]))
        print "    esac\n    case $word in -*) words=$options places= ;; esac\n    case $command:$before in"
        for (i = 1; i <= count; ++i) bash_case(owner[i], i)
        print "    esac\n    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))"
        print "    case $places in"
        print "        files) COMPREPLY+=($(compgen -f -- \"$word\")) ;;\n        folders) COMPREPLY+=($(compgen -d -- \"$word\")) ;;"
        print "    esac\n}\ncomplete -o filenames -F " f " " program
    }
    function list_of_commands(    i, list) {
        for (i = 1; i <= command_count; ++i) list = list " " commands[i]
        return substr(list, 2)
    }

    # ---- zsh: a list of _arguments for each command ----

    function zsh_text(text) { gsub(/:/, "\\:", text); gsub(/\[/, "\\[", text); gsub(/\]/, "\\]", text); return text }
    function zsh_action(words, place) {
        if (words != "" && place != "") return "_alternative \"words:name:(" words ")\" \"files:file:_files\""
        if (words != "") return "(" words ")"
        return place == "folders" ? "_files -/" : place == "files" ? "_files" : " "
    }
    function zsh_arguments(command,    i, n, words, j, others) {
        print "        _arguments -S \\"
        for (i = 1; i <= count; ++i) {
            if (owner[i] != command) continue
            n = split(names[i], words, ",")
            others = names[i]
            gsub(/,/, " ", others)
            for (j = 1; j <= n; ++j)
                printf "            %s \\\n", quoted("(" others ")" words[j] (value[i] != "" && words[j] ~ /^--/ ? "=" : "") "[" zsh_text(text[i]) "]" \
                    (value[i] == "" ? "" : ":" zsh_text(value[i]) ":" zsh_action(choices(value[i]), places(value[i]))))
        }
        if (argument[command] == "") print "            && return"
        else printf "            %s && return\n", quoted("*:" zsh_text(argument[command]) ":{" \
            zsh_action_code(named(argument[command]), places(argument[command])) "}")
    }
    function zsh_action_code(words, place) {
        return (words == "" ? "" : "compadd -- " words "; ") (place == "" ? "" : "_files")
    }
    function zsh(    i) {
        print "#compdef " program "\n# zsh completion of " program ", made from its --help.\n_" identifier(program) "() {"
        if (!command_count) { zsh_arguments("-"); print "}\n_" identifier(program) " \"$@\""; return }
        print "    if (( CURRENT == 2 )); then\n        local -a commands\n        commands=("
        for (i = 1; i <= command_count; ++i) printf "            %s\n", quoted(commands[i] ":" zsh_text(about[commands[i]]))
        print "        )\n        _describe command commands"
        zsh_arguments("-")
        print "        return\n    fi\n    local command=$words[2]\n    shift words\n    (( CURRENT-- ))\n    case $command in"
        for (i = 1; i <= command_count; ++i) {
            print "    " commands[i] ")"
            zsh_arguments(commands[i])
            print "        ;;"
        }
        print "    esac\n}\n_" identifier(program) " \"$@\""
    }

    # ---- fish: a line for each option ----

    function fish_quoted(text) { gsub(/\047/, "\\\047", text); return "\047" text "\047" }
    function fish_line(condition, rest) { print "complete -c " program (condition == "" ? "" : " -n " quoted(condition)) " " rest }
    function fish_option(condition, i,    n, words, j, line) {
        n = split(names[i], words, ",")
        for (j = 1; j <= n; ++j) line = line (words[j] ~ /^--/ ? " -l " substr(words[j], 3) : " -s " substr(words[j], 2))
        if (choices(value[i]) != "") line = line (places(value[i]) == "" ? " -x" : " -r -F") " -a " quoted(choices(value[i]))
        else if (places(value[i]) == "folders") line = line " -x -a \047(__fish_complete_directories)\047"
        else if (places(value[i]) == "files") line = line " -r -F"
        else if (value[i] != "") line = line " -x"
        fish_line(condition, substr(line, 2) " -d " fish_quoted(text[i]))
    }
    function fish_argument(condition, owner,    words) {
        words = named(argument[owner])
        if (words != "") fish_line(condition, "-a " quoted(words) " -d " fish_quoted(owner == "check" ? "hard case" : "built-in scene"))
        if (places(argument[owner]) != "") fish_line(condition, "-F")
    }
    function fish(    i, condition) {
        print "# fish completion of " program ", made from its --help.\ncomplete -c " program " -f"
        condition = command_count ? "__fish_use_subcommand" : ""
        for (i = 1; i <= command_count; ++i) fish_line(condition, "-a " commands[i] " -d " fish_quoted(about[commands[i]]))
        for (i = 1; i <= count; ++i)
            fish_option(owner[i] == "-" ? condition : "__fish_seen_subcommand_from " owner[i], i)
        if (!command_count) fish_argument("", "-")
        for (i = 1; i <= command_count; ++i) fish_argument("__fish_seen_subcommand_from " commands[i], commands[i])
    }

    END {
        if (shell == "bash") bash()
        else if (shell == "zsh") zsh()
        else if (shell == "fish") fish()
        else { print "completion.sh: the shells are bash, zsh and fish, not " shell >"/dev/stderr"; exit 2 }
    }'
