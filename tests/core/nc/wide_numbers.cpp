// SPDX-License-Identifier: GPL-3.0-or-later
// Loaded into `rs274` before its own libraries: makes it print nine decimals instead of four, and changes
// nothing else.
#include <cstdarg>
#include <cstdio>
#include <string>

#undef fprintf

namespace {

std::string widened(const char* format) {
    std::string wide(format);
    for (const char* const narrow : {"%.4f", "%f"}) {
        const std::string from(narrow);
        for (std::size_t at = 0; (at = wide.find(from, at)) != std::string::npos; at += from.size())
            wide.replace(at, from.size(), "%.9f");
    }
    return wide;
}

} // namespace

extern "C" {

// NOLINTBEGIN(cert-dcl50-cpp,bugprone-reserved-identifier): these are the functions of the C library.
int fprintf(FILE* file, const char* format, ...) {
    va_list values;
    va_start(values, format);
    const int count = vfprintf(file, widened(format).c_str(), values);
    va_end(values);
    return count;
}

int __fprintf_chk(FILE* file, int /*flag*/, const char* format, ...) {
    va_list values;
    va_start(values, format);
    const int count = vfprintf(file, widened(format).c_str(), values);
    va_end(values);
    return count;
}
// NOLINTEND(cert-dcl50-cpp,bugprone-reserved-identifier)
}
