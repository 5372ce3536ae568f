// Map files keep every value: 65,536 of them in integers and float, a float file's own bits, metadata, other
// channels.
#include "brushes/map_file.h"

#include <OpenImageIO/half.h>
#include <sys/stat.h>

#include <cmath>
#include <cstring>

#include "brushes/atomic_file.h"
#include "chart_surface.h"
#include "image_files.h"

namespace relievo::map_file_test {
namespace {
namespace fs = std::filesystem;

HeightMap all_values() {
    HeightMap map(256, 256);
    for (int i = 0; i < 65536; ++i) map.texels()[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(i);
    return map;
}

template <typename Value>
std::vector<Value> values_of(const Image& image) {
    std::vector<Value> values(image.pixels.size() / sizeof(Value));
    std::memcpy(values.data(), image.pixels.data(), image.pixels.size());
    return values;
}

void sculpt_and_undo(HeightMap& map) {
    const ChartSurface surface(map, {unit_chart(map)}, 0.2f);
    Sculptor sculptor(map, surface);
    Brush brush;
    stroke(sculptor, surface, brush, {0.1, 0.1}, {0.9, 0.9});
    sculptor.undo();
}

TEST(MapFile, all_65536_values_survive_load_stroke_undo_save_reload) {
    const TestFolder folder;
    const HeightMap map = all_values();
    for (const auto& [name, format] : {std::pair{"a.png", MapFormat::png16},
                                       {"a.tif", MapFormat::tiff16},
                                       {"a.exr", MapFormat::exr_float}}) {
        for (const MapRange range : {MapRange{}, MapRange{-3.0, 7.5}}) {
            save_map(map, folder / name, format, range);
            LoadedMap loaded = load_map(folder / name, range);
            EXPECT_EQ(loaded.format, format);
            EXPECT_EQ(loaded.map.hash(), map.hash()) << name;
            sculpt_and_undo(loaded.map);
            save_map(loaded.map, folder / name, format, range, loaded.origin.get());
            EXPECT_EQ(load_map(folder / name, range).map.hash(), map.hash()) << name << " again";
        }
    }
}

TEST(MapFile, any_shape_survives_in_any_format) {
    const TestFolder folder;
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 300}, {300, 1}, {129, 67}})
        for (const std::string name : {"m.png", "m.tiff", "m.EXR"}) {
            HeightMap map(width, height);
            fill(map, [](int x, int y) { return (x * 523 + y * 7877) % 65536; });
            save_map(map, folder / name, format_of(folder / name));
            EXPECT_EQ(load_map(folder / name).map.hash(), map.hash())
                << width << " x " << height << " " << name;
        }
}

TEST(MapFile, row_0_is_the_bottom_of_the_image) {
    const TestFolder folder;
    HeightMap map(2, 3, 0);
    map.set(1, 0, 777);
    save_map(map, folder / "m.png", MapFormat::png16);
    EXPECT_EQ(values_of<std::uint16_t>(read_image(folder / "m.png")),
              (std::vector<std::uint16_t>{0, 0, 0, 0, 0, 777}));
}

TEST(MapFile, eight_bits_widen_by_257_and_are_saved_as_sixteen) {
    const TestFolder folder;
    std::vector<std::uint8_t> bytes(256);
    for (std::size_t i = 0; i < 256; ++i) bytes[i] = static_cast<std::uint8_t>(i);
    for (const std::string name : {"m.png", "m.tif"}) {
        write_image(folder / name, OIIO::ImageSpec(256, 1, 1, OIIO::TypeDesc::UINT8), bytes.data());
        const LoadedMap loaded = load_map(folder / name);
        for (int i = 0; i < 256; ++i) ASSERT_EQ(loaded.map.at(i, 0), i * 257);
        save_map(loaded.map, folder / name, loaded.format, {}, loaded.origin.get());
        EXPECT_EQ(read_image(folder / name).spec.format, OIIO::TypeDesc::UINT16);
        EXPECT_EQ(load_map(folder / name).map.hash(), loaded.map.hash());
    }
}

