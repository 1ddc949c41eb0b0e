# Reads GL's headers after the preprocessor, and writes what entry_points.h declares: a C++ function for each function of GL 1.0 to 4.6. It
# knows functions of extensions by the letters at the end of their names, and leaves them out.
BEGIN { RS = ";" }
{
    gsub(/[[:space:]]+/, " ")
    if (!match($0, /gl[A-Z][A-Za-z0-9]* ?\(.*\) *$/) || /typedef/) next
    result = substr($0, 1, RSTART - 1)
    sub(/^ ?(extern )?/, "", result)
    name = parameters = substr($0, RSTART)
    sub(/ ?\(.*/, "", name)
    if (name ~ /[A-Z][A-Z][A-Z]?$/ && name !~ /(1|2|3)D$/ || name in known) next
    known[name]
    sub(/^[^(]*\( ?/, "", parameters)
    sub(/ ?\) *$/, "", parameters)
    arguments = ""
    count = parameters == "void" ? 0 : split(parameters, list, ",")
    for (i = 1; i <= count; ++i) {
        parameter = list[i]
        sub(/ ?(\[[^]]*\])? *$/, "", parameter)
        sub(/.*[^A-Za-z0-9_]/, "", parameter)
        arguments = arguments (i > 1 ? ", " : "") parameter
    }
    names = names "    {\"" name "\", nullptr},\n"
    functions = functions result name "(" parameters ") { return function<decltype(&::" name ")>(" n++ ")(" arguments "); }\n"
}
END {
    print "#include \"render/context/entry_points.h\"\n\n#include \"render/context/gl.h\"\n"
    print "namespace twinlight {\n\nEntryPoint entry_points[] = {\n" names "};\nconst std::size_t kEntryPoints = " n ";\n"
    print "namespace {\n\ntemplate <class F>\nF function(std::size_t i) {"
    print "    if (!entry_points[i].address) throw_missing_function(entry_points[i]);"
    print "    return reinterpret_cast<F>(entry_points[i].address);\n}\n\n}  // namespace\n\nextern \"C\" {"
    print functions "}\n\n}  // namespace twinlight"
}
