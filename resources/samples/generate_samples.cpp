// SPDX-License-Identifier: GPL-3.0-or-later
// generate_samples FOLDER: writes the sample jobs into FOLDER.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "resources/samples/samples.h"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: generate_samples FOLDER\n", stderr);
        return 3;
    }
    for (const proveout::samples::SampleFile& file : proveout::samples::sampleFiles()) {
        const std::filesystem::path path = std::filesystem::path(argv[1]) / file.name;
        std::ofstream out(path, std::ios::binary);
        out << file.text;
        if (!out.flush()) {
            std::fprintf(stderr, "cannot write %s\n", path.c_str());
            return 3;
        }
    }
    return 0;
}