TEST(MapFile, half_values_that_no_stroke_changed_keep_their_bits) {
    const TestFolder folder;
    std::vector<half> values(64 * 64);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = half(static_cast<float>(i) / 3000.0f - 0.1f);
    OIIO::ImageSpec spec(64, 64, 1, OIIO::TypeDesc::HALF);
    spec.channelnames = {"height.Z"};
    write_image(folder / "m.exr", spec, values.data());
    LoadedMap loaded = load_map(folder / "m.exr");
    EXPECT_EQ(loaded.format, MapFormat::exr_half);
    loaded.map.set(5, 63, 40000);  // the first row of the file
    save_map(loaded.map, folder / "m.exr", loaded.format, {}, loaded.origin.get());

    const Image saved = read_image(folder / "m.exr");
    EXPECT_EQ(saved.spec.channelnames, (std::vector<std::string>{"height.Z"}));
    EXPECT_EQ(saved.spec.format, OIIO::TypeDesc::HALF);
    const auto after = values_of<half>(saved);
    values[5] = half(40000.0f / 65535.0f);
    for (std::size_t i = 0; i < values.size(); ++i) ASSERT_EQ(after[i].bits(), values[i].bits()) << i;
    save_map(loaded.map, folder / "wide.exr", MapFormat::exr_float, {}, loaded.origin.get());
    EXPECT_EQ(values_of<float>(read_image(folder / "wide.exr"))[7], static_cast<float>(values[7]));
}

TEST(MapFile, float_values_outside_the_range_come_back_unless_changed) {
    const TestFolder folder;
    const std::vector<float> values{-5.0f, 0.1234567f, 9.75f, 3e-41f};
    write_image(folder / "m.exr", OIIO::ImageSpec(4, 1, 1, OIIO::TypeDesc::FLOAT), values.data());
    const LoadedMap loaded = load_map(folder / "m.exr", {0.0, 2.0});
    EXPECT_EQ(loaded.map.at(0, 0), 0);
    EXPECT_EQ(loaded.map.at(2, 0), 65535);
    EXPECT_EQ(loaded.map.at(1, 0), std::lround(0.1234567 / 2 * 65535));
    save_map(loaded.map, folder / "n.exr", loaded.format, loaded.range, loaded.origin.get());
    EXPECT_EQ(values_of<float>(read_image(folder / "n.exr")), values);
}

TEST(MapFile, other_exr_channels_stay_in_their_own_types) {
    const TestFolder folder;
    OIIO::ImageSpec spec(8, 8, 3, OIIO::TypeDesc::FLOAT);
    spec.channelformats = {OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::HALF, OIIO::TypeDesc::UINT32};
    spec.channelnames = {"R", "mask", "object"};
    std::vector<char> pixels(64 * 10);
    for (std::size_t i = 0; i < 64; ++i) {
        const float height = static_cast<float>(i) / 100;
        const half mask(i % 2 ? NAN : 0.25f);
        const std::uint32_t object = 4000000001u + static_cast<std::uint32_t>(i);
        std::memcpy(&pixels[10 * i], &height, 4);
        std::memcpy(&pixels[10 * i + 4], &mask, 2);
        std::memcpy(&pixels[10 * i + 6], &object, 4);
    }
    write_image(folder / "m.exr", spec, pixels.data());
    const Image before = read_image(folder / "m.exr");
    const LoadedMap loaded = load_map(folder / "m.exr");
    save_map(loaded.map, folder / "m.exr", loaded.format, {}, loaded.origin.get());
    const Image after = read_image(folder / "m.exr");
    EXPECT_EQ(after.pixels, before.pixels);
    EXPECT_EQ(after.spec.channelnames, before.spec.channelnames);
}

TEST(MapFile, grey_stored_as_rgb_stays_grey_and_alpha_stays_as_it_was) {
    const TestFolder folder;
    for (const std::string name : {"m.png", "m.tif"}) {
        OIIO::ImageSpec spec(16, 1, 4, OIIO::TypeDesc::UINT16);
        spec.attribute("oiio:UnassociatedAlpha", 1);
        std::vector<std::uint16_t> pixels;
        for (std::uint16_t x = 0; x < 16; ++x) {
            const auto grey = static_cast<std::uint16_t>(60001 - 1237 * x);
            const auto alpha = static_cast<std::uint16_t>(x * 17);  // almost transparent
            pixels.insert(pixels.end(), {grey, grey, grey, alpha});
        }
        write_image(folder / name, spec, pixels.data());
        LoadedMap loaded = load_map(folder / name);
        loaded.map.set(3, 0, 12345);
        save_map(loaded.map, folder / name, loaded.format, {}, loaded.origin.get());
        for (const std::size_t channel : {0u, 1u, 2u}) pixels[3 * 4 + channel] = 12345;
        EXPECT_EQ(values_of<std::uint16_t>(read_image(folder / name)), pixels) << name;
    }
}

