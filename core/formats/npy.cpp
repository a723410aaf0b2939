// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/npy.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <limits>
#include <string_view>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/figures_argument.h"
#include "core/base/memory.h"
#include "core/formats/array_findings.h"
#include "core/formats/npy_header.h"

namespace proveout {

namespace {

static_assert(std::endian::native == std::endian::little, "NPY values are copied as they lie in memory");

std::string shapeText(const std::vector<std::uint64_t>& shape) {
    return fmt::format("({}{})", fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
}

/// Checks that this program supports the header, and returns how many values there must be.
Result<std::size_t> checkHeader(const NpyHeader& header, std::size_t bytes) {
    if (header.type != "<f4" && header.type != "<f8")
        return failure(array_finding::kNpyType, {header.type});
    if (header.fortranOrder)
        return failure(array_finding::kNpyOrder);
    const auto& shape = header.shape;
    if (shape.size() != 2 || shape[0] == 0 || shape[1] == 0)
        return failure(array_finding::kNpyShape, {shapeText(shape)});
    const std::size_t size = header.type == "<f4" ? sizeof(float) : sizeof(double);
    const std::size_t present = (bytes - header.dataStart) / size;
    // In double, because the product of two hostile numbers may not fit 64 bits.
    const double wanted = static_cast<double>(shape[0]) * static_cast<double>(shape[1]);
    if (wanted > static_cast<double>(present))
        return failure(array_finding::kNpyCutOff,
                       {shapeText(shape), figures("{}", readableBytes(wanted * static_cast<double>(size))),
                        std::to_string(present)});
    if (std::max(shape[0], shape[1]) > static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
        return failure(array_finding::kNpyShapeLarge, {shapeText(shape)});
    return static_cast<std::size_t>(shape[0] * shape[1]);
}

template<class Value>
void copyValues(const char* from, std::vector<double>& values) {
    for (double& value : values) {
        Value raw;
        std::memcpy(&raw, from, sizeof raw);
        value = static_cast<double>(raw);
        from += sizeof raw;
    }
}

Result<void> checkValues(const NpyArray& array) {
    const auto wrong = std::find_if(array.values.begin(), array.values.end(), [](double value) {
        return !(std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max()));
    });
    if (wrong == array.values.end())
        return {};
    const auto index = wrong - array.values.begin();
    return failure(array_finding::kNpyValue, {std::to_string(index / array.columns),
                                              std::to_string(index % array.columns), figures("{}", *wrong)});
}

Result<NpyArray> parse(std::string_view bytes) {
    const auto header = readNpyHeader(bytes);
    if (!header)
        return tl::unexpected(header.error());
    const auto count = checkHeader(*header, bytes.size());
    if (!count)
        return tl::unexpected(count.error());
    NpyArray array;
    array.rows = static_cast<int>(header->shape[0]);
    array.columns = static_cast<int>(header->shape[1]);
    array.values.resize(*count);
    if (header->type == "<f4")
        copyValues<float>(bytes.data() + header->dataStart, array.values);
    else
        copyValues<double>(bytes.data() + header->dataStart, array.values);
    if (auto good = checkValues(array); !good)
        return tl::unexpected(std::move(good.error()));
    return array;
}

} // namespace

Result<NpyArray> readNpy(const std::filesystem::path& file) {
    const auto bytes = readFile(file);
    if (!bytes)
        return tl::unexpected(bytes.error());
    auto array = parse(*bytes);
    if (!array) {
        for (auto& diagnostic : array.error())
            diagnostic.file = file.string();
    }
    return array;
}

namespace {

template<class Value>
Result<void> writeRows(const std::filesystem::path& file, int rows, int columns, std::string_view type,
                       const std::function<void(int, std::span<Value>)>& fill) {
    std::vector<Value> row(static_cast<std::size_t>(columns));
    const std::string header = npyHeader(rows, columns, type);
    const std::size_t rowBytes = row.size() * sizeof(Value);
    AtomicFile out(file, header.size() + static_cast<std::uint64_t>(rows) * rowBytes);
    out.write(header);
    for (int j = 0; j < rows && !out.failed(); ++j) {
        fill(j, row);
        out.write(row.data(), rowBytes);
    }
    return out.commit();
}

} // namespace

Result<void> writeNpy(const std::filesystem::path& file, int rows, int columns,
                      const std::function<void(int, std::span<float>)>& fill) {
    return writeRows<float>(file, rows, columns, "<f4", fill);
}

Result<void> writeNpy(const std::filesystem::path& file, int rows, int columns,
                      const std::function<void(int, std::span<std::uint32_t>)>& fill) {
    return writeRows<std::uint32_t>(file, rows, columns, "<u4", fill);
}

Result<void> writeNpy(const std::filesystem::path& file, const NpyArray& array) {
    assert(array.values.size() ==
           static_cast<std::size_t>(array.rows) * static_cast<std::size_t>(array.columns));
    return writeNpy(file, array.rows, array.columns, [&array](int j, std::span<float> row) {
        const double* from = array.values.data() + static_cast<std::size_t>(j) * row.size();
        std::transform(from, from + row.size(), row.begin(),
                       [](double value) { return static_cast<float>(value); });
    });
}

} // namespace proveout
