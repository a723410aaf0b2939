// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/png.h"

#include <png.h>
#include <stdexcept>

namespace proveout {

std::string pngOf(const Picture& picture) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.width);
    image.height = static_cast<png_uint_32>(picture.height);
    image.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = 0;
    const void* pixels = picture.pixels.data();
    if (png_image_write_to_memory(&image, nullptr, &size, 0, pixels, 0, nullptr) == 0)
        throw std::runtime_error(image.message);
    std::string bytes(size, '\0');
    if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels, 0, nullptr) == 0)
        throw std::runtime_error(image.message);
    bytes.resize(size);
    return bytes;
}

} // namespace proveout