TEST(MapFile, channels_that_differ_are_kept_as_they_were) {
    const TestFolder folder;
    std::vector<std::uint16_t> pixels;
    for (std::uint16_t i = 0; i < 64 * 3; ++i) pixels.push_back(static_cast<std::uint16_t>(i * 331));
    write_image(folder / "m.tif", OIIO::ImageSpec(8, 8, 3, OIIO::TypeDesc::UINT16), pixels.data());
    LoadedMap loaded = load_map(folder / "m.tif");
    loaded.map.set(0, 7, 5);
    save_map(loaded.map, folder / "m.tif", loaded.format, {}, loaded.origin.get());
    pixels[0] = 5;
    EXPECT_EQ(values_of<std::uint16_t>(read_image(folder / "m.tif")), pixels);
}

TEST(MapFile, metadata_is_kept) {
    const TestFolder folder;
    const std::vector<std::uint16_t> pixels(64, 1000);
    const std::vector<std::uint8_t> profile(300, 42);
    for (const std::string name : {"m.png", "m.tif", "m.exr"}) {
        OIIO::ImageSpec spec(8, 8, 1, name == "m.exr" ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT16);
        spec.attribute("ImageDescription", "bark, third try");
        spec.attribute("Artist", "someone");
        spec.attribute("XResolution", 300.0f);
        spec.attribute("YResolution", 300.0f);
        spec.attribute("ResolutionUnit", "in");
        if (name == "m.tif")
            spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, 300), profile.data());
        write_image(folder / name, spec, pixels.data());
        const OIIO::ImageSpec before = read_image(folder / name).spec;
        const LoadedMap loaded = load_map(folder / name);
        save_map(loaded.map, folder / name, loaded.format, {}, loaded.origin.get());
        const OIIO::ImageSpec after = read_image(folder / name).spec;
        EXPECT_EQ(after.get_string_attribute("ImageDescription"), "bark, third try") << name;
        for (const OIIO::ParamValue& attribute : before.extra_attribs) {
            if (attribute.name() == "oiio:BitsPerSample" || attribute.name() == "tiff:RowsPerStrip") continue;
            const OIIO::ParamValue* kept = after.find_attribute(attribute.name());
            ASSERT_TRUE(kept) << name << " lost " << attribute.name();
            EXPECT_EQ(kept->get_string(), attribute.get_string()) << name << ", " << attribute.name();
        }
        const std::string other = name == "m.png" ? "other.tif" : "other.png";
        save_map(loaded.map, folder / other, format_of(other), {}, loaded.origin.get());
        EXPECT_EQ(read_image(folder / other).spec.get_string_attribute("ImageDescription"),
                  "bark, third try");
        EXPECT_EQ(load_map(folder / other).map.hash(), loaded.map.hash());
    }
}

std::vector<std::string> png_chunks(const fs::path& path) {
    const std::string bytes = bytes_of(path);
    std::vector<std::string> types;
    for (std::size_t at = 8; at + 12 <= bytes.size();) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length = length * 256 + static_cast<unsigned char>(bytes[at + i]);
        types.push_back(bytes.substr(at + 4, 4));
        at += 12 + length;
    }
    return types;
}

TEST(MapFile, png_gains_and_loses_no_colour_space) {
    const TestFolder folder;
    const std::vector<std::uint16_t> pixels(64, 1000);
    for (const std::string space : {"", "sRGB", "Linear"}) {
        OIIO::ImageSpec spec(8, 8, 1, OIIO::TypeDesc::UINT16);
        if (!space.empty()) spec.attribute("oiio:ColorSpace", space);
        write_image(folder / "m.png", spec, pixels.data());
        const auto before = png_chunks(folder / "m.png");
        const LoadedMap loaded = load_map(folder / "m.png");
        save_map(loaded.map, folder / "m.png", loaded.format, {}, loaded.origin.get());
        EXPECT_EQ(png_chunks(folder / "m.png"), before) << space;
    }
}

