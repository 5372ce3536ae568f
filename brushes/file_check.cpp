// PNG chunks by their lengths and checksums (PNG specification, section 5 and annex D).
#include "brushes/file_check.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <span>
#include <string_view>
#include <vector>

namespace relievo {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPngMagic{"\x89PNG\r\n\x1a\n", 8};

constexpr std::array<std::uint32_t, 256> crc_table() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        table[byte] = byte;
        for (int bit = 0; bit < 8; ++bit)
            table[byte] = (table[byte] >> 1) ^ (table[byte] & 1 ? 0xedb88320u : 0u);
    }
    return table;
}

std::uint32_t crc_of(std::span<const unsigned char> bytes) {
    static constexpr std::array<std::uint32_t, 256> kTable = crc_table();
    std::uint32_t crc = 0xffffffffu;
    for (const unsigned char byte : bytes) crc = (crc >> 8) ^ kTable[(crc ^ byte) & 0xff];
    return ~crc;
}

std::uint32_t big_endian(std::span<const unsigned char> bytes) {
    return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[2]} << 8 |
           bytes[3];
}

bool read_exactly(std::istream& file, std::span<unsigned char> bytes) {
    return static_cast<bool>(
        file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())));
}

}  // namespace

PngCheck check_png(const fs::path& path) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    std::ifstream file(path, std::ios::binary);
    std::array<unsigned char, 8> magic{};
    if (error || !read_exactly(file, magic) || std::memcmp(magic.data(), kPngMagic.data(), magic.size()) != 0)
        return {};

    PngCheck check;
    std::uintmax_t position = magic.size();
    std::vector<unsigned char> chunk;  // type, body, checksum
    for (;;) {
        std::array<unsigned char, 4> length_bytes;
        if (!read_exactly(file, length_bytes)) return {"the file ends before its end mark"};
        const std::size_t length = big_endian(length_bytes);
        position += 12 + length;
        if (position > size) return {"the file ends inside a chunk"};
        chunk.resize(8 + length);
        if (!read_exactly(file, chunk)) return {"the file ends inside a chunk"};
        const std::span<const unsigned char> all(chunk);
        if (crc_of(all.first(4 + length)) != big_endian(all.last(4))) return {"a chunk has a wrong checksum"};
        const std::string_view type(reinterpret_cast<const char*>(chunk.data()), 4);
        if (type == "sRGB" || type == "gAMA" || type == "iCCP" || type == "cICP") check.states_colour = true;
        if (type == "IEND") return check;
    }
}

}  // namespace relievo
