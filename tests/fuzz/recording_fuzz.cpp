// SPDX-License-Identifier: BSD-3-Clause
// Recordings of any bytes: as a whole file, and as what stands in a block whose checksum is right.
#include <xxhash.h>
#include <zstd.h>

#include <cstdint>
#include <sstream>
#include <string>

#include "server/recording/record_reader.h"

namespace {

using namespace k3d::server::recording;

void append_number(std::uint64_t value, int bytes, std::string& out) {
    for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8 * i));
}

void append_block(std::string_view plain, std::string& out) {
    std::string stored(ZSTD_compressBound(plain.size()), '\0');
    stored.resize(ZSTD_compress(stored.data(), stored.size(), plain.data(), plain.size(), 1));
    append_number(stored.size(), 4, out);
    append_number(plain.size(), 4, out);
    append_number(XXH3_64bits(stored.data(), stored.size()), 8, out);
    out += stored;
}

void read(const std::string& bytes) {
    std::istringstream in(bytes);
    try {
        RecordReader reader(in, "fuzz");
        while (reader.next()) {
        }
    } catch (const RecordError&) {
        // What a damaged file is met with.
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    read(std::string(bytes));
    std::string file(kMagic);
    append_block(std::string_view("H\0\0", 3), file);
    append_block(bytes, file);
    read(file);
    return 0;
}