TEST(MapFile, lossy_and_tiled_files_are_saved_lossless) {
    const TestFolder folder;
    std::vector<float> values(128 * 128);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::abs(std::sin(static_cast<float>(i)));
    for (const std::string compression : {"dwaa", "b44", "pxr24", "none", "piz"}) {
        OIIO::ImageSpec spec(128, 128, 1, OIIO::TypeDesc::FLOAT);
        spec.attribute("compression", compression);
        if (compression == "piz") spec.tile_width = spec.tile_height = 64;
        write_image(folder / "m.exr", spec, values.data());
        const Image before = read_image(folder / "m.exr");
        const LoadedMap loaded = load_map(folder / "m.exr");
        save_map(loaded.map, folder / "m.exr", loaded.format, {}, loaded.origin.get());
        EXPECT_EQ(read_image(folder / "m.exr").pixels, before.pixels) << compression;
    }
}

TEST(MapFile, a_save_tells_how_far_it_is_and_can_be_stopped) {
    const TestFolder folder;
    HeightMap map(70, 300);
    for (const std::string name : {"a.png", "a.tif", "a.exr"}) {
        std::vector<double> parts;
        save_map(map, folder / name, format_of(name), {}, nullptr, [&](double part) {
            parts.push_back(part);
            return true;
        });
        EXPECT_GT(parts.size(), 3u) << name;
        EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end())) << name;
        EXPECT_GE(parts.front(), 0.0) << name;
        EXPECT_LT(parts.back(), 1.0) << name;

        const std::string before = bytes_of(folder / name);
        map.set(3, 4, 4711);
        int asked = 0;
        const Advance stop = [&](double) { return ++asked < 3; };
        EXPECT_THROW(save_map(map, folder / name, format_of(name), {}, nullptr, stop), Stopped) << name;
        EXPECT_EQ(asked, 3) << name;
        EXPECT_EQ(bytes_of(folder / name), before) << name;
        map.set(3, 4, 0);
    }
    EXPECT_EQ(folder.names().size(), 3u) << "nothing else is left";
}

TEST(MapFile, the_disk_tells_how_far_it_is_and_can_be_stopped) {
    const TestFolder folder;
    const std::vector<std::byte> content(std::size_t{20} << 20, std::byte{7}), old(3, std::byte{1});
    for (const bool replaces : {false, true}) {
        const fs::path path = folder / "m.tif";
        if (replaces) write_file_atomically(path, old);
        std::vector<double> parts;
        const auto write = [&](std::size_t last) {
            parts.clear();
            write_file_atomically(path, content, [&](double part) {
                parts.push_back(part);
                return parts.size() < last;
            });
        };
        for (std::size_t last = 1; last <= 3; ++last) {
            EXPECT_THROW(write(last), Stopped);
            EXPECT_EQ(fs::exists(path), replaces);
            EXPECT_TRUE(!replaces || fs::file_size(path) == old.size());
            EXPECT_EQ(folder.names().size(), replaces ? 1u : 0u);
        }
        write(4);
        EXPECT_EQ(parts, (std::vector<double>{0, 0.4, 0.8}));
        EXPECT_EQ(fs::file_size(path), content.size());
        fs::remove(path);
    }
}

TEST(MapFile, symbolic_links_and_permissions_stay) {
    const TestFolder folder;
    const HeightMap map(4, 4, 5);
    save_map(HeightMap(4, 4, 1), folder / "real.png", MapFormat::png16);
    fs::permissions(folder / "real.png", fs::perms(0640));
    fs::create_symlink("real.png", folder / "link.png");
    save_map(map, folder / "link.png", MapFormat::png16);
    EXPECT_TRUE(fs::is_symlink(folder / "link.png"));
    EXPECT_FALSE(fs::is_symlink(folder / "real.png"));
    EXPECT_EQ(load_map(folder / "real.png").map.at(0, 0), 5);
    EXPECT_EQ(fs::status(folder / "real.png").permissions(), fs::perms(0640));
    EXPECT_EQ(folder.names().size(), 2u);

    save_map(map, folder / "new.png", MapFormat::png16);
    const mode_t mask = ::umask(0);
    ::umask(mask);
    EXPECT_EQ(fs::status(folder / "new.png").permissions(), fs::perms(0666 & ~mask));
}

TEST(MapFile, extensions_name_formats) {
    EXPECT_EQ(format_of("a.PNG"), MapFormat::png16);
    EXPECT_EQ(format_of("a.Tif"), MapFormat::tiff16);
    EXPECT_EQ(format_of("a.tiff"), MapFormat::tiff16);
    EXPECT_EQ(format_of("a.exr"), MapFormat::exr_float);
    EXPECT_THROW(format_of("a.jpg"), std::invalid_argument);
    EXPECT_THROW(format_of("a"), std::invalid_argument);
}

}  // namespace
}  // namespace relievo::map_file_test
