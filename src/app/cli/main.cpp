// twinlight: draws OpenGL's lighting commands three ways and shows where the pictures differ.
#include "app/cli/command_line.h"

int main(int argc, char** argv) {
    return twinlight::run_reporting_errors("twinlight", [&] { return twinlight::cli::run(argc, argv); });
}
